#include "ganglion/sim/world/plan/plan.h"

#include <algorithm>
#include <array>

#include "ganglion/base/text.h"
#include "ganglion/config/table.h"
#include "ganglion/sim/world/plan/plan_floor.h"
#include "ganglion/sim/world/plan/plan_points.h"

namespace ganglion::sim {
namespace {

double read_yaw(config::Table& table) { return Angle::from_deg(table.number("yaw_deg", 0, {-360, 360})).rad(); }

Material read_material(config::Table& table, Material preset = Material::Rough) {
  return static_cast<Material>(table.choice("material", kMaterialNames, static_cast<int>(preset)));
}

std::optional<Box2> read_box(config::Table& table, std::string_view key) {
  const auto box = table.numbers(key, {}, 4, kCoordinate);
  if (box.size() != 4) return std::nullopt;
  if (box[0] < box[2] && box[1] < box[3]) return Box2{{box[0], box[1]}, {box[2], box[3]}};
  table.problem(key, ErrorCode::BadParameter,
                {"{} is [min x, min y, max x, max y]: it must not be empty",
                 "{} es [x mín, y mín, x máx, y máx]: no debe estar vacío"},
                key);
  return std::nullopt;
}

/// What every shape may say.
Shape read_shape(config::Table& table, ItemIds& ids, ShapeKind kind, const GroundPlan& plan) {
  Shape shape;
  shape.kind = kind;
  shape.id = ids.read(table, false);
  shape.label = table.text("label", "");
  shape.material = read_material(table, plan.material);
  shape.structural = table.boolean("structural", kind == ShapeKind::Wall);
  return shape;
}

void read_walls(config::Table& root, ItemIds& ids, GroundPlan& plan) {
  for (config::Table& table : root.tables("wall")) {
    Shape wall = read_shape(table, ids, ShapeKind::Wall, plan);
    wall.closed = table.boolean("closed", false);
    wall.points = read_points(table, "points", wall.closed ? 3 : 2);
    check_spacing(table, "points", wall.points, wall.closed);
    plan.shapes.push_back(std::move(wall));
  }
}

void read_boxes(config::Table& root, ItemIds& ids, GroundPlan& plan) {
  for (config::Table& table : root.tables("box")) {
    Shape box = read_shape(table, ids, ShapeKind::Box, plan);
    const Vector2 centre = read_position(table);
    const double length_m = table.number("length_m", kExtent), width_m = table.number("width_m", kExtent);
    box.points = rectangle(centre, length_m, width_m, read_yaw(table));
    plan.shapes.push_back(std::move(box));
  }
}

void read_discs(config::Table& root, ItemIds& ids, GroundPlan& plan) {
  for (config::Table& table : root.tables("disc")) {
    Shape disc = read_shape(table, ids, ShapeKind::Disc, plan);
    disc.disc.position = read_position(table);
    disc.disc.radius_m = table.number("radius_m", kExtent);
    plan.shapes.push_back(std::move(disc));
  }
}

void read_polygons(config::Table& root, ItemIds& ids, GroundPlan& plan) {
  for (config::Table& table : root.tables("polygon")) {
    Shape polygon = read_shape(table, ids, ShapeKind::Polygon, plan);
    polygon.points = read_points(table, "points", 3);
    if (check_spacing(table, "points", polygon.points, true)) check_outline(table, "points", polygon.points);
    if (doubled_area(polygon.points) < 0) std::reverse(polygon.points.begin(), polygon.points.end());
    plan.shapes.push_back(std::move(polygon));
  }
}

void read_mover_body(config::Table& table, MoverPlan& mover) {
  if (table.has("radius_m")) {
    mover.radius_m = table.number("radius_m", kExtent);
    for (const char* key : {"length_m", "width_m"}) {
      if (table.has(key))
        table.problem(
            key, ErrorCode::BadParameter,
            {"a mover is a disc or a box: {} or radius_m", "un obstáculo móvil es un disco o una caja: {} o radius_m"},
            key);
      table.known(key);
    }
    return;
  }
  const double length_m = table.number("length_m", kExtent), width_m = table.number("width_m", kExtent);
  mover.outline = rectangle({0, 0}, length_m, width_m, 0);
  mover.radius_m = Vector2{length_m, width_m}.length() / 2 * (1 + 1e-12);  // never a hair within the corners
}

void read_mover_places(config::Table& table, MoverPlan& mover) {
  const Angle yaw = Angle::from_rad(read_yaw(table)).wrapped();
  for (const Vector2 point : read_points(table, "places", 1)) mover.places.push_back({point, yaw});
  if (mover.places.size() < 2 && !table.has("change_after_s")) return;
  const auto change = table.numbers("change_after_s", {}, 2, config::kPositive);
  if (!table.has("change_after_s")) {
    table.problem("places", ErrorCode::MissingKey,
                  {"change_after_s = [min, max] is missing: when does it jump?",
                   "falta change_after_s = [mín, máx]: ¿cuándo salta?"});
  } else if (change.size() == 2 && change[0] > change[1]) {
    table.problem("change_after_s", ErrorCode::BadParameter,
                  {"change_after_s has its smaller number last", "change_after_s tiene el número menor al final"});
  } else if (change.size() == 2) {
    mover.change_min_s = change[0];
    mover.change_max_s = change[1];
  }
}

void read_mover_path(config::Table& table, MoverPlan& mover) {
  mover.yaw = Angle::from_rad(read_yaw(table)).wrapped();
  mover.path = read_points(table, "path", 2);
  mover.loop = table.boolean("loop", false);
  mover.speed_mps = table.number("speed_mps", {0, 100, true});
  check_spacing(table, "path", mover.path, mover.loop);
}

void read_mover_stroll(config::Table& table, MoverPlan& mover) {
  Stroll stroll;
  mover.yaw = Angle::from_rad(read_yaw(table)).wrapped();
  stroll.start = read_position(table);
  stroll.area = read_box(table, "area").value_or(Box2{});
  mover.speed_mps = table.number("speed_mps", {0, 100, true});
  const auto pause = table.numbers("pause_s", {0, 0}, 2, config::kNotNegative);
  if (pause.size() == 2) {
    stroll.pause_min_s = pause[0];
    stroll.pause_max_s = pause[1];
    if (pause[0] > pause[1]) {
      table.problem("pause_s", ErrorCode::BadParameter,
                    {"pause_s has its smaller number last", "pause_s tiene el número menor al final"});
    }
  }
  constexpr std::array<std::string_view, 2> kAvoids = {"nothing", "robots"};
  stroll.avoids_robots = table.choice("avoids", kAvoids, 0) == 1;
  mover.stroll = stroll;
}

void read_movers(config::Table& root, ItemIds& ids, GroundPlan& plan) {
  for (config::Table& table : root.tables("mover")) {
    MoverPlan mover;
    mover.place = table.place();
    mover.id = ids.read(table, true);
    mover.label = table.text("label", "");
    mover.material = read_material(table);
    read_mover_body(table, mover);
    const int ways = (table.has("path") ? 1 : 0) + (table.has("places") ? 1 : 0) + (table.has("area") ? 1 : 0);
    if (ways != 1) {
      table.problem(
          table.has("path") ? "path" : "id", ErrorCode::BadParameter,
          {"a mover has either places = [[x, y], ...] to jump between or a path = [[x, y], ...] to follow or an "
           "area = [min x, min y, max x, max y] to stroll in",
           "un obstáculo móvil tiene una sola de estas claves: places = [[x, y], ...] entre los que salta, path = [[x, "
           "y], ...] que sigue, o area = [x mín, y mín, x máx, y máx] por la que pasea"});
      for (const char* key : {"path", "places", "area", "yaw_deg", "change_after_s", "speed_mps", "loop", "x_m", "y_m",
                              "pause_s", "avoids"}) {
        table.known(key);
      }
    } else if (table.has("area")) {
      read_mover_stroll(table, mover);
    } else if (table.has("path")) {
      read_mover_path(table, mover);
    } else {
      read_mover_places(table, mover);
    }
    plan.movers.push_back(std::move(mover));
  }
}

void read_spawns(config::Table& root, ItemIds& ids, GroundPlan& plan) {
  for (config::Table& table : root.tables("spawn")) {
    Spawn spawn;
    spawn.place = table.place();
    spawn.id = ids.read(table, true);
    spawn.label = table.text("label", "");
    spawn.pose.position = read_position(table);
    spawn.pose.yaw = Angle::from_rad(read_yaw(table)).wrapped();
    plan.spawns.push_back(std::move(spawn));
  }
}

void read_map(config::Table& root, GroundPlan& plan, FileReader* files, Problems& problems) {
  const int file = root.open("map", "map", kMaxMapText);
  if (file < 0) return;
  if (auto map = OccupancyMap::load(*files, file, problems)) plan.map = std::move(*map);
}

GroundPlan read_plan(const config::Value& value, Problems& problems, FileReader* files, config::Outline* outline) {
  GroundPlan plan;
  config::Table root(value, "", problems, outline);
  root.opens_by(files);
  check_format(root);
  plan.place = {value.place().file};
  plan.name = root.text("name", "");
  plan.material = read_material(root);
  ItemIds ids;
  plan.area = read_box(root, "area");
  read_map(root, plan, files, problems);
  read_walls(root, ids, plan);
  read_boxes(root, ids, plan);
  read_discs(root, ids, plan);
  read_polygons(root, ids, plan);
  read_floor(root, ids, plan);
  read_beacons(root, ids, plan);
  read_movers(root, ids, plan);
  read_spawns(root, ids, plan);
  return plan;
}

/// A map file stands for a world with nothing but that map, so that --set works on it all the same.
config::Value world_of_map(const std::filesystem::path& path) {
  const Place place{path.string(), 1, 1};
  config::Members members;
  members.emplace_back("format", config::Value(std::int64_t{1}, place));
  members.emplace_back("name", config::Value(path.stem().string(), place));
  members.emplace_back("map", config::Value(path.filename().string(), place));
  return {std::move(members), place};
}

}  // namespace

GroundPlan load_plan(FileReader& files, int file, std::span<const config::Override> overrides, Problems& problems) {
  const std::filesystem::path path = files.at(file).resolved;
  const bool is_map = path.extension() == ".yaml" || path.extension() == ".yml";
  Result<config::Value> value = is_map ? Result<config::Value>(world_of_map(path)) : config::parse(files.at(file));
  if (!value) {
    problems.add(value.error());
    return {};
  }
  for (const config::Override& override : overrides) {
    if (auto applied = config::apply(*value, override); !applied) problems.add(applied.error());
  }
  return read_plan(*value, problems, &files, nullptr);
}

GroundPlan parse_plan(std::string_view text, const std::string& file_name, Problems& problems,
                      config::Outline* outline) {
  const auto value = config::parse(text, file_name);
  if (value) return read_plan(*value, problems, nullptr, outline);
  problems.add(value.error());
  return {};
}

}  // namespace ganglion::sim
