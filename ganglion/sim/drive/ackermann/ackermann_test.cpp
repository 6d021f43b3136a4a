#include "ganglion/sim/drive/ackermann/ackermann.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::driven;
using testing::made;

constexpr double kExact = 1e-12;

void command(Drive& drive, double throttle, double steering_deg) {
  drive.command(std::array{throttle, Angle::from_deg(steering_deg).rad()}, Pose2{}, 1, true);
}

TEST(Ackermann, DrivesStraightAheadAndBack) {
  const auto drive = made(ackermann_kind);
  command(*drive, 1, 0);
  EXPECT_NEAR(driven(*drive, {}, 0.01, 100).position.x, 0.2, kExact);
  command(*drive, -0.5, 0);
  EXPECT_NEAR(driven(*drive, {}, 0.01, 100).position.x, -0.1, kExact);
}

TEST(Ackermann, TurnsOnTheCircleOfItsSteering) {
  // wheelbase 0.2 m, atan 0.5: the rear axle's circle has a radius of 0.4 m, the centre's sqrt(0.4^2 + 0.1^2).
  const auto drive = made(ackermann_kind, {{"steer_rate_degps", 0}});
  command(*drive, 1, Angle::from_rad(std::atan(0.5)).deg());
  const Pose2 start{{0.1, 0}, {}};                      // rear axle at the origin, the circle's centre at (0, 0.4)
  const Pose2 pose = driven(*drive, start, 0.01, 250);  // 0.5 m: 1.25 rad
  EXPECT_NEAR(pose.yaw.rad(), 1.25, 1e-9);
  EXPECT_NEAR(pose.position.x, 0.4 * std::sin(1.25) + 0.1 * std::cos(1.25), 1e-9);
  EXPECT_NEAR(pose.position.y, 0.4 * (1 - std::cos(1.25)) + 0.1 * std::sin(1.25), 1e-9);
}

TEST(Ackermann, BacksOutOnTheSameCircle) {
  const auto drive = made(ackermann_kind, {{"steer_rate_degps", 0}});
  command(*drive, 1, 20);
  const Pose2 there = driven(*drive, {}, 0.01, 200);
  command(*drive, -1, 20);
  const Pose2 back = driven(*drive, there, 0.01, 200);
  EXPECT_NEAR(back.position.length(), 0, 1e-9);
  EXPECT_NEAR(back.yaw.rad(), 0, 1e-9);
}

TEST(Ackermann, SteersAtItsRate) {
  const auto drive = made(ackermann_kind, {{"steer_rate_degps", 30}});
  command(*drive, 1, 30);
  // The steering grows as pi / 6 t for 1 s: turn = v / L integral of tan = 0.2 / 0.2 * 6 / pi * -ln cos 30 deg.
  EXPECT_NEAR(driven(*drive, {}, 0.001, 1000).yaw.rad(), 6 / kPi * -std::log(std::cos(kPi / 6)), 1e-6);
}

TEST(Ackermann, CannotTurnOnTheSpot) {
  const auto drive = made(ackermann_kind);
  command(*drive, 0, 30);
  EXPECT_EQ(driven(*drive, {}, 0.01, 100), Pose2{});
}

TEST(Ackermann, StatesItsLimits) {
  const auto drive = made(ackermann_kind, {{"max_steer_deg", 25}});
  EXPECT_EQ(drive->element(0).max, 1);
  EXPECT_NEAR(drive->element(1).min, -25 * kPi / 180, kExact);
  EXPECT_EQ(drive->element(1).unit, "rad");
}

TEST(Ackermann, PullsToOneSideWhenItsLinkageIsOutOfTrue) {
  const auto drive = made(ackermann_kind, {{"steer_offset_deg", 2}});
  command(*drive, 1, 0);
  EXPECT_NEAR(driven(*drive, {}, 0.01, 100).yaw.rad(), std::tan(Angle::from_deg(2).rad()), 1e-9);  // 0.2 m / 0.2 m
}

TEST(Ackermann, HasTheMotorsDeadZoneLagAndSag) {
  const auto dead = made(ackermann_kind, {{"dead_zone", 0.1}});
  command(*dead, 0.09, 0);
  EXPECT_EQ(driven(*dead, {}, 0.01, 10), Pose2{});
  const auto slow = made(ackermann_kind, {{"lag_s", 0.5}});
  command(*slow, 1, 0);
  EXPECT_NEAR(driven(*slow, {}, 0.01, 100).position.x, 0.11353352832366127, kExact);  // as Differential
  const auto weak = made(ackermann_kind);
  command(*weak, 1, 0);
  weak->supply(0.75);
  EXPECT_NEAR(driven(*weak, {}, 0.01, 100).position.x, 0.15, kExact);
}

TEST(Ackermann, TellsItsEffortAndTheWayOfItsRearWheels) {
  const auto drive = made(ackermann_kind, {{"steer_rate_degps", 0}});
  command(*drive, -0.5, Angle::from_rad(std::atan(0.5)).deg());
  const Movement movement = drive->move({}, 0.1);  // -0.01 m, turning by -0.025 rad
  EXPECT_NEAR(movement.left_m, -0.01 + 0.025 * 0.09, kExact);
  EXPECT_NEAR(movement.right_m, -0.01 - 0.025 * 0.09, kExact);
  EXPECT_EQ(movement.effort, 0.5);
}

}  // namespace
}  // namespace ganglion::sim
