#include "ganglion/sim/sensor/position/position.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

std::array<double, 2> read_m(Sensor& sensor, const Scene& scene, std::uint32_t tick = 0) {
  std::array<double, 2> values{};
  Draws draws(StreamId{}, tick);
  sensor.measure(scene, draws, values);
  return values;
}

TEST(Position, TellsWhereItsMountIs) {
  Stage stage;
  const auto sensor = made(position_kind);
  EXPECT_EQ(read_m(*sensor, stage.at({{1.5, -2}, {}})), (std::array<double, 2>{1.5, -2}));
}

TEST(Position, ScattersEachCoordinateAsStated) {
  Stage stage;
  const auto sensor = made(position_kind, {{"noise_m", 0.2}});
  double x = 0, y = 0, both = 0;
  for (std::uint32_t n = 0; n < 4000; ++n) {
    const auto at_m = read_m(*sensor, stage.at({{0, 0}, {}}), n);
    x += at_m[0] * at_m[0];
    y += at_m[1] * at_m[1];
    both += at_m[0] * at_m[1];
  }
  const double tolerance_m = 4 * 0.2 / std::sqrt(8000.0);  // four standard errors
  EXPECT_NEAR(std::sqrt(x / 4000), 0.2, tolerance_m);
  EXPECT_NEAR(std::sqrt(y / 4000), 0.2, tolerance_m);
  EXPECT_NEAR(both / 4000, 0, 4 * 0.04 / std::sqrt(4000.0));
}

}  // namespace
}  // namespace ganglion::sim
