#include <gtest/gtest.h>

#include "ganglion/geometry/pose2.h"

namespace ganglion {
namespace {

TEST(Pose2, CarriesPointsBetweenFrames) {
  const Pose2 pose{{1, 2}, Angle::from_deg(90)};
  const Vector2 outer = pose.to_outer({3, 0});  // 3 m ahead of a robot that faces y
  EXPECT_NEAR(outer.x, 1, 1e-15);
  EXPECT_NEAR(outer.y, 5, 1e-15);
  const Vector2 back = pose.to_local(outer);
  EXPECT_NEAR(back.x, 3, 1e-15);
  EXPECT_NEAR(back.y, 0, 1e-15);
}

TEST(Pose2, ChainsAndWraps) {
  const Pose2 pose = Pose2{{0, 0}, Angle::from_deg(170)}.then({{1, 0}, Angle::from_deg(20)});
  EXPECT_NEAR(pose.yaw.deg(), -170, 1e-12);
}

TEST(NearestOnSegment, ClampsToTheEnds) {
  EXPECT_EQ(nearest_on_segment({5, 3}, {0, 0}, {10, 0}), (Vector2{5, 0}));
  EXPECT_EQ(nearest_on_segment({-5, 3}, {0, 0}, {10, 0}), (Vector2{0, 0}));
  EXPECT_EQ(nearest_on_segment({1, 1}, {2, 2}, {2, 2}), (Vector2{2, 2}));
}

}  // namespace
}  // namespace ganglion
