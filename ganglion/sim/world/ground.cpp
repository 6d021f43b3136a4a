#include "ganglion/sim/world/ground.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/text.h"

namespace ganglion::sim {
namespace {

void add_outline(const std::vector<Vector2>& points, bool closed, std::uint32_t traits, SurfaceSet& set) {
  const std::size_t count = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < count; ++i) set.segments.push_back({points[i], points[(i + 1) % points.size()], traits});
}

void add_shape(const Shape& shape, SurfaceSet& set) {
  const auto traits = static_cast<std::uint32_t>(set.traits.size());
  set.traits.push_back({shape.material, shape.structural, shape.kind != ShapeKind::Wall});
  if (shape.kind == ShapeKind::Disc) {
    set.rounds.push_back({shape.disc, traits});
    return;
  }
  const auto first = static_cast<std::uint32_t>(set.segments.size());
  add_outline(shape.points, shape.closed || shape.kind != ShapeKind::Wall, traits, set);
  const auto count = static_cast<std::uint32_t>(set.segments.size()) - first;
  if (shape.kind != ShapeKind::Wall) set.outlines.push_back({first, count});
}

SurfaceSet surfaces_of(const GroundPlan& plan) {
  SurfaceSet set;
  if (plan.map) {
    set.traits.push_back({plan.material, true, true});
    for (const auto& [from, to] : plan.map->borders(kMaxSegments)) set.segments.push_back({from, to, 0});
  }
  for (const Shape& shape : plan.shapes) add_shape(shape, set);
  return set;
}

Box2 bounds_of(const GroundPlan& plan, const SurfaceSet& set) {
  if (plan.area) return *plan.area;
  if (plan.map) return plan.map->bounds();
  Box2 box = empty_box();
  for (const Segment& segment : set.segments) {
    box.include(segment.from);
    box.include(segment.to);
  }
  for (const RoundSurface& round : set.rounds) {
    const Vector2 reach{round.disc.radius_m, round.disc.radius_m};
    box.include(round.disc.position - reach);
    box.include(round.disc.position + reach);
  }
  for (const FloorZone& zone : plan.floor.zones) {
    box.include(zone.box.lower);
    box.include(zone.box.upper);
  }
  for (const Beacon& beacon : plan.beacons) box.include(beacon.position);
  for (const Spawn& spawn : plan.spawns) box.include(spawn.pose.position);
  for (const MoverPlan& mover : plan.movers) {
    for (const Pose2& place : mover.places) box.include(place.position);
    for (const Vector2 point : mover.path) box.include(point);
    if (!mover.stroll) continue;
    box.include(mover.stroll->start);
    box.include(mover.stroll->area.lower);
    box.include(mover.stroll->area.upper);
  }
  if (set.segments.empty() && set.rounds.empty()) {  // open ground: a field of 20 m round where things start
    if (box.lower.x > box.upper.x) box.include({0, 0});
    box.include(box.lower - Vector2{10, 10});
    box.include(box.upper + Vector2{10, 10});
  }
  return box;
}

void check_limit(const GroundPlan& plan, std::size_t count, std::size_t limit, const Text& what, Problems& problems) {
  if (count > limit)
    problems.add(plan.place, ErrorCode::TooLarge, {"has {} {}; the limit is {}", "tiene {} {}; el límite es {}"}, count,
                 what, limit);
}

/// One that begins in a wall would find no way out, and stand there for ever. Of a box only what lies within its middle
/// disc is looked at: with its corners in a wall it can still turn to ways that lead off.
void check_strollers(const Ground& ground, Problems& problems) {
  constexpr double kTouching_m = 1e-9;
  for (const MoverPlan& mover : ground.movers()) {
    if (!mover.stroll) continue;
    double radius_m = mover.radius_m;
    for (const Vector2 corner : mover.outline)
      radius_m = std::min({radius_m, std::fabs(corner.x), std::fabs(corner.y)});
    const Vector2 start = mover.stroll->start;
    if (!ground.inside_solid(start) && ground.clearance(start, radius_m) >= radius_m - kTouching_m) continue;
    problems.add(mover.place, ErrorCode::BadParameter,
                 {"mover \"{}\" begins at ({}, {}) in a wall or something solid: it could not stroll from there",
                  "el obstáculo móvil \"{}\" empieza en ({}, {}) dentro de una pared o de algo sólido: no podría salir "
                  "de ahí"},
                 mover.id, shortest(start.x), shortest(start.y));
  }
}

tl::unexpected<Error> first_of(const Problems& problems) { return tl::unexpected<Error>(problems.sorted().front()); }

}  // namespace

Ground::Ground(GroundPlan plan, const Box2& bounds, SurfaceGrid surfaces)
    : plan_(std::move(plan)), bounds_(bounds), surfaces_(std::move(surfaces)) {}

Result<Ground> Ground::load(FileReader& files, int file, Problems& problems,
                            std::span<const config::Override> overrides) {
  return make(load_plan(files, file, overrides, problems), problems);
}

Result<Ground> Ground::load(const std::filesystem::path& path, Problems& problems,
                            std::span<const config::Override> overrides) {
  DiskFiles files;
  const auto file = files.open("world", path.string(), -1, config::kMaxBytes);
  if (file) return load(files, *file, problems, overrides);
  problems.add(file.error());
  return first_of(problems);
}

