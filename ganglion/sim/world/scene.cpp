#include "ganglion/sim/world/scene.h"

#include <fmt/format.h>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ganglion::sim {
namespace {

using Json = nlohmann::ordered_json;

/// Beyond that many rectangles the drawing no longer tells unknown cells from occupied ones.
constexpr std::size_t kMaxRectangles = 100'000;

double rounded(double metres) noexcept { return std::round(metres * 1e4) / 1e4; }
Json point(Vector2 v) { return Json::array({rounded(v.x), rounded(v.y)}); }
Json pose_of(const Pose2& pose) {
  return Json::array({rounded(pose.position.x), rounded(pose.position.y), rounded(pose.yaw.rad())});
}

template <class Points>
Json points_of(const Points& points) {
  Json list = Json::array();
  for (const Vector2 v : points) list.push_back(point(v));
  return list;
}

Json named(const std::string& id, const std::string& label) {
  Json item = Json::object();
  if (!id.empty()) item["id"] = id;
  if (!label.empty()) item["label"] = label;
  return item;
}

Json shape_of(const Shape& shape) {
  constexpr std::array<const char*, 4> kKinds = {"wall", "box", "disc", "polygon"};
  Json item = named(shape.id, shape.label);
  item["class"] = shape.structural ? "wall" : "furniture";
  item["kind"] = kKinds[static_cast<std::size_t>(shape.kind)];
  item["material"] = name_of(shape.material);
  if (shape.kind == ShapeKind::Disc) {
    item["x"] = rounded(shape.disc.position.x);
    item["y"] = rounded(shape.disc.position.y);
    item["radius"] = rounded(shape.disc.radius_m);
  } else {
    item["points"] = points_of(shape.points);
    item["closed"] = shape.closed || shape.kind != ShapeKind::Wall;
  }
  return item;
}

struct Rectangle {
  int column, row, columns, rows;
};

/// Cells that satisfy `wanted` as rectangles: runs along the rows, those that repeat in the next row joined. Gives up
/// at more than `limit`.
template <class Wanted>
std::vector<Rectangle> rectangles(const OccupancyMap& map, std::size_t limit, Wanted wanted) {
  std::vector<Rectangle> done, open, next;
  for (int row = 0; row < map.rows() && done.size() <= limit; ++row) {
    next.clear();
    std::size_t above = 0;  // the open rectangle that may go on here; both lists run from left to right
    for (int column = 0; column < map.columns(); ++column) {
      if (!wanted(map.at(column, row))) continue;
      const int start = column;
      while (column + 1 < map.columns() && wanted(map.at(column + 1, row))) ++column;
      while (above < open.size() && open[above].column < start) done.push_back(open[above++]);
      Rectangle run{start, row, column - start + 1, 1};
      if (above < open.size() && open[above].column == start && open[above].columns == run.columns) {
        run = open[above++];
        ++run.rows;
      }
      next.push_back(run);
    }
    done.insert(done.end(), open.begin() + static_cast<std::ptrdiff_t>(above), open.end());
    open.swap(next);
  }
  done.insert(done.end(), open.begin(), open.end());
  return done;
}

Json json_of(const std::vector<Rectangle>& list) {
  Json items = Json::array();
  for (const Rectangle& r : list) items.push_back(Json::array({r.column, r.row, r.columns, r.rows}));
  return items;
}

Json map_of(const OccupancyMap& map) {
  auto occupied = rectangles(map, kMaxRectangles, [](Occupancy cell) { return cell == Occupancy::Occupied; });
  auto unknown = rectangles(map, kMaxRectangles, [](Occupancy cell) { return cell == Occupancy::Unknown; });
  if (occupied.size() + unknown.size() > kMaxRectangles) {
    occupied = rectangles(map, kMaxSegments, [](Occupancy cell) { return cell != Occupancy::Free; });
    unknown.clear();
  }
  Json item;
  item["origin"] = pose_of(map.origin());
  item["resolution"] = map.resolution_m();
  item["columns"] = map.columns();
  item["rows"] = map.rows();
  item["occupied"] = json_of(occupied);
  item["unknown"] = json_of(unknown);
  return item;
}

Json mover_of(const MoverPlan& plan, const MoverState& state) {
  Json item = named(plan.id, plan.label);
  item["class"] = "mover";
  if (plan.outline.empty()) {
    item["radius"] = rounded(plan.radius_m);
  } else {
    item["points"] = points_of(plan.outline);
  }
  item["pose"] = pose_of(state.pose);
  return item;
}

std::string hex(const Colour& colour) {
  const auto part = [](double share) { return static_cast<int>(std::lround(share * 255)); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(colour.red), part(colour.green), part(colour.blue));
}

Json zone_of(const FloorZone& zone) {
  Json item = named(zone.id, zone.label);
  if (zone.outline.empty()) {
    item["x"] = rounded(zone.disc.position.x);
    item["y"] = rounded(zone.disc.position.y);
    item["radius"] = rounded(zone.disc.radius_m);
  } else {
    item["points"] = points_of(zone.outline);
  }
  item["colour"] = hex(zone.colour);
  item["slip"] = zone.slip;
  item["uphill"] = point(zone.uphill * zone.grade);
  return item;
}

Json beacon_of(const Beacon& beacon) {
  Json item = named(beacon.id, beacon.label);
  item["x"] = rounded(beacon.position.x);
  item["y"] = rounded(beacon.position.y);
  item["light"] = rounded(beacon.light_range_m);
  item["sound"] = rounded(beacon.sound_range_m);
  item["colour"] = hex(beacon.colour);
  return item;
}

/// What few worlds have is left out where there is none of it.
void add_floor(const GroundPlan& plan, Json& scene) {
  for (const FloorZone& zone : plan.floor.zones) scene["floor"].push_back(zone_of(zone));
  for (const FloorBump& bump : plan.floor.bumps) {
    scene["bumps"].push_back(Json::array({point(bump.from), point(bump.to)}));
  }
  for (const Beacon& beacon : plan.beacons) scene["beacons"].push_back(beacon_of(beacon));
}

}  // namespace

std::string scene_json(const World& world) {
  const Ground& ground = world.ground();
  const Box2& box = ground.bounds();
  Json scene;
  scene["name"] = ground.name();
  scene["bounds"] =
      Json::array({rounded(box.lower.x), rounded(box.lower.y), rounded(box.upper.x), rounded(box.upper.y)});
  scene["shapes"] = Json::array();
  for (const Shape& shape : ground.plan().shapes) scene["shapes"].push_back(shape_of(shape));
  if (ground.plan().map) scene["map"] = map_of(*ground.plan().map);
  scene["movers"] = Json::array();
  for (std::size_t i = 0; i < ground.movers().size(); ++i) {
    scene["movers"].push_back(mover_of(ground.movers()[i], world.movers()[i]));
  }
  scene["spawns"] = Json::array();
  for (const Spawn& spawn : ground.spawns()) {
    Json item = named(spawn.id, spawn.label);
    item["pose"] = pose_of(spawn.pose);
    scene["spawns"].push_back(std::move(item));
  }
  add_floor(ground.plan(), scene);
  return scene.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ganglion::sim
