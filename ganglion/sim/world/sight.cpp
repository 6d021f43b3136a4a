#include "ganglion/sim/world/sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ganglion/base/expects.h"

namespace ganglion::sim {
namespace {

constexpr double kTolerance_m = 1e-4;  // mirrored rays begin a little off the surface
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Sight::Sight(const std::shared_ptr<const Ground>& ground, double reach_m, double spread_m, std::size_t robots,
             const Lanes& lanes)
    : ground_(ground),
      near_(ground->near_surfaces(reach_m + kTolerance_m, spread_m)),
      lanes_(&lanes),
      covered_m_(reach_m + spread_m + kTolerance_m),
      segments_(NearSurfaces::kMaxListed + kLanePadding),
      rounds_(NearSurfaces::kMaxListed + kLanePadding),
      others_(robots + kLanePadding),
      item_(NearSurfaces::kMaxListed),
      round_item_(NearSurfaces::kMaxListed),
      chosen_(std::max(segments_.a.size(), others_.a.size())) {
  expects(static_cast<double>(others_.a.size()) < kWalked - kOthers);
  for (std::size_t n = 0; n < segments_.name.size(); ++n) segments_.name[n] = static_cast<double>(n);
  for (std::size_t n = 0; n < rounds_.name.size(); ++n) rounds_.name[n] = kRounds + static_cast<double>(n);
  for (std::size_t n = 0; n < others_.name.size(); ++n) others_.name[n] = kOthers + static_cast<double>(n);
}

void Sight::look(const World& world, Vector2 centre, std::span<const Disc> others) noexcept {
  world_ = &world;
  centre_ = centre;
  segments_.count = rounds_.count = 0;
  put_others(others);
  const NearSurfaces::List list = near_->at(centre);
  listed_ = list.listed;
  averted_ = {};
  if (!listed_) return;
  add_segments(list.facing);
  facing_ = segments_.count;
  averted_ = list.averted;
  const SurfaceSet& set = ground_->surfaces().set();
  for (const std::uint32_t item : list.rounds) {
    const std::size_t n = rounds_.count++;
    const Disc& disc = set.rounds[item - set.segments.size()].disc;
    rounds_.a[n] = disc.position.x;
    rounds_.b[n] = disc.position.y;
    rounds_.c[n] = disc.radius_m;
    round_item_[n] = item;
  }
  for (std::size_t n = rounds_.count; n < padded(rounds_.count); ++n) rounds_.c[n] = kNaN;
}

void Sight::add_segments(std::span<const std::uint32_t> items) noexcept {
  const Segment* all = ground_->surfaces().set().segments.data();
  double *a = segments_.a.data(), *b = segments_.b.data(), *c = segments_.c.data(), *d = segments_.d.data();
  std::copy(items.begin(), items.end(), item_.begin() + static_cast<std::ptrdiff_t>(segments_.count));
  std::size_t n = segments_.count;
  for (const std::uint32_t item : items) {
    const Segment& segment = all[item];
    a[n] = segment.from.x;
    b[n] = segment.from.y;
    c[n] = segment.to.x;
    d[n++] = segment.to.y;
  }
  segments_.count = n;
  for (; n < padded(segments_.count); ++n) a[n] = b[n] = c[n] = d[n] = 0;
}

void Sight::put_others(std::span<const Disc> others) noexcept {
  double *x = others_.a.data(), *y = others_.b.data(), *radius = others_.c.data();
  others_.count = others.size();
  for (std::size_t n = 0; n < others.size(); ++n) {
    x[n] = others[n].position.x;
    y[n] = others[n].position.y;
    radius[n] = others[n].radius_m;
  }
  for (std::size_t n = others.size(); n < padded(others.size()); ++n) others_.c[n] = kNaN;
}

SegmentColumns Sight::segments(std::size_t count) const noexcept {
  return {segments_.a.data(), segments_.b.data(), segments_.c.data(), segments_.d.data(), segments_.name.data(), count};
}

CircleColumns Sight::circles(const Columns& columns) const noexcept {
  return {columns.a.data(), columns.b.data(), columns.c.data(), columns.name.data(), columns.count};
}

bool Sight::covers(Vector2 from, double range_m) const noexcept {
  const double left_m = covered_m_ - range_m;
  return left_m >= 0 && (from - centre_).squared() <= left_m * left_m;
}

/// Where there are no lists each ray walks through the surface grid.
void Sight::walk(const RayColumns& rays, Hit* hits) const noexcept {
  for (std::size_t n = 0; n < rays.count; ++n) {
    const auto hit = ground_->cast({rays.from_x[n], rays.from_y[n]}, {rays.along_x[n], rays.along_y[n]},
                                   std::nextafter(rays.range_m[n], 0));
    if (!hit) continue;
    hits[n] = *hit;
    rays.range_m[n] = hit->range_m;
    rays.name[n] = kWalked;
  }
}

void Sight::meet(const RayColumns& rays) const noexcept {
  if (listed_) lanes_->meet_segments(rays, segments(facing_));
  if (listed_ && rounds_.count > 0) lanes_->meet_circles(rays, circles(rounds_), Within::Seen);
  if (others_.count > 0) lanes_->meet_circles(rays, circles(others_), Within::Unseen);
}

void Sight::meet(const RayColumns& rays, const Wedge& wedge) noexcept {
  std::uint32_t* chosen = chosen_.data();
  if (listed_) {
    const SegmentColumns straight = segments(facing_);
    lanes_->meet_chosen_segments(rays, straight, {chosen, lanes_->choose_segments(wedge, straight, chosen)});
  }
  if (listed_ && rounds_.count > 0) {
    const CircleColumns round = circles(rounds_);
    lanes_->meet_chosen_circles(rays, round, Within::Seen, {chosen, lanes_->choose_circles(wedge, round, chosen)});
  }
  if (others_.count == 0) return;
  const CircleColumns others = circles(others_);
  lanes_->meet_chosen_circles(rays, others, Within::Unseen, {chosen, lanes_->choose_circles(wedge, others, chosen)});
}

void Sight::cast(RayFan& fan, std::size_t number, Vector2 position, Vector2 ahead) noexcept {
  const RayFan::Group& group = fan.groups_[number];
  const RayColumns rays = fan.columns(group);
  Hit* hits = &fan.hits_[group.first];
  lanes_->aim(fan.aims(group), {position.x, position.y, ahead.x, ahead.y}, rays);
  if (!listed_) walk(rays, hits);
  group.wedge ? meet(rays, fan.wedge(group)) : meet(rays);
  if (world_->movers().empty()) return;
  for (std::size_t n = 0; n < group.count; ++n) {
    hits[n] = seen(fan.ray(group.first + n), rays.range_m[n], rays.name[n], hits[n]);
    rays.range_m[n] = hits[n].range_m;
    rays.name[n] = kWalked;
  }
}

Hit Sight::hit(const RayFan& fan, std::size_t place) const noexcept {
  return fixed_hit(fan.ray(place), fan.range_m_[place], fan.name_[place], fan.hits_[place]);
}

Hit Sight::cast(const Ray& ray, double max_range_m) noexcept {
  double from_x = ray.from.x, from_y = ray.from.y, along_x = ray.direction.x, along_y = ray.direction.y;
  double range_m = max_range_m > 0 ? next_above(max_range_m) : 0, name = -1;
  const RayColumns rays{&from_x, &from_y, &along_x, &along_y, &range_m, &name, 1};
  Hit walked;
  if (listed_) {
    if (!averted_.empty()) add_segments(averted_);
    averted_ = {};
    lanes_->meet_segments_alone(rays, segments(segments_.count));
    if (rounds_.count > 0) lanes_->meet_circles_alone(rays, circles(rounds_), Within::Seen);
  } else {
    walk(rays, &walked);
  }
  if (others_.count > 0) lanes_->meet_circles_alone(rays, circles(others_), Within::Unseen);
  return seen(ray, range_m, name, walked);
}

Hit Sight::fixed_hit(const Ray& ray, double range_m, double name, const Hit& walked) const noexcept {
  if (name < 0) return {kNoHit, {}, Material::Rough};
  if (name < kRounds) return ground_->hit(ray, item_[static_cast<std::size_t>(name)], range_m);
  if (name < kOthers) return ground_->hit(ray, round_item_[static_cast<std::size_t>(name - kRounds)], range_m);
  if (name == kWalked) return walked;
  const auto n = static_cast<std::size_t>(name - kOthers);
  const Vector2 outwards = ray.from + ray.direction * range_m - Vector2{others_.a[n], others_.b[n]};
  return {range_m, outwards * (1 / others_.c[n]), Material::Rough};
}

Hit Sight::seen(const Ray& ray, double range_m, double name, const Hit& walked) const noexcept {
  const Hit hit = fixed_hit(ray, range_m, name, walked);
  if (world_->movers().empty()) return hit;
  return world_->nearest_mover(ray, hit, name < 0 ? std::nextafter(range_m, 0) : range_m);
}

}  // namespace ganglion::sim
