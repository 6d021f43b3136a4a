#include <cmath>

#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

using testing::at;
using testing::kFast;
using testing::kRoom;
using testing::Trial;

std::string with(const std::string& floor) { return std::string(kRoom) + floor; }
const std::string kEncoders = "[[sensor]]\nid = \"e\"\nkind = \"Encoders\"\n";
std::string body(const std::string& keys) {
  return "format = 1\nname = \"r\"\n[body]\nlength_m = 0.2\nwidth_m = 0.2\nradius_m = 0.1\n" + keys + kFast;
}

TEST(FloorRide, LosesTheSlipAndTheEncodersDoNotNotice) {
  Trial trial(with("[[floor]]\nx_m = 5\ny_m = 5\nlength_m = 8\nwidth_m = 8\nslip = 0.25\n"), kFast + kEncoders,
              at(2, 5));
  trial.go({0.5, 0.5}, 0.1, 20);  // 1 m of wheels
  EXPECT_NEAR(trial.truth().pose.position.x, 2.75, 1e-9);
  EXPECT_NEAR(trial.truth().travelled_m, 0.75, 1e-9);
  EXPECT_NEAR(trial.value("e.left"), 1, 1e-9);
  trial.reset(1, 0);
  trial.go({-0.1, 0.1}, 0.1, 10);  // 1 rad of wheels
  EXPECT_NEAR(trial.truth().pose.yaw.rad(), 0.75, 1e-9);
}

TEST(FloorRide, SlipsUnevenlyAsStated) {
  Trial trial(with("[[floor]]\nx_m = 5\ny_m = 5\nlength_m = 10\nwidth_m = 10\nslip = 0.3\nslip_spread = 0.05\n"), kFast,
              at(1, 5));
  const int count = 2000;
  double sum = 0, squares = 0, turns = 0;
  for (int n = 0; n < count; ++n) {
    trial.reset(static_cast<std::uint64_t>(n), 0);
    trial.go({0.5, 0.5}, 0.1);  // 0.05 m of wheels in one step
    const double lost = 1 - trial.truth().travelled_m / 0.05;
    sum += lost;
    squares += (lost - 0.3) * (lost - 0.3);
    turns += std::pow(trial.truth().pose.yaw.rad(), 2);
  }
  // Mean of two sides: 0.05 / sqrt 2. Their difference, 0.05 sqrt 2 of 0.05 m, turns over a width of 0.2 m.
  const double spread = 0.05 / std::sqrt(2), turn_rad = 0.05 * std::sqrt(2) * 0.05 / 0.2;
  EXPECT_NEAR(sum / count, 0.3, 4 * spread / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), spread, 4 * spread / std::sqrt(2.0 * count));
  EXPECT_NEAR(std::sqrt(turns / count), turn_rad, 4 * turn_rad / std::sqrt(2.0 * count));
}

TEST(FloorRide, IsTurnedByABumpThatSonarsDoNotSee) {
  const std::string world = with("[[bump]]\npoints = [[3, 0], [3, 10]]\nturn_deg = 6\n");
  Trial trial(world, kFast + "[[sensor]]\nid = \"s\"\nkind = \"Sonar\"\nnoise_m = 0\nmax_range_m = 9\n", at(2.5, 5));
  EXPECT_NEAR(trial.value("s.range"), 7.5, 1e-3);
  const int count = 2000;
  double sum = 0, squares = 0;
  for (int n = 0; n < count; ++n) {
    trial.reset(static_cast<std::uint64_t>(n), 0);
    trial.go({1, 1}, 0.1, 4);
    ASSERT_EQ(trial.truth().pose.yaw.rad(), 0);  // not there yet
    trial.go({1, 1}, 0.1, 4);
    sum += trial.truth().pose.yaw.deg();
    squares += std::pow(trial.truth().pose.yaw.deg(), 2);
  }
  EXPECT_NEAR(sum / count, 0, 4 * 6 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 6, 4 * 6 / std::sqrt(2.0 * count));
  EXPECT_EQ(trial.truth().contacts, 0);
}

const std::string kRamp = "[[floor]]\nx_m = 6\ny_m = 5\nlength_m = 4\nwidth_m = 8\nslope_deg = 20\n";

