#include "ganglion/plot/testing/sample_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ganglion/math/functions.h"
#include "ganglion/record/exhibit/testing/shows_all.h"

namespace ganglion::plot {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

Outline box(double x, double y, double length, double width) {
  return {{{x, y}, {x + length, y}, {x + length, y + width}, {x, y + width}}, true};
}

Scene sample_scene() {
  Scene scene;
  scene.walls = {box(0, 0, 6, 5), {{{3.6, 5}, {3.6, 3.7}}, false}};
  scene.furniture = {box(1.5, 1.6, 0.8, 0.5), box(4.2, 1.2, 0.6, 0.9)};
  scene.movers = {{"cart",
                   {{-0.2, -0.15}, {0.2, -0.15}, {0.2, 0.15}, {-0.2, 0.15}},
                   {0, 40},
                   {{{2.6, 3.9}, {}}, {{3.1, 0.6}, {}}}}};
  scene.spawns = {{{0.8, 0.8}, {}}};
  scene.bounds = Bounds{{0, 0}, {6, 5}};
  return scene;
}

/// Where a robot is at a time: round the room, a little wider for each further robot.
Pose2 pose_at(double time_s, int robot) {
  const double turn = 0.105 * time_s + 2.1 * robot;
  const double yaw = std::remainder(turn + kPi / 2, 2 * kPi);
  return {{3 + (2.1 - 0.25 * robot) * math::cos(turn), 2.5 + (1.65 - 0.2 * robot) * math::sin(turn)},
          Angle::from_rad(yaw)};
}

double sonar_at(double time_s, int robot, bool left) {
  const double wave = 1.3 + 1.2 * math::sin(0.42 * time_s + (left ? 0 : 1.4) + robot);
  if (wave > 2.3) return kInfinite;
  if (wave < 0.13) return -kInfinite;
  return !left && time_s > 60 && time_s < 68 ? kNaN : wave;
}

RobotView behaviour_robot(int number, double duration_s) {
  RobotView robot{.name = fmt::format("robot{}", number), .length_m = 0.24, .width_m = 0.20};
  for (const bool left : {true, false}) {
    const std::string id = left ? "sonar_left" : "sonar_right";
    robot.sensors.push_back(
        {id, "sonar", {{0.11, left ? 0.08 : -0.08}, Angle::from_deg(left ? 5 : -5)}, 0.52, 3.0, id});
  }
  robot.signals.columns = {{"truth.x_m", "m"},  {"truth.y_m", "m"},   {"truth.yaw_rad", "rad"}, {"truth.touching", ""},
                           {"sonar_left", "m"}, {"sonar_right", "m"}, {"arbiter.active", ""},   {"escape.active", ""},
                           {"drive.left", ""},  {"drive.right", ""}};
  Coordination arbiter{"arbiter", {"escape", "avoid", "navigate"}, {}, {}, {}, {}};
  for (int tick = 0; tick < static_cast<int>(duration_s * 10); ++tick) {
    const double time_s = tick * 0.1;
    const Pose2 pose = pose_at(time_s, number);
    const double left_m = sonar_at(time_s, number, true);
    const double right_m = sonar_at(time_s, number, false);
    const double near_m = std::min(left_m, std::isnan(right_m) ? left_m : right_m);
    const bool escape = near_m < 0.2;
    const bool avoid = near_m < 0.6;
    const std::int16_t active = tick < 5 ? -1 : escape ? 0 : avoid ? 1 : 2;
    robot.track.times_s.push_back(time_s);
    robot.track.x_m.push_back(pose.position.x);
    robot.track.y_m.push_back(pose.position.y);
    robot.track.yaw_rad.push_back(pose.yaw.rad());
    robot.track.touching.push_back(left_m < 0.12);
    robot.signals.times_s.push_back(time_s);
    for (const double value : {pose.position.x, pose.position.y, pose.yaw.rad(), double(left_m < 0.12), left_m, right_m,
                               double(active), double(escape), 0.3 + 0.1 * math::sin(time_s), 0.33})
      robot.signals.values.push_back(value);
    arbiter.times_s.push_back(time_s);
    arbiter.active.push_back(active);
    for (const bool wants : {escape, avoid, tick >= 5}) arbiter.wanted.push_back(wants);
  }
  robot.coordinations.push_back(std::move(arbiter));
  return robot;
}

/// Layers of a map: what a cell is, how risky, whether it changes, whether it is closed.
std::vector<shown::Layer> layers_of_a_map() {
  const auto layer = [](const char* name, Sentence title, std::vector<shown::Class> classes) {
    return shown::Layer{name, std::move(title), "", 0, 1, std::move(classes)};
  };
  return {layer("label", {"cells", "celdas"},
                {{0.5, Role::Free, {"empty", "vacía"}}, {1, Role::Solid, {"occupied", "ocupada"}}}),
          layer("risk", {"risk", "riesgo"}, {}),
          layer("static", {"nature", "naturaleza"},
                {{0, Role::Moving, {"dynamic", "dinámica"}}, {1, Role::Plain, {"static", "estática"}}}),
          layer("inhibited", {"inhibition", "inhibición"},
                {{0, Role::Free, {"open", "abierta"}}, {1, Role::Danger, {"inhibited", "inhibida"}}})};
}

shown::Field map_at(double time_s, double share) {
  constexpr int kColumns = 20, kRows = 16;
  shown::Field field;
  field.frame = "world";
  field.cell = {0.3, 0.3};
  field.columns = kColumns;
  field.rows = kRows;
  field.layers = layers_of_a_map();
  field.cells.assign(4, std::vector<std::uint8_t>(kColumns * kRows, shown::kUnknownCell));
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns * share; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column);
      const bool edge = row == 0 || row == kRows - 1 || column == 0;
      const bool block = column >= 5 && column <= 7 && row >= 5 && row <= 6;
      if (!edge && !block && (row * 7 + column * 5) % 11 == 0) continue;
      const bool closed = block && column == 5 + static_cast<int>(time_s / 20) % 3;
      const double risk = closed ? 0.94 : edge ? 0.24 : block ? 0.78 : (row * 13 + column * 29) % 70 / 255.0;
      field.cells[0][i] = field.layers[0].byte_of(edge || block ? 1 : 0.5);
      field.cells[1][i] = field.layers[1].byte_of(risk);
      field.cells[2][i] = field.layers[2].byte_of(column % 6 == 3 && row % 5 == 2 ? 0 : 1);
      field.cells[3][i] = field.layers[3].byte_of(closed ? 1 : 0);
    }
  }
  return field;
}

