#include "ganglion/plot/view/run_view.h"

#include <gtest/gtest.h>

#include "ganglion/plot/testing/sample_run.h"

namespace ganglion::plot {
namespace {

TEST(IndexAt, IsTheLastEntryNotLater) {
  const std::vector<double> times_s{0, 0.1, 0.2};
  EXPECT_EQ(index_at(times_s, -0.01), std::nullopt);
  EXPECT_EQ(index_at(times_s, 0.1), 1u);
  EXPECT_EQ(index_at(times_s, 0.19), 1u);
  EXPECT_EQ(index_at(times_s, 9), 2u);
  EXPECT_EQ(index_at({}, 0), std::nullopt);
}

/// A robot that drives 1 m along x in 1 s, and a map of 4 x 1 cells of 0.5 m.
RobotView robot_with_map() {
  RobotView robot;
  for (int i = 0; i <= 10; ++i) {
    robot.track.times_s.push_back(i * 0.1);
    robot.track.x_m.push_back(i * 0.1);
    robot.track.y_m.push_back(0.25);
  }
  const MapFrame before{0, {0, 0}, 4, 1, {}, {}, {}, {0, 0, 0, 0}};
  MapFrame after = before;
  after.time_s = 1;
  after.inhibited[1] = 3;
  robot.maps.push_back({"router", 0.5, {before, after}});
  return robot;
}

TEST(FailedAttempts, GoFromWhereTheRobotWasNearestToTheCellThatWasInhibited) {
  const auto attempts = failed_attempts(robot_with_map());
  ASSERT_EQ(attempts.size(), 1u);
  EXPECT_EQ(attempts[0].to, (Vector2{0.75, 0.25}));
  EXPECT_NEAR(attempts[0].from.x, 0.75, 0.06);
}

TEST(FailedAttempts, AreNotRepeatedWhileAnInhibitionLapses) {
  RobotView robot = robot_with_map();
  MapFrame later = robot.maps[0].frames.back();
  later.time_s = 2;
  later.inhibited[1] = 2;
  robot.maps[0].frames.push_back(later);
  EXPECT_EQ(failed_attempts(robot).size(), 1u);
  later.time_s = 3;
  later.inhibited[1] = 5;  // inhibited anew: a second failure
  robot.maps[0].frames.push_back(later);
  EXPECT_EQ(failed_attempts(robot).size(), 2u);
}

TEST(FailedAttempts, FollowACellThroughTheGrowthOfItsMap) {
  RobotView robot = robot_with_map();
  const MapFrame grown{2, {-0.5, 0}, 5, 1, {}, {}, {}, {0, 0, 3, 0, 0}};  // the same cell, one column further right
  robot.maps[0].frames.push_back(grown);
  EXPECT_EQ(failed_attempts(robot).size(), 1u);
}

TEST(Bounds, HoldTheRobotsBody) {
  RunView run;
  run.robots.push_back({.name = "robot0", .radius_m = 0.5});
  run.robots[0].track = {{0}, {2}, {3}, {0}, {0}};
  const Bounds bounds = bounds_of(run);
  EXPECT_EQ(bounds.lower, (Vector2{1.5, 2.5}));
  EXPECT_EQ(bounds.upper, (Vector2{2.5, 3.5}));
}

TEST(Bounds, AreOfSomeSizeForARunOfNothing) {
  const Bounds bounds = bounds_of({});
  EXPECT_LT(bounds.lower.x, bounds.upper.x);
  EXPECT_LT(bounds.lower.y, bounds.upper.y);
}

}  // namespace
}  // namespace ganglion::plot