TEST(FloorRide, StallsWhereItIsTooSteepAndCanTurnAway) {
  Problems problems;
  const auto model = parse_robot(body("climb_deg = 15\n"), "robot.toml", testing::kKinds, problems);
  ASSERT_TRUE(model) << problems.text();
  Trial trial(testing::ground_of(with(kRamp)), model, at(3.5, 5), 1);
  trial.go({0.5, 0.5}, 0.1, 40);
  EXPECT_NEAR(trial.truth().pose.position.x, 4, 0.011);  // at the foot of the ramp, a sub-step in
  EXPECT_TRUE(trial.truth().stalled);
  EXPECT_NEAR(trial.truth().left_m, 2, 1e-9);  // the wheels spin
  EXPECT_FALSE(trial.truth().touching);
  trial.go({-0.2, 0.2}, 0.1, 8);  // 1.6 rad to the left: along the slope it is level
  trial.go({0.5, 0.5}, 0.1, 10);
  EXPECT_GT(trial.truth().pose.position.y, 5.4);
  EXPECT_FALSE(trial.truth().stalled);
}

TEST(FloorRide, TipsOverForGood) {
  Problems problems;
  const auto model = parse_robot(body("tip_deg = 18\n"), "robot.toml", testing::kKinds, problems);
  ASSERT_TRUE(model) << problems.text();
  Trial trial(testing::ground_of(with(kRamp)), model, at(3.5, 5), 1);
  trial.go({0.5, 0.5}, 0.1, 40);
  EXPECT_TRUE(trial.truth().tipped);
  const Pose2 lies = trial.truth().pose;
  trial.go({-1, -1}, 0.1, 10);
  trial.go({-1, 1}, 0.1, 10);
  EXPECT_EQ(trial.truth().pose, lies);
  trial.reset(1, 0);
  EXPECT_FALSE(trial.truth().tipped);
  Trial sturdy(with(kRamp), kFast, at(3.5, 5));
  sturdy.go({0.5, 0.5}, 0.1, 40);
  EXPECT_FALSE(sturdy.truth().tipped);
  EXPECT_FALSE(sturdy.truth().stalled);
  EXPECT_GT(sturdy.truth().pose.position.x, 4.9);
}

/// A drive that just climbs 30 deg, on a slope of 10 deg that rises along x: sin 10 deg / sin 30 deg = 0.347296.
constexpr double kLoad = 0.347296355;
Trial on_the_slope(double yaw_deg) {
  Problems problems;
  const auto model = parse_robot(body("climb_deg = 30\n") + kEncoders + "[energy]\nidle_W = 1\ndrive_W = 4\n", "r.toml",
                                 testing::kKinds, problems);
  EXPECT_TRUE(model) << problems.text();
  const std::string slope = "[[floor]]\nx_m = 5\ny_m = 5\nlength_m = 9\nwidth_m = 9\nslope_deg = 10\n";
  return {testing::ground_of(with(slope)), model, at(5, 5, yaw_deg), 1};
}

TEST(FloorRide, GoesSlowerAndTakesMorePowerUphill) {
  Trial trial = on_the_slope(0);
  trial.go({0.5, 0.5}, 0.1, 20);  // 1 m on level ground
  EXPECT_NEAR(trial.truth().pose.position.x, 5 + 1 - kLoad, 1e-6);
  EXPECT_NEAR(trial.value("e.left"), 1 - kLoad, 1e-6);
  EXPECT_NEAR(trial.value("e.right"), 1 - kLoad, 1e-6);
  EXPECT_NEAR(trial.truth().energy_J, 2 * (1 + 4 * 0.5 * (1 + kLoad)), 1e-6);
  Trial backwards = on_the_slope(180);
  backwards.go({-0.5, -0.5}, 0.1, 20);
  EXPECT_NEAR(backwards.truth().pose.position.x, 5 + 1 - kLoad, 1e-6);
  EXPECT_NEAR(backwards.value("e.left"), -1 + kLoad, 1e-6);
}

TEST(FloorRide, TakesLessPowerDownhillAndGoesNoFaster) {
  Trial trial = on_the_slope(180);
  trial.go({0.5, 0.5}, 0.1, 20);
  EXPECT_NEAR(trial.truth().pose.position.x, 4, 1e-6);
  EXPECT_NEAR(trial.truth().energy_J, 2 * (1 + 4 * 0.5 * (1 - kLoad)), 1e-6);
}