/// What somebody shows at the start and ten seconds later.
std::vector<ExhibitTrack> kept_exhibits(ShowsAll exhibitor, const ExhibitOwner& owner) {
  KeepsShown kept(owner);
  for (exhibitor.stage = 0; exhibitor.stage < 3; ++exhibitor.stage) {
    kept.time_s = 10.0 * exhibitor.stage;
    exhibitor.show(kept);
  }
  return kept.tracks;
}

ExhibitTrack track(std::string_view form, std::string_view name) {
  return *track_of(exhibit_topic({0, "router"}, form, name));
}

ExhibitTrack sample_map() {
  ExhibitTrack map = track("field", "map");
  for (int i = 0; i < 9; ++i) {
    map.add(i * 10.0, {{"Learned map", "Mapa aprendido"}, map_at(i * 10.0, std::min(1.0, 0.2 + 0.12 * i))});
  }
  return map;
}

ExhibitTrack sample_routes() {
  ExhibitTrack routes = track("marks", "route");
  for (int i = 0; i < 8; ++i) {
    shown::Shape route{.role = Role::Plan, .frame = "world"};
    for (int k = 0; k < 14; ++k) route.points.push_back(pose_at(i * 10.0 + k, 0).position);
    routes.add(i * 10.0, {{"Route", "Ruta"}, shown::Marks{{std::move(route)}}});
  }
  return routes;
}

