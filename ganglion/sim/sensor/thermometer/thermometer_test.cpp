#include "ganglion/sim/sensor/thermometer/thermometer.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

constexpr std::string_view kOven =
    "format = 1\nname = \"w\"\n[[floor]]\nx_m = 5\ny_m = 0\nradius_m = 1\nwarmer_C = 15\n";

double read_C(Sensor& thermometer, const Scene& scene, std::uint32_t tick = 0) {
  std::array<double, 1> values{};
  Draws draws(StreamId{2, 0, 0, 4}, tick);
  thermometer.measure(scene, draws, values);
  return values[0];
}

TEST(Thermometer, TellsTheAirAndWarmerZones) {
  Stage stage(kOven);
  const auto thermometer = made(thermometer_kind, {{"noise_C", 0}, {"bias_C", 1}});
  EXPECT_EQ(read_C(*thermometer, stage.at({})), 21);
  EXPECT_EQ(read_C(*thermometer, stage.at({{4.5, 0}, {}})), 36);
}

TEST(Thermometer, ScattersAsStated) {
  Stage stage(kOven);
  const auto thermometer = made(thermometer_kind, {{"resolution_C", 0}, {"bias_C", 0.3}});
  const int count = 4000;
  double sum = 0, squares = 0;
  for (int n = 0; n < count; ++n) {
    const double error_C = read_C(*thermometer, stage.at({}), static_cast<std::uint32_t>(n)) - 20.3;
    sum += error_C;
    squares += error_C * error_C;
  }
  EXPECT_NEAR(sum / count, 0, 4 * 0.1 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.1, 4 * 0.1 / std::sqrt(2.0 * count));
}

TEST(Thermometer, RoundsToItsSteps) {
  Stage stage(kOven);
  const auto thermometer = made(thermometer_kind, {{"noise_C", 0}, {"air_C", 20.3}});
  EXPECT_EQ(read_C(*thermometer, stage.at({})), 20.5);
}

TEST(Thermometer, WarmsUpSlowly) {
  Stage stage(kOven);
  const auto thermometer = made(thermometer_kind, {{"noise_C", 0}, {"resolution_C", 0}, {"lag_s", 20}});
  ASSERT_TRUE(thermometer->reset(stage.at({}), Draws(StreamId{}, 0)));
  for (int n = 0; n < 200; ++n) thermometer->follow(stage.at({{5, 0}, {}}), 0.1);
  EXPECT_NEAR(read_C(*thermometer, stage.at({{5, 0}, {}})), 20 + 15 * (1 - std::exp(-1)), 1e-9);
}

}  // namespace
}  // namespace ganglion::sim
