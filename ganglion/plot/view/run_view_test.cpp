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
