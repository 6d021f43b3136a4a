#include "ganglion/sim/sensor/encoders/encoders.h"

#include "ganglion/sim/robot/testing.h"

namespace ganglion::sim {
namespace {

TEST(Encoders, CutOffToWholeCountsAndScale) {
  testing::Stage stage("format = 1\nname = \"w\"\n[[wall]]\npoints = [[90, -9], [90, 9]]\n");
  stage.robot.left_m = 0.128;
  stage.robot.right_m = -0.101;
  const auto encoders = testing::made(encoders_kind, {{"resolution_m", 0.01}, {"right_scale", 1.1}});
  std::array<double, 2> values{};
  Draws draws(StreamId{}, 0);
  encoders->measure(stage.at({}), draws, values);
  EXPECT_NEAR(values[0], 0.12, 1e-12);
  EXPECT_NEAR(values[1], -0.12, 1e-12);  // -0.1111 down to a whole count
}

}  // namespace
}  // namespace ganglion::sim
