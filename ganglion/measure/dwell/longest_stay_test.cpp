#include "ganglion/measure/dwell/longest_stay.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion {
namespace {

TEST(SmallestCircle, OfATriangleAndOfALine) {
  const Circle right =
      smallest_circle({{0, 0}, {3, 0}, {0, 4}, {1, 1}});  // a right angle: the hypotenuse is a diameter
  EXPECT_NEAR(right.radius_m, 2.5, 1e-12);
  EXPECT_NEAR(right.centre.x, 1.5, 1e-12);
  const Circle equilateral = smallest_circle({{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}});
  EXPECT_NEAR(equilateral.radius_m, 1 / std::sqrt(3), 1e-12);
  EXPECT_NEAR(smallest_circle({{0, 0}, {1, 0}, {4, 0}, {2, 0}}).radius_m, 2, 1e-12);
}

TEST(LongestStay, CountsTheTimeToAndFroButNotTheWayAlong) {
  LongestStay to_and_fro(0.5, 1), along(0.5, 1);
  for (int second = 0; second <= 60; ++second) {
    to_and_fro.add(second, {second % 2 == 0 ? 0.0 : 0.9, 0});  // within a disc of radius 0.45
    along.add(second, {0.1 * second, 0});                      // leaves any such disc after 1 m
  }
  EXPECT_EQ(to_and_fro.longest_s(), 60);
  EXPECT_EQ(along.longest_s(), 10);
}

TEST(LongestStay, StartsAnewAfterStandingStillOnPurpose) {
  LongestStay dwell(0.5, 1);
  for (int second = 0; second <= 20; ++second) {
    if (second == 8) dwell.interrupt();
    dwell.add(second, {0, 0});
  }
  EXPECT_EQ(dwell.longest_s(), 12);
}

}  // namespace
}  // namespace ganglion
