#include "ganglion/sim/sensor/bumper/bumper.h"

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

double read(Sensor& bumper, const Scene& scene) {
  double value = -1;
  Draws draws(StreamId{}, 0);
  bumper.measure(scene, draws, {&value, 1});
  return value;
}

/// A sub-step during which the robot touches something, or does not.
void follow(Sensor& bumper, Stage& stage, bool touching) {
  stage.robot.touching = touching;
  bumper.follow(stage.at({}), 0.01);
}

TEST(Bumper, RemembersATouchUntilItHasToldIt) {
  Stage stage;
  const auto bumper = made(bumper_kind);
  EXPECT_EQ(read(*bumper, stage.at({})), 0);
  follow(*bumper, stage, true);
  follow(*bumper, stage, false);
  EXPECT_EQ(read(*bumper, stage.at({})), 1);
  EXPECT_EQ(read(*bumper, stage.at({})), 0);
}

TEST(Bumper, ForgetsWithTheEpisode) {
  Stage stage;
  const auto bumper = made(bumper_kind);
  follow(*bumper, stage, true);
  ASSERT_TRUE(bumper->reset(stage.at({}), Draws(StreamId{}, 0)));
  EXPECT_EQ(read(*bumper, stage.at({})), 0);
}

}  // namespace
}  // namespace ganglion::sim
