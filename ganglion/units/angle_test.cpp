#include "ganglion/units/angle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion {
namespace {

TEST(Angle, WrapsIntoTheHalfOpenTurn) {
  EXPECT_EQ(Angle::from_rad(kPi).wrapped().rad(), kPi);
  EXPECT_EQ(Angle::from_rad(-kPi).wrapped().rad(), kPi);
  EXPECT_NEAR(Angle::from_deg(350 - 10).wrapped().deg(), -20, 1e-12);
  EXPECT_NEAR(Angle::from_deg(-725).wrapped().deg(), -5, 1e-12);
  EXPECT_TRUE(std::isnan(Angle::from_rad(NAN).wrapped().rad()));
}

TEST(Compass, RunsClockwiseFromNorth) {
  EXPECT_EQ(compass_deg_from_yaw(Angle::from_deg(90)), 0);  // facing y is north
  EXPECT_EQ(compass_deg_from_yaw(Angle::from_deg(0)), 90);  // facing x is east
  EXPECT_EQ(compass_deg_from_yaw(Angle::from_deg(180)), 270);
  EXPECT_NEAR(yaw_from_compass_deg(300).deg(), 150, 1e-12);  // the paper's run at 300 deg
}

}  // namespace
}  // namespace ganglion
