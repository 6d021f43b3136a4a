#include "ganglion/plot/view/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion::plot {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

ExhibitTrack track(std::string_view form, std::string_view name, shown::Exhibit state, int robot = 0) {
  ExhibitTrack one = *track_of(exhibit_topic({robot, "a"}, form, name));
  EXPECT_TRUE(one.add(0, std::move(state)));
  return one;
}

/// Two robots whose signals are x_m, y_m, yaw_rad and an echo, for two ticks; only the first has readings at the end.
RunView two_robots() {
  RunView run;
  for (const double x : {1.0, 5.0}) {
    RobotView robot;
    robot.signals.columns = {{"truth.x_m", "m"}, {"truth.y_m", "m"}, {"truth.yaw_rad", "rad"}, {"echo", "m"}};
    robot.signals.times_s = {0, 1};
    robot.signals.values = {x, 0, 0, 0.5, x == 1 ? 2 : kNone, 0, kPi / 2, kNone};
    run.robots.push_back(robot);
  }
  return run;
}

shown::Exhibit led_frame() { return {{}, shown::Frame{"world", {}, "truth.x_m", "truth.y_m", "truth.yaw_rad"}}; }

TEST(Frame, FollowsTheColumnsThatLeadIt) {
  RunView run = two_robots();
  run.exhibits = {track("frame", "body", led_frame()),
                  track("frame", "nose", {{}, shown::Frame{"body", {{0.5, 0}, {}}, "", "", ""}})};
  const ExhibitOwner owner{0, "a"};
  EXPECT_EQ(frame_at(run, owner, "nose", 0.5)->position, (Vector2{1.5, 0}));
  const auto turned = frame_at(run, owner, "nose", 1);
  EXPECT_NEAR(turned->position.x, 2, 1e-12);  // the body looks along y now
  EXPECT_NEAR(turned->position.y, 0.5, 1e-12);
  EXPECT_FALSE(frame_at(run, owner, "tail", 0));
  EXPECT_FALSE(frame_at(run, owner, "", 0));
  EXPECT_FALSE(frame_at(run, {1, "a"}, "nose", 0)) << "of another robot";
}

TEST(Frame, IsNowhereWithoutAReading) {
  RunView run = two_robots();
  run.exhibits = {track("frame", "body", led_frame(), 1)};
  EXPECT_TRUE(frame_at(run, {1, "a"}, "body", 0));
  EXPECT_FALSE(frame_at(run, {1, "a"}, "body", 1));
}

TEST(Frame, ThatStandsInItselfIsNowhere) {
  RunView run = two_robots();
  run.exhibits = {track("frame", "a", {{}, shown::Frame{"b", {}, "", "", ""}}),
                  track("frame", "b", {{}, shown::Frame{"a", {}, "", "", ""}})};
  EXPECT_FALSE(frame_at(run, {0, "a"}, "a", 0));
}

TEST(Column, MayBeAnotherRobots) {
  const RunView run = two_robots();
  EXPECT_EQ(column_at(run, 0, "truth.x_m", 0), 1);
  EXPECT_EQ(column_at(run, 0, "robot1/truth.x_m", 0), 5);
  EXPECT_TRUE(std::isnan(column_at(run, 0, "robot9/truth.x_m", 0)));
  EXPECT_TRUE(std::isnan(column_at(run, 0, "truth.z_m", 0)));
  EXPECT_TRUE(std::isnan(column_at(run, 0, "truth.x_m", -1)));
}

TEST(Shapes, HaveTheRadiusThatTheirSignalTells) {
  RunView run = two_robots();
  const shown::Shape echo{.form = Form::Sector, .frame = "world", .points = {{0, 0}}, .radius_m = 3, .radius = "echo"};
  run.exhibits = {track("marks", "m", {{}, shown::Marks{{echo}}})};
  EXPECT_EQ(shapes_at(run, 0).at(0).radius_m, 0.5);
  EXPECT_EQ(shapes_at(run, 1).at(0).radius_m, 0);  // no reading
}

TEST(Shapes, OfLastingRolesStayInThePictureOfTheWholeRunEachAsItWasLast) {
  const auto goal = [](Role role) {
    return shown::Shape{.role = role, .id = "goal 1", .frame = "world", .points = {{1, 1}}};
  };
  const auto line = [](Role role, double x) {
    return shown::Shape{.role = role, .frame = "world", .points = {{x, 0}}};
  };
  RunView run = two_robots();
  ExhibitTrack marks =
      track("marks", "m", {{}, shown::Marks{{goal(Role::Goal), line(Role::Plan, 1), line(Role::Tried, 2)}}});
  EXPECT_TRUE(marks.add(1, {{}, shown::Marks{{goal(Role::Reached), line(Role::Plan, 3)}}}));
  run.exhibits = {marks};
  std::vector<Role> roles;
  for (const PlacedShape& placed : lasting_shapes(run)) roles.push_back(placed.shape->role);
  EXPECT_EQ(roles, (std::vector<Role>{Role::Reached, Role::Tried, Role::Plan}));  // the goal once, the old plan gone
  EXPECT_EQ(shapes_at(run, 1).size(), 2u);
}

}  // namespace
}  // namespace ganglion::plot
