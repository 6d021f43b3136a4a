#include "ganglion/sim/drive/stepper/stepper.h"

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::driven;
using testing::made;

constexpr double kExact = 1e-12;
const Pose2 kStart{{0.25, 0.25}, Angle{}};  // centre of cell 0, 0 of the default 0.5 m

Pose2 stepped(Drive& drive, const Pose2& pose, double motion, double direction_deg) {
  drive.command(std::array{motion, Angle::from_deg(direction_deg).rad()}, pose, 1, true);
  return driven(drive, pose, 0.01, 100);
}

void expect_pose(const Pose2& pose, double x_m, double y_m, double yaw_deg) {
  EXPECT_NEAR(pose.position.x, x_m, kExact);
  EXPECT_NEAR(pose.position.y, y_m, kExact);
  EXPECT_NEAR((pose.yaw - Angle::from_deg(yaw_deg)).wrapped().rad(), 0, kExact);
}

TEST(Stepper, MovesToTheCentreOfTheNextCellWithinHalfAStep) {
  const auto drive = made(stepper_kind);
  expect_pose(stepped(*drive, kStart, 1, 0), 0.75, 0.25, 0);
  expect_pose(stepped(*drive, kStart, 1, 45), 0.75, 0.75, 45);
  drive->command(std::array{1.0, -kPi / 4}, kStart, 1, true);
  expect_pose(driven(*drive, kStart, 0.01, 50), 0.75, -0.25, -45);
}

TEST(Stepper, LooksAheadBackingOut) {
  const auto drive = made(stepper_kind);
  expect_pose(stepped(*drive, kStart, -1, 180), -0.25, 0.25, 0);
  expect_pose(stepped(*drive, kStart, -1, -135), -0.25, -0.25, 45);
}

TEST(Stepper, DoesNotCarryOutTurnsBeyondItsLimit) {
  const auto drive = made(stepper_kind);
  expect_pose(stepped(*drive, kStart, 1, 90), 0.25, 0.25, 0);
  expect_pose(stepped(*drive, kStart, 1, 180), 0.25, 0.25, 0);  // a half turn
  expect_pose(stepped(*drive, kStart, -1, 0), 0.25, 0.25, 0);   // the same, backwards
  expect_pose(stepped(*drive, kStart, -1, 90), 0.25, 0.25, 0);
  const auto agile = made(stepper_kind, {{"max_turn_deg", 180}});
  expect_pose(stepped(*agile, kStart, 1, 180), -0.25, 0.25, 180);
}

TEST(Stepper, StaysAndRoundsDirections) {
  const auto drive = made(stepper_kind);
  expect_pose(stepped(*drive, kStart, 0, 0), 0.25, 0.25, 0);
  expect_pose(stepped(*drive, kStart, 1, 22), 0.75, 0.25, 0);
  expect_pose(stepped(*drive, kStart, 1, 23), 0.75, 0.75, 45);
}

TEST(Stepper, GoesBackToWhereItCameFromOnContact) {
  const auto drive = made(stepper_kind);
  drive->command(std::array{1.0, kPi / 4}, kStart, 1, true);
  Pose2 pose = driven(*drive, kStart, 0.01, 20);
  EXPECT_GT(pose.position.x, 0.4);
  drive->move(pose, 0.01);
  drive->feel(true);  // something stopped it here
  expect_pose(driven(*drive, pose, 0.01, 79), 0.25, 0.25, 0);
}

TEST(Stepper, FinishesAMoveWhoseCommandLapses) {
  const auto drive = made(stepper_kind);
  drive->command(std::array{1.0, 0.0}, kStart, 1, true);
  const Pose2 pose = driven(*drive, kStart, 0.01, 10);
  drive->command(std::array{0.0, 0.0}, pose, 0.9, false);
  expect_pose(driven(*drive, pose, 0.01, 90), 0.75, 0.25, 0);
}

TEST(Stepper, ReachesNegativeCellsByTheirFloor) {
  const auto drive = made(stepper_kind);
  expect_pose(stepped(*drive, {{-0.25, -0.75}, Angle::from_deg(-90)}, 1, -90), -0.25, -1.25, -90);
}

}  // namespace
}  // namespace ganglion::sim