Result<Ground> Ground::parse(std::string_view text, const std::string& file_name, Problems& problems) {
  DiskFiles files;
  const int file = files.hold("world", file_name, std::string(text));
  return make(load_plan(files, file, {}, problems), problems);
}

Result<Ground> Ground::make(GroundPlan plan, Problems& problems) {
  if (!problems.empty()) return first_of(problems);
  SurfaceSet set = surfaces_of(plan);
  check_limit(plan, set.segments.size(), kMaxSegments, {"straight pieces of surface", "tramos rectos de superficie"},
              problems);
  check_limit(plan, set.rounds.size(), kMaxDiscs, {"discs", "discos"}, problems);
  check_limit(plan, plan.movers.size(), kMaxMovers, {"movers", "obstáculos móviles"}, problems);
  check_limit(plan, plan.spawns.size(), kMaxSpawns, {"spawns", "puntos de salida"}, problems);
  check_limit(plan, plan.floor.zones.size(), kMaxFloorItems, {"zones of floor", "zonas de suelo"}, problems);
  check_limit(plan, plan.floor.bumps.size(), kMaxFloorItems, {"straight pieces of bumps", "tramos rectos de resaltos"},
              problems);
  check_limit(plan, plan.beacons.size(), kMaxBeacons, {"beacons", "balizas"}, problems);
  if (!problems.empty()) return first_of(problems);
  const Box2 bounds = bounds_of(plan, set);
  Ground ground(std::move(plan), bounds, SurfaceGrid(std::move(set)));
  for (const Spawn& spawn : ground.spawns()) {
    if (!ground.inside_solid(spawn.pose.position)) continue;
    problems.add(spawn.place, ErrorCode::BadParameter,
                 {"spawn \"{}\" at ({}, {}) lies inside a solid (a box, disc or polygon, or map cells not known free)",
                  "el punto de salida \"{}\" en ({}, {}) está dentro de algo sólido (una caja, un disco o un polígono, "
                  "o celdas del mapa que no constan como libres)"},
                 spawn.id, shortest(spawn.pose.position.x), shortest(spawn.pose.position.y));
  }
  check_strollers(ground, problems);
  if (!problems.empty()) return first_of(problems);
  return ground;
}

const Spawn* Ground::spawn(std::string_view id) const noexcept {
  for (const Spawn& spawn : plan_.spawns) {
    if (spawn.id == id) return &spawn;
  }
  return nullptr;
}

bool Ground::inside_solid(Vector2 point) const noexcept {
  if (plan_.map && plan_.map->at(point) != Occupancy::Free) return true;
  return surfaces_.inside_solid(point);
}

std::optional<Hit> Ground::cast(Vector2 from, Vector2 unit_direction, double max_range_m) const noexcept {
  const auto found = surfaces_.cast(from, unit_direction, max_range_m);
  return found ? std::optional(hit({from, unit_direction}, *found)) : std::nullopt;
}

Hit Ground::hit(const Ray& ray, const SurfaceGrid::Found& found) const noexcept {
  const SurfaceTraits& traits = surfaces_.traits(found.traits);
  // A ray that just brushes a corner may meet the far edge first by rounding, so "from behind" alone proves nothing.
  if (found.from_behind && traits.solid && inside_solid(ray.from)) return {0, -ray.direction, traits.material};
  return {found.range_m, found.normal, traits.material};
}

Hit Ground::hit(const Ray& ray, std::uint32_t item, double range_m) const noexcept {
  if (item >= surfaces_.set().segments.size()) return hit(ray, surfaces_.found(ray, item, range_m));
  const SurfaceGrid::Face& face = surfaces_.face(item);
  if (face.solid && face.along.cross(ray.direction) < 0 && inside_solid(ray.from)) {
    return {0, -ray.direction, face.material};
  }
  return {range_m, normal_towards(ray, face.normal), face.material};
}

std::shared_ptr<const NearSurfaces> Ground::near_surfaces(double reach_m, double spread_m) const {
  return findings_->get<NearSurfaces>(reach_m, spread_m, [&] { return NearSurfaces(surfaces_, reach_m, spread_m); });
}

double Ground::far_wall_m(Vector2 from, Vector2 unit_direction) const noexcept {
  const auto found = surfaces_.cast(from, unit_direction, kNoHit, true);
  return found ? found->range_m : kNoHit;
}

double Ground::clearance(Vector2 point, double up_to_m) const noexcept {
  const double distance = surfaces_.distance(point, up_to_m);
  return inside_solid(point) ? -distance : distance;
}

void Ground::sweep(Vector2 from, Vector2 displacement, double radius_m, Contact& first) const noexcept {
  const Vector2 reach{radius_m, radius_m};
  Box2 box{from, from};
  box.include(from + displacement);
  surfaces_.visit(
      {box.lower - reach, box.upper + reach},
      [&](const Segment& s) { sweep_segment(from, displacement, radius_m, s.from, s.to, first); },
      [&](const RoundSurface& r) { sweep_disc(from, displacement, radius_m, r.disc, first); });
}

}  // namespace ganglion::sim
