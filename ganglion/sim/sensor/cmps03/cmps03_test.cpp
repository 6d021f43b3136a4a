#include "ganglion/sim/sensor/cmps03/cmps03.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;
using testing::turned;

struct Reading {
  double heading_deg = 0;
  double bearing = 0;
};

Reading read(Sensor& compass, const Scene& scene, std::uint32_t tick = 0) {
  std::array<double, 2> values{};
  Draws draws(StreamId{2, 0, 0, 4}, tick);
  compass.measure(scene, draws, values);
  return {Angle::from_rad(values[0]).deg(), values[1]};
}

TEST(Cmps03, CountsTenthsOfADegreeClockwiseFromNorth) {
  Stage stage;
  const auto compass = made(cmps03_kind, {{"accuracy_deg", 0}, {"noise_deg", 0}});
  EXPECT_EQ(compass->turn(0), 0);
  EXPECT_EQ(compass->turn(1), 3600);
  EXPECT_EQ(read(*compass, stage.at(turned(90))).bearing, 0);
  EXPECT_EQ(read(*compass, stage.at(turned(0))).bearing, 900);
  EXPECT_EQ(read(*compass, stage.at(turned(-90))).bearing, 1800);
  EXPECT_EQ(read(*compass, stage.at(turned(90.1))).bearing, 3599);
  EXPECT_EQ(read(*compass, stage.at(turned(90.04))).bearing, 0);
  EXPECT_NEAR(read(*compass, stage.at(turned(12.34))).heading_deg, 12.3, 1e-9);
  EXPECT_NEAR(read(*compass, stage.at(turned(-179.98))).heading_deg, 180, 1e-9);
}

TEST(Cmps03, IsBiasedByThePlaceWithinItsAccuracy) {
  Stage stage;
  const auto compass = made(cmps03_kind, {{"noise_deg", 0}});
  double squares = 0, sum = 0, largest = 0;
  const int side = 50;  // 10 x 10 m in steps of 0.2 m: whole periods of 5 m
  ASSERT_TRUE(compass->reset(stage.at({}), Draws(StreamId{4, 0, 0, 1}, 0)));
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double bias_deg = read(*compass, stage.at({{column * 0.2, row * 0.2}, {}})).heading_deg;
      sum += bias_deg;
      squares += bias_deg * bias_deg;
      largest = std::max(largest, std::fabs(bias_deg));
    }
  }
  // Two waves of 1.75 deg: mean 0, mean square 2 * 1.75^2 / 2, root 1.75; rounding to 0.1 deg adds 0.1^2 / 12.
  EXPECT_NEAR(sum / (side * side), 0, 0.01);
  EXPECT_NEAR(std::sqrt(squares / (side * side)), 1.75, 0.01);
  EXPECT_LE(largest, 3.55);
  EXPECT_GT(largest, 3);
}

TEST(Cmps03, FindsTheSameBiasAgainAndAnotherInTheNextEpisode) {
  Stage stage;
  const auto compass = made(cmps03_kind, {{"noise_deg", 0}});
  ASSERT_TRUE(compass->reset(stage.at({}), Draws(StreamId{4, 0, 0, 1}, 0)));
  const double here = read(*compass, stage.at({{1, 2}, {}})).heading_deg;
  const double a_period_on = read(*compass, stage.at({{6, -3}, {}}), 7).heading_deg;
  EXPECT_NEAR(here, a_period_on, 1e-9);
  ASSERT_TRUE(compass->reset(stage.at({}), Draws(StreamId{4, 1, 0, 1}, 0)));
  EXPECT_NE(read(*compass, stage.at({{1, 2}, {}})).heading_deg, here);
}

TEST(Cmps03, ScattersAsStated) {
  Stage stage;
  const auto compass = made(cmps03_kind, {{"accuracy_deg", 0}, {"noise_deg", 0.5}});
  const int count = 4000;
  double sum = 0, squares = 0;
  for (int n = 0; n < count; ++n) {
    const double error_deg = read(*compass, stage.at(turned(30)), static_cast<std::uint32_t>(n)).heading_deg - 30;
    sum += error_deg;
    squares += error_deg * error_deg;
  }
  // Rounding to 0.1 deg adds 0.1^2 / 12 to the variance: 0.5008 deg.
  EXPECT_NEAR(sum / count, 0, 4 * 0.5 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.5008, 4 * 0.5 / std::sqrt(2.0 * count));
}

}  // namespace
}  // namespace ganglion::sim
