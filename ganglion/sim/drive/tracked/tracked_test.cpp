#include "ganglion/sim/drive/tracked/tracked.h"

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

TEST(Tracked, TurnsAsIfItsTracksStoodFartherApart) {
  const auto drive = testing::made(tracked_kind, {{"skid_factor", 2}});
  drive->command(std::array{-1.0, 1.0}, Pose2{}, 1, true);
  EXPECT_NEAR(testing::driven(*drive, {}, 0.01, 50).yaw.rad(), 0.5 * 0.4 / 0.36, 1e-12);  // not 0.4 / 0.18
}

TEST(Tracked, GoesAsFarAsWheelsDoOnAStraightLine) {
  const auto drive = testing::made(tracked_kind, {{"skid_factor", 2}});
  drive->command(std::array{1.0, 1.0}, Pose2{}, 1, true);
  EXPECT_NEAR(testing::driven(*drive, {}, 0.01, 50).position.x, 0.1, 1e-12);
}

}  // namespace
}  // namespace ganglion::sim
