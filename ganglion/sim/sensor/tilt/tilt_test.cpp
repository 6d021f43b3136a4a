#include "ganglion/sim/sensor/tilt/tilt.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

/// A ramp of 10 deg that rises along x, from x = 0 to 10.
constexpr std::string_view kRamp =
    "format = 1\nname = \"w\"\n[[floor]]\nx_m = 5\ny_m = 0\nlength_m = 10\nwidth_m = 20\nslope_deg = 10\n";

std::array<double, 2> read_deg(Sensor& tilt, const Scene& scene, std::uint32_t tick = 0) {
  std::array<double, 2> values{};
  Draws draws(StreamId{2, 0, 0, 4}, tick);
  tilt.measure(scene, draws, values);
  return {Angle::from_rad(values[0]).deg(), Angle::from_rad(values[1]).deg()};
}

std::array<double, 2> facing_deg(double yaw_deg) {
  Stage stage(kRamp);
  const auto tilt = made(tilt_kind, {{"noise_deg", 0}});
  return read_deg(*tilt, stage.at({{5, 0}, Angle::from_deg(yaw_deg)}));
}

TEST(Tilt, TellsUphillDownhillAndAcross) {
  EXPECT_NEAR(facing_deg(0)[0], 0, 1e-9);
  EXPECT_NEAR(facing_deg(0)[1], -10, 1e-9);  // nose up
  EXPECT_NEAR(facing_deg(180)[1], 10, 1e-9);
  EXPECT_NEAR(facing_deg(90)[0], -10, 1e-9);  // uphill to the right: the left side is down
  EXPECT_NEAR(facing_deg(-90)[0], 10, 1e-9);
  EXPECT_NEAR(facing_deg(90)[1], 0, 1e-9);
}

TEST(Tilt, SharesTheSlopeOutWhenAslant) {
  // tan 10 deg = 0.176327; at 45 deg 0.124682 ahead and, uphill to the right, -0.124682 to the left.
  const auto at_deg = facing_deg(45);
  EXPECT_NEAR(at_deg[1], -7.10704, 1e-4);  // atan 0.124682
  EXPECT_NEAR(at_deg[0], -7.05302, 1e-4);  // atan(0.124682 / sqrt(1 + 0.124682^2))
}

TEST(Tilt, IsLevelOffTheSlope) {
  Stage stage(kRamp);
  const auto tilt = made(tilt_kind, {{"noise_deg", 0}, {"roll_bias_deg", 1.5}, {"pitch_bias_deg", -2}});
  const auto at_deg = read_deg(*tilt, stage.at({{-1, 0}, {}}));
  EXPECT_NEAR(at_deg[0], 1.5, 1e-12);
  EXPECT_NEAR(at_deg[1], -2, 1e-12);
}

TEST(Tilt, ScattersAsStated) {
  Stage stage(kRamp);
  const auto tilt = made(tilt_kind);  // 0.5 deg
  const int count = 4000;
  double sum = 0, squares = 0, both = 0;
  for (int n = 0; n < count; ++n) {
    const auto at_deg = read_deg(*tilt, stage.at({{5, 0}, {}}), static_cast<std::uint32_t>(n));
    sum += at_deg[1] + 10;
    squares += at_deg[0] * at_deg[0];
    both += at_deg[0] * (at_deg[1] + 10);
  }
  EXPECT_NEAR(sum / count, 0, 4 * 0.5 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.5, 4 * 0.5 / std::sqrt(2.0 * count));
  EXPECT_NEAR(both / count, 0, 4 * 0.25 / std::sqrt(count));
}

TEST(Tilt, LagsRoundsAndEndsAsStated) {
  Stage stage(kRamp);
  const auto slow = made(tilt_kind, {{"noise_deg", 0}, {"lag_s", 0.5}});
  ASSERT_TRUE(slow->reset(stage.at({{-1, 0}, {}}), Draws(StreamId{}, 0)));
  for (int n = 0; n < 50; ++n) slow->follow(stage.at({{5, 0}, {}}), 0.01);
  EXPECT_NEAR(read_deg(*slow, stage.at({{5, 0}, {}}))[1], -10 * (1 - std::exp(-1)), 1e-9);
  const auto coarse = made(tilt_kind, {{"noise_deg", 0}, {"resolution_deg", 3}});
  EXPECT_NEAR(read_deg(*coarse, stage.at({{5, 0}, {}}))[1], -9, 1e-9);
  const auto narrow = made(tilt_kind, {{"noise_deg", 0}, {"max_deg", 5}});
  EXPECT_NEAR(read_deg(*narrow, stage.at({{5, 0}, {}}))[1], -5, 1e-9);
}

}  // namespace
}  // namespace ganglion::sim
