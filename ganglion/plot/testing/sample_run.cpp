#include "ganglion/plot/testing/sample_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ganglion/math/functions.h"

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

MapFrame map_at(double time_s, double share) {
  constexpr int kColumns = 20, kRows = 16;
  MapFrame frame{time_s, {0, 0}, kColumns, kRows, {}, {}, {}, {}};
  const std::size_t cells = kColumns * kRows;
  frame.label.assign(cells, 0), frame.risk.assign(cells, 0), frame.dynamic.assign(cells, 0),
      frame.inhibited.assign(cells, 0);
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns * share; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * kColumns + column;
      const bool edge = row == 0 || row == kRows - 1 || column == 0;
      const bool block = column >= 5 && column <= 7 && row >= 5 && row <= 6;
      frame.label[i] = edge || block ? 2 : (row * 7 + column * 5) % 11 == 0 ? 0 : 1;
      frame.risk[i] = static_cast<std::uint8_t>(edge                  ? 60
                                                : block               ? 200
                                                : frame.label[i] == 0 ? 0
                                                                      : (row * 13 + column * 29) % 70);
      frame.dynamic[i] = column % 6 == 3 && row % 5 == 2;
      frame.inhibited[i] = block && column == 5 + static_cast<int>(time_s / 20) % 3 ? 9 : 0;
      if (frame.inhibited[i]) frame.risk[i] = 240;
    }
  return frame;
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
  robot.maps.push_back({"router", 0.3, {}});
  for (int i = 0; i < 9; ++i) robot.maps[0].frames.push_back(map_at(i * 10.0, std::min(1.0, 0.2 + 0.12 * i)));
  robot.goals = {{{4.95, 3.45}, 0, 21, GoalState::Reached, ""},
                 {{1.35, 4.35}, 21, 44, GoalState::Reached, ""},
                 {{1.95, 1.95}, 44, 70, GoalState::Withdrawn, "every route failed"},
                 {{5.25, 0.75}, 70, kInfinite, GoalState::Pending, ""}};
  for (int i = 0; i < 8; ++i) {
    Route route{"router", i * 10.0, {}};
    for (int k = 0; k < 14; ++k) route.points.push_back(pose_at(i * 10.0 + k, 0).position);
    robot.routes.push_back(std::move(route));
  }
  return run;
}

RunView empty_run() {
  RunView run{.name = "empty"};
  run.robots.push_back({.name = "robot0", .radius_m = 0.1});
  run.robots[0].signals.columns = {{"sonar", "m"}};
  run.robots[0].coordinations.push_back({"arbiter", {"escape"}, {}, {}, {}, {}});
  run.robots[0].maps.push_back({"router", 0.3, {}});
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
