#include "ganglion/sim/sensor/dinsmore_compass/dinsmore_compass.h"

#include <cmath>
#include <optional>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

std::array<double, 2> read_V(Sensor& compass, const Scene& scene) {
  std::array<double, 2> values{};
  Draws draws(StreamId{}, 0);
  compass.measure(scene, draws, values);
  return values;
}

/// Volts of a needle at rest at a bearing clockwise from north.
std::array<double, 2> at_rest_V(Stage& stage, double bearing_deg) {
  const auto compass = made(dinsmore_compass_kind);
  const Scene scene = stage.at({{0, 0}, yaw_from_compass_deg(bearing_deg)});
  EXPECT_TRUE(compass->reset(scene, Draws(StreamId{}, 0)));
  return read_V(*compass, scene);
}

/// The listing's regions, as printed.
std::optional<double> listing_bearing_deg(double va, double vb) {
  const double gradient = va - vb + 10;
  std::optional<double> heading;
  if (va >= 2.08 && va <= 2.92 && gradient <= 10) heading = 45 + 107.14 * (2.92 - va);
  if (va >= 2.08 && va <= 2.92 && gradient >= 10) heading = 225 + 107.14 * (va - 2.08);
  if (vb >= 2.08 && vb <= 2.92 && gradient <= 10) heading = 135 + 107.14 * (2.92 - vb);
  if (vb >= 2.5 && vb <= 2.92 && gradient >= 10) heading = 107.14 * (vb - 2.5);
  if (vb >= 2.08 && vb < 2.5 && gradient >= 10) heading = 315 + 107.14 * (vb - 2.08);
  return heading;
}

// 2.5 V is count 512 of 1024; 0.594 V are 121.65 counts: 633 = 3.0908 V above, 390 = 1.9043 V below (cut off).
TEST(DinsmoreCompass, GivesItsVoltsAtTheCardinalBearings) {
  Stage stage;
  const double low_V = 390 * 5.0 / 1024, high_V = 633 * 5.0 / 1024;
  const double step_V = 5.0 / 1024;  // the centre lies on the edge between two counts
  const auto north = at_rest_V(stage, 0), east = at_rest_V(stage, 90);
  const auto south = at_rest_V(stage, 180), west = at_rest_V(stage, 270);
  EXPECT_NEAR(north[0], high_V, 1e-12);
  EXPECT_NEAR(north[1], 2.5, step_V);
  EXPECT_NEAR(east[0], 2.5, step_V);
  EXPECT_NEAR(east[1], high_V, 1e-12);
  EXPECT_NEAR(south[0], low_V, 1e-12);
  EXPECT_NEAR(south[1], 2.5, step_V);
  EXPECT_NEAR(west[0], 2.5, step_V);
  EXPECT_NEAR(west[1], low_V, 1e-12);
}

TEST(DinsmoreCompass, IsReadRightByTheArcTangent) {
  Stage stage;
  for (int bearing_deg = 0; bearing_deg < 360; bearing_deg += 7) {
    const auto volts = at_rest_V(stage, bearing_deg);
    const double read_deg = Angle::from_rad(std::atan2(volts[1] - 2.5, volts[0] - 2.5)).deg();
    EXPECT_NEAR(std::remainder(read_deg - bearing_deg, 360), 0, 0.7) << bearing_deg;  // a count is 0.47 deg
  }
}

TEST(DinsmoreCompass, IsReadByTheListingWithinItsOwnErrorAwayFromItsSeams) {
  Stage stage;
  for (const int bearing_deg : {0, 20, 70, 90, 110, 160, 180, 200, 250, 270, 290, 340}) {
    const auto volts = at_rest_V(stage, bearing_deg);
    const auto read_deg = listing_bearing_deg(volts[0], volts[1]);
    ASSERT_TRUE(read_deg) << bearing_deg;
    EXPECT_NEAR(std::remainder(*read_deg - bearing_deg, 360), 0, 3) << bearing_deg;  // its lines replace a sine
  }
}

TEST(DinsmoreCompass, SettlesWithItsTimeConstant) {
  Stage stage;
  const auto compass = made(dinsmore_compass_kind, {{"bits", 0}});
  const Scene east = stage.at({});
  const Pose2 west{{0, 0}, Angle::from_deg(180)};
  ASSERT_TRUE(compass->reset(east, Draws(StreamId{}, 0)));
  for (int n = 0; n < 150; ++n) compass->follow(stage.at(west), 0.01);
  // After 1.5 s of 1 s: sine from 1 towards -1, -1 + 2 e^-1.5 = -0.553740.
  EXPECT_NEAR(read_V(*compass, stage.at(west))[1], 2.5 - 0.594 * 0.553740, 1e-6);
}

}  // namespace
}  // namespace ganglion::sim