TEST(FloorRide, CountsOnlyTheSlopeAlongTheWay) {
  Trial along = on_the_slope(90);  // a contour line
  along.go({0.5, 0.5}, 0.1, 20);
  EXPECT_NEAR(along.truth().pose.position.y, 6, 1e-6);
  EXPECT_NEAR(along.truth().energy_J, 2 * (1 + 4 * 0.5), 1e-6);
  Trial aslant = on_the_slope(60);  // rises by tan 10 deg / 2 a metre: sin atan 0.0881635 = 0.0878229, / sin 30 deg
  aslant.go({0.5, 0.5}, 0.1, 20);
  EXPECT_NEAR(aslant.truth().travelled_m, 1 - 0.1756458, 1e-6);
  Trial turning = on_the_slope(0);
  turning.go({-0.1, 0.1}, 0.1, 10);
  EXPECT_NEAR(turning.truth().pose.yaw.rad(), 1, 1e-9);
  EXPECT_NEAR(turning.truth().energy_J, 1 + 4 * 0.1, 1e-9);
}

// A battery of 400 J under 20 W and 0.4 ohm, 10 V full and 8 V empty.
const std::string kBattery =
    "[energy]\nidle_W = 0\ndrive_W = 20\n[battery]\ncapacity_J = 400\nfull_V = 10\nempty_V = 8\nresistance_ohm = 0.4\n";

TEST(Battery, SagsUnderLoadAndWithItsCharge) {
  Trial trial(kRoom, kFast + kBattery, at(1, 5));
  EXPECT_EQ(trial.truth().battery_V, 10);
  EXPECT_EQ(trial.truth().charge, 1);
  trial.go({0, 0}, 0.1, 10);
  EXPECT_EQ(trial.truth().battery_V, 10);
  trial.go({0.5, 0.5}, 0.1, 100);  // 10 W for 10 s: 100 J
  EXPECT_NEAR(trial.truth().charge, 0.75, 1e-9);
  // Open 9.5 V: 4.75 + sqrt(4.75^2 - 0.4 * 10) = 9.05842 V.
  EXPECT_NEAR(trial.truth().battery_V, 9.05842, 1e-5);
}

TEST(Battery, SlowsTheDriveDown) {
  Trial trial(kRoom, kFast + kBattery + "charge = 0.5\n", at(1, 5));
  trial.go({1, 1}, 0.1);
  trial.reset(1, 0);
  trial.go({0.01, 0.01}, 0.1);
  // Open 9 V of 10, all but without load: 0.9 of 0.01 m/s, less 0.4 * 0.2 / 9 = 0.0089 V.
  EXPECT_NEAR(trial.truth().travelled_m, 0.1 * 0.01 * 0.9, 2e-6);
}

TEST(Battery, IsEmptyInTheEndAndTheRobotStands) {
  Trial trial(kRoom, kFast + kBattery, at(5, 5));
  trial.go({-1, 1}, 0.1, 210);  // 20 W: empty after 20 s
  EXPECT_EQ(trial.truth().charge, 0);
  EXPECT_EQ(trial.truth().battery_V, 0);
  const Pose2 there = trial.truth().pose;
  trial.go({1, 1}, 0.1, 10);
  EXPECT_EQ(trial.truth().pose, there);
}

TEST(Battery, GivesNoMoreThanItCan) {
  const BatteryModel battery{100, 10, 8, 1, 1};
  EXPECT_NEAR(battery.voltage_V(1, 25), 5, 1e-12);  // the most: open^2 / 4 R
  EXPECT_NEAR(battery.voltage_V(1, 1000), 5, 1e-12);
  EXPECT_NEAR(battery.voltage_V(1, 24), 6, 1e-12);  // 4 A: 10 V - 4 V
  EXPECT_EQ(battery.voltage_V(0, 0), 0);
}

TEST(Battery, IsReadFromTheFile) {
  Problems problems;
  EXPECT_FALSE(parse_robot(body("") + "[battery]\nfull_V = 5\n", "robot.toml", testing::kKinds, problems));
  EXPECT_NE(problems.text().find("empty_V is 6, must be <= full_V = 5"), std::string::npos) << problems.text();
}

}  // namespace
}  // namespace ganglion::sim
