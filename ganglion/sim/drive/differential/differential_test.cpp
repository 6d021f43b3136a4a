#include "ganglion/sim/drive/differential/differential.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::driven;
using testing::made;

constexpr double kExact = 1e-12;

void command(Drive& drive, double left, double right) { drive.command(std::array{left, right}, Pose2{}, 1, true); }

TEST(Differential, DrivesStraightUnderEqualDuties) {
  const auto drive = made(differential_kind);  // 0.2 m/s, 0.18 m
  command(*drive, 0.5, 0.5);
  const Pose2 pose = driven(*drive, {{1, 2}, Angle::from_deg(90)}, 0.01, 100);
  EXPECT_NEAR(pose.position.x, 1, kExact);
  EXPECT_NEAR(pose.position.y, 2.1, kExact);
}

TEST(Differential, TurnsOnTheArcOfItsWheelSpeeds) {
  const auto drive = made(differential_kind);
  command(*drive, 0.5, 1);  // 0.10 and 0.20 m/s: 0.15 m/s at 0.1 / 0.18 = 0.5556 rad/s, so a radius of 0.27 m
  const Pose2 pose = driven(*drive, {}, 0.01, 100);
  EXPECT_NEAR(pose.yaw.rad(), 0.1 / 0.18, kExact);
  EXPECT_NEAR(pose.position.x, 0.27 * std::sin(0.1 / 0.18), kExact);
  EXPECT_NEAR(pose.position.y, 0.27 * (1 - std::cos(0.1 / 0.18)), kExact);
}

TEST(Differential, TurnsOnTheSpotUnderOppositeDuties) {
  const auto drive = made(differential_kind);
  command(*drive, -0.5, 0.5);  // 2 * 0.1 / 0.18 rad/s counter-clockwise
  const Pose2 pose = driven(*drive, {}, 0.01, 50);
  EXPECT_NEAR(pose.yaw.rad(), 0.1 / 0.18, kExact);
  EXPECT_NEAR(pose.position.length(), 0, kExact);
}

TEST(Differential, DriftsTowardsItsWeakerSide) {
  const auto drive = made(differential_kind, {{"right_gain", 0.95}});
  command(*drive, 1, 1);  // 0.20 and 0.19 m/s: clockwise at 0.01 / 0.18 rad/s
  EXPECT_NEAR(driven(*drive, {}, 0.01, 100).yaw.rad(), -0.01 / 0.18, kExact);
}

TEST(Differential, StandsInItsDeadZoneAndMovesUnshiftedBeyondIt) {
  const auto drive = made(differential_kind, {{"dead_zone", 0.05}});
  command(*drive, 0.049, -0.049);
  EXPECT_EQ(driven(*drive, {}, 0.01, 100), Pose2{});
  command(*drive, 0.05, 0.05);
  EXPECT_NEAR(driven(*drive, {}, 0.01, 100).position.x, 0.01, kExact);
}

TEST(Differential, FollowsItsDutiesWithTheLagOfItsMotors) {
  const auto drive = made(differential_kind, {{"lag_s", 0.5}});
  command(*drive, 1, 1);
  // v = V (1 - e^-2t), so after 1 s x = V (1 - 0.5 (1 - e^-2)) = 0.2 (1 - 0.5 * 0.8646647167633873)
  EXPECT_NEAR(driven(*drive, {}, 0.01, 100).position.x, 0.11353352832366127, kExact);
  command(*drive, 0, 0);  // and rolls out V (1 - e^-2) 0.5 farther
  EXPECT_NEAR(driven(*drive, {}, 0.01, 3000).position.x, 0.08646647167633873, 1e-10);
  drive->reset();
  EXPECT_EQ(driven(*drive, {}, 0.01, 10), Pose2{});
}

TEST(Differential, TellsItsEffortAndTheWayOfItsWheels) {
  const auto drive = made(differential_kind);
  command(*drive, -0.5, 1);
  const Movement movement = drive->move({}, 0.1);
  EXPECT_NEAR(movement.left_m, -0.01, kExact);
  EXPECT_NEAR(movement.right_m, 0.02, kExact);
  EXPECT_NEAR(movement.effort, 0.75, kExact);
}

}  // namespace
}  // namespace ganglion::sim
