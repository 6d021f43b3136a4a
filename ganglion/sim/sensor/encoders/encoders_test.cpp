#include "ganglion/sim/sensor/encoders/encoders.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

TEST(Encoders, CutOffToWholeCountsAndScale) {
  testing::Stage stage;
  stage.robot.left_m = 0.128;
  stage.robot.right_m = -0.101;
  const auto encoders = testing::made(encoders_kind, {{"resolution_m", 0.01}, {"right_scale", 1.1}});
  std::array<double, 2> values{};
  Draws draws(StreamId{}, 0);
  encoders->measure(stage.at({}), draws, values);
  EXPECT_NEAR(values[0], 0.12, 1e-12);
  EXPECT_NEAR(values[1], -0.12, 1e-12);  // -0.1111 down to a whole count
}

TEST(Encoders, ScatterWithTheRootOfTheWayHoweverOftenTheyFire) {
  testing::Stage stage;
  const auto encoders = testing::made(encoders_kind, {{"scatter_m", 0.02}});
  const int count = 4000;
  for (const int firings : {1, 25}) {
    double sum = 0, left = 0, right = 0, both = 0;
    for (int n = 0; n < count; ++n) {
      ASSERT_TRUE(encoders->reset(stage.at({}), Draws(StreamId{}, 0)));
      std::array<double, 2> values{};
      for (int k = 1; k <= firings; ++k) {
        stage.robot.left_m = 4.0 * k / firings;
        stage.robot.right_m = -1.0 * k / firings;
        Draws draws(StreamId{static_cast<std::uint64_t>(n), 0, 0, 1}, static_cast<std::uint32_t>(k));
        encoders->measure(stage.at({}), draws, values);
      }
      sum += values[0] - 4;
      left += std::pow(values[0] - 4, 2);
      right += std::pow(values[1] + 1, 2);
      both += (values[0] - 4) * (values[1] + 1);
    }
    // 0.02 m after 1 m, 0.04 m after 4 m; four standard errors.
    EXPECT_NEAR(sum / count, 0, 4 * 0.04 / std::sqrt(count));
    EXPECT_NEAR(std::sqrt(left / count), 0.04, 4 * 0.04 / std::sqrt(2.0 * count));
    EXPECT_NEAR(std::sqrt(right / count), 0.02, 4 * 0.02 / std::sqrt(2.0 * count));
    EXPECT_NEAR(both / count, 0, 4 * 0.04 * 0.02 / std::sqrt(count));
  }
}

}  // namespace
}  // namespace ganglion::sim
