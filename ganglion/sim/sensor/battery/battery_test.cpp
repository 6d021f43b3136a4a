#include "ganglion/sim/sensor/battery/battery.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

std::array<double, 3> read(Sensor& battery, const Scene& scene, std::uint32_t tick = 0) {
  std::array<double, 3> values{};
  Draws draws(StreamId{2, 0, 0, 4}, tick);
  battery.measure(scene, draws, values);
  return values;
}

TEST(Battery, CutsOffToWholeCounts) {
  Stage stage;
  const auto battery = made(battery_kind, {{"noise_V", 0}, {"divider", 1.02}});
  stage.robot.battery_V = 7.4;
  stage.robot.charge = 0.6;
  const auto values = read(*battery, stage.at({}));
  EXPECT_NEAR(values[0], 386 * 20.0 / 1024, 1e-12);  // 7.548 V of 20 V are 386.46 counts
  EXPECT_EQ(values[1], 0.6);
  EXPECT_EQ(values[2], 0);
}

TEST(Battery, TellsTheMeanCurrentSinceItFiredLast) {
  Stage stage;
  const auto battery = made(battery_kind, {{"noise_V", 0}});
  stage.robot.battery_V = 8;
  ASSERT_TRUE(battery->reset(stage.at({}), Draws(StreamId{}, 0)));
  stage.robot.energy_J = 12;  // in 0.5 s: 24 W, 3 A
  EXPECT_NEAR(read(*battery, stage.at({}, 0.5))[2], 3, 1e-12);
  stage.robot.energy_J = 12.4;  // in 0.1 s: 4 W
  EXPECT_NEAR(read(*battery, stage.at({}, 0.6))[2], 0.5, 1e-9);
}

TEST(Battery, ReadsNothingWhereThereIsNone) {
  Stage stage;
  const auto battery = made(battery_kind);
  for (const double value : read(*battery, stage.at({}))) EXPECT_TRUE(std::isnan(value));
}

TEST(Battery, ScattersAsStated) {
  Stage stage;
  const auto battery = made(battery_kind, {{"bits", 0}});  // 0.02 V
  stage.robot.battery_V = 7.4;
  const int count = 4000;
  double sum = 0, squares = 0;
  for (int n = 0; n < count; ++n) {
    const double error_V = read(*battery, stage.at({}), static_cast<std::uint32_t>(n))[0] - 7.4;
    sum += error_V;
    squares += error_V * error_V;
  }
  EXPECT_NEAR(sum / count, 0, 4 * 0.02 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.02, 4 * 0.02 / std::sqrt(2.0 * count));
}

}  // namespace
}  // namespace ganglion::sim