ExhibitTrack sample_goals() {
  ExhibitTrack goals = track("marks", "goals");
  constexpr std::array<Vector2, 4> kPlaces = {{{4.95, 3.45}, {1.35, 4.35}, {1.95, 1.95}, {5.25, 0.75}}};
  constexpr std::array<double, 4> kSet_s = {0, 21, 44, 70};
  constexpr std::array<Role, 4> kEnd = {Role::Reached, Role::Reached, Role::GivenUp, Role::Goal};
  for (std::size_t now = 0; now < kPlaces.size(); ++now) {
    shown::Marks marks;
    for (std::size_t g = 0; g <= now; ++g) {
      marks.shapes.push_back({.form = Form::Disc,
                              .role = g < now ? kEnd[g] : Role::Goal,
                              .id = fmt::format("goal {}", g + 1),
                              .frame = "world",
                              .points = {kPlaces[g]},
                              .label = Sentence::quoted(fmt::format("{}", g + 1))});
    }
    goals.add(kSet_s[now], {{"Goals", "Objetivos"}, std::move(marks)});
  }
  return goals;
}

ExhibitTrack sample_attempts() {
  ExhibitTrack attempts = track("marks", "attempts");
  for (int i = 0; i < 3; ++i) {
    shown::Shape line{.role = Role::Tried, .frame = "world", .points = {{1.4 + 0.3 * i, 1.3}, {1.65 + 0.3 * i, 1.75}}};
    attempts.add(20.0 * i, {{"Failed attempts", "Intentos fallidos"}, shown::Marks{{std::move(line)}}});
  }
  return attempts;
}

}  // namespace

RunView sample_behaviour_run(int robots, double duration_s) {
  RunView run{.name = "nimrod: round the room", .seed = 7, .duration_s = duration_s, .scene = sample_scene()};
  run.outcome = RunOutcome{Verdict::Succeeded,
                           {"the course was held for the whole run", "mantuvo el rumbo durante toda la ejecución"},
                           {"min_range_m > 0.02 and contacts <= 20", "min_range_m > 0.02 y contacts <= 20"},
                           "9f3a5c0d11e2b477"};
  run.measures = {{"path_m", 24.318}, {"contacts", 6}, {"area_explored_m2", 11.25}, {"mean_speed_mps", 0.2027}};
  for (int i = 0; i < robots; ++i) run.robots.push_back(behaviour_robot(i, duration_s));
  run.events = {{0, Severity::Info, {"started", "empezó"}},
                {12.3, Severity::Warning, {"sonar_right lost", "sonar_right perdido"}},
                {61, Severity::Error, {"stuck", ""}}};  // of a file that had English only
  return run;
}

RunView sample_router_run() {
  RunView run = sample_behaviour_run(1, 80);
  run.name = "pathfinder";
  RobotView& robot = run.robots[0];
  robot.coordinations.clear();
  run.exhibits = {sample_map(), sample_routes(), sample_goals(), sample_attempts()};
  return run;
}

RunView sample_exhibits_run() {
  RunView run = sample_behaviour_run(1, 30);
  run.name = "everything there is to see";
  run.exhibits = kept_exhibits(ShowsAll(), {0, "all"});
  return run;
}

RunView empty_run() {
  RunView run{.name = "empty"};
  run.robots.push_back({.name = "robot0", .radius_m = 0.1});
  run.robots[0].signals.columns = {{"sonar", "m"}};
  run.robots[0].coordinations.push_back({"arbiter", {"escape"}, {}, {}, {}, {}});
  run.exhibits.push_back(track("field", "map"));
  return run;
}

RunView unreadable_run() {
  RunView run = sample_behaviour_run(1, 20);
  RobotView& robot = run.robots[0];
  std::ranges::fill(robot.signals.values, kNaN);
  std::ranges::fill(robot.track.x_m, kNaN);
  std::ranges::fill(robot.track.y_m, kNaN);
  std::ranges::fill(robot.track.yaw_rad, kNaN);
  std::ranges::fill(robot.coordinations[0].active, std::int16_t{-1});
  for (Measure& measure : run.measures) measure.value = kNaN;
  run.outcome.reset();
  return run;
}

}  // namespace ganglion::plot
