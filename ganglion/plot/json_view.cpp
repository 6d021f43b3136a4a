#include "ganglion/plot/json_view.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ganglion/base/json_depth.h"

namespace ganglion::plot {
namespace {

const Json& list_in(const Json& object, const char* key) {
  static const Json kNone = Json::array();
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_array() ? *found : kNone;
}

double element(const Json& list, std::size_t i) {
  return i < list.size() && list[i].is_number() ? list[i].get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// A whole number within [0, most].
int whole(double value, int most) noexcept {
  return value > 0 ? static_cast<int>(std::min(value, static_cast<double>(most))) : 0;
}

std::vector<Vector2> circle(Vector2 centre, double radius_m) {
  constexpr int kCorners = 32;
  std::vector<Vector2> points;
  for (int i = 0; i < kCorners; ++i) points.push_back(centre + radius_m * direction(2 * kPi * i / kCorners));
  return points;
}

void add_shape(Scene& scene, const Json& shape) {
  const std::string kind = text_in(shape, "kind");
  const bool furniture = text_in(shape, "class") == "furniture";
  Outline outline{points_in(shape, "points"), shape.is_object() && shape.value("closed", Json(false)) == Json(true)};
  if (kind == "disc")
    outline = {circle({number_in(shape, "x"), number_in(shape, "y")}, number_in(shape, "radius")), true};
  if (furniture)
    scene.furniture.push_back(std::move(outline));
  else if (kind == "wall")
    scene.walls.push_back(std::move(outline));
  else
    scene.solids.push_back(std::move(outline));
}

std::vector<ScannedMap::Block> blocks_in(const Json& object, const char* key) {
  std::vector<ScannedMap::Block> blocks;
  for (const Json& block : list_in(object, key)) {
    if (!block.is_array() || blocks.size() >= kMaxBlocks) break;
    const auto part = [&](std::size_t i) { return whole(element(block, i), kMaxMapSide); };
    blocks.push_back({part(0), part(1), part(2), part(3)});
  }
  return blocks;
}

std::optional<ScannedMap> map_from(const Json& scene) {
  const auto found = scene.find("map");
  if (found == scene.end() || !found->is_object()) return std::nullopt;
  ScannedMap map{pose_in(*found, "origin"),
                 number_in(*found, "resolution"),
                 whole(number_in(*found, "columns"), kMaxMapSide),
                 whole(number_in(*found, "rows"), kMaxMapSide),
                 blocks_in(*found, "occupied"),
                 blocks_in(*found, "unknown")};
  if (!(map.cell_m > 0) || map.columns == 0 || map.rows == 0) return std::nullopt;
  return map;
}

Mover mover_from(const Json& mover) {
  Mover result{text_in(mover, "id"), points_in(mover, "points"), {0}, {pose_in(mover, "pose")}};
  if (result.outline.empty()) result.outline = circle({}, number_in(mover, "radius"));
  return result;
}

/// The floor and what stands above it: nothing that blocks the way.
void add_floor(Scene& scene, const Json& json) {
  for (const Json& zone : list_in(json, "floor")) {
    if (scene.zones.size() >= kMaxShapes) break;
    Outline outline{points_in(zone, "points"), true};
    if (outline.points.empty())
      outline.points = circle({number_in(zone, "x"), number_in(zone, "y")}, number_in(zone, "radius"));
    scene.zones.push_back(std::move(outline));
  }
  for (const Json& bump : list_in(json, "bumps")) {
    if (scene.bumps.size() >= kMaxShapes) break;
    const auto end = [&](std::size_t i) {
      const Json point = bump.is_array() && i < bump.size() ? bump[i] : Json();
      return Vector2{element(point, 0), element(point, 1)};
    };
    scene.bumps.push_back({{end(0), end(1)}, false});
  }
  for (const Json& beacon : list_in(json, "beacons"))
    if (scene.beacons.size() < kMaxShapes) scene.beacons.push_back({number_in(beacon, "x"), number_in(beacon, "y")});
}

}  // namespace

std::optional<Json> parse_object(std::string_view text) {
  if (!json_nests_within(text, kDeepestJson)) return std::nullopt;
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  return json;
}

double number_in(const Json& object, const char* key, double otherwise) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_number() ? found->get<double>() : otherwise;
}

std::string text_in(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::vector<Vector2> points_in(const Json& object, const char* key) {
  std::vector<Vector2> points;
  for (const Json& point : list_in(object, key)) {
    if (points.size() >= kMaxPoints) break;
    if (point.is_array()) points.push_back({element(point, 0), element(point, 1)});
  }
  return points;
}

Pose2 pose_in(const Json& object, const char* key) {
  const Json& list = list_in(object, key);
  const double yaw_rad = element(list, 2);
  return {{element(list, 0), element(list, 1)}, Angle::from_rad(yaw_rad == yaw_rad ? yaw_rad : 0)};
}

Scene scene_from(const Json& json) {
  Scene scene;
  for (const Json& shape : list_in(json, "shapes")) {
    if (scene.walls.size() + scene.furniture.size() + scene.solids.size() >= kMaxShapes) break;
    add_shape(scene, shape);
  }
  scene.map = map_from(json);
  for (const Json& mover : list_in(json, "movers"))
    if (scene.movers.size() < kMaxShapes) scene.movers.push_back(mover_from(mover));
  for (const Json& spawn : list_in(json, "spawns")) scene.spawns.push_back(pose_in(spawn, "pose"));
  add_floor(scene, json);
  const Json& box = list_in(json, "bounds");
  const Bounds bounds{{element(box, 0), element(box, 1)}, {element(box, 2), element(box, 3)}};
  if (bounds.lower.x < bounds.upper.x && bounds.lower.y < bounds.upper.y) scene.bounds = bounds;
  return scene;
}

}  // namespace ganglion::plot
