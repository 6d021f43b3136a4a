#include "ganglion/sensing/compass_decoder/compass_decoder.h"

#include <gtest/gtest.h>

#include "ganglion/module/testing/sensing_habits.h"
#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

using testing::SensingBench;
using testing::Setting;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Device {
  double center_a_V = 2.5;
  double center_b_V = 2.5;
  double amplitude_a_V = 0.594;
  double amplitude_b_V = 0.594;
};

/// Points the device to a bearing; how far the decoded yaw is off [deg].
double error_deg(SensingBench& bench, const Device& device, double bearing_deg) {
  const double rad = bearing_deg * kPi / 180;
  bench.set("va", device.center_a_V + device.amplitude_a_V * std::cos(rad));
  bench.set("vb", device.center_b_V + device.amplitude_b_V * std::sin(rad));
  bench.step(0.1);
  return std::remainder(bench.out("yaw") * 180 / kPi - (90 - bearing_deg), 360);
}

// Row 11: atan2(VB - c, VA - c); the phase agrees with the listing's regions at the cardinal points.
TEST(CompassDecoder, AgreesWithTheListingAtTheCardinalPoints) {
  SensingBench bench(compass_decoder_kind, {{"learn", 0.0}});
  const auto yaw = [&](double va, double vb) {
    bench.set("va", va);
    bench.set("vb", vb);
    bench.step(0.1);
    return bench.out("yaw");
  };
  EXPECT_NEAR(yaw(3.094, 2.5), kPi / 2, 1e-12);  // bearing 0
  EXPECT_NEAR(yaw(2.5, 3.094), 0, 1e-12);        // bearing 90
  EXPECT_NEAR(yaw(1.906, 2.5), -kPi / 2, 1e-12);
  EXPECT_NEAR(yaw(2.5, 1.906), kPi, 1e-12);
}

TEST(CompassDecoder, IsExactAllRound) {
  SensingBench bench(compass_decoder_kind, {{"learn", 0.0}});
  for (int deg = 0; deg < 360; ++deg) ASSERT_NEAR(error_deg(bench, {}, deg), 0, 1e-9) << deg;
  EXPECT_NEAR(bench.out("strength"), 1, 1e-9);
  EXPECT_EQ(bench.out("calibrated"), 0);
}

TEST(CompassDecoder, CalibratesItselfByOneTurn) {
  constexpr Device kBent{2.60, 2.35, 0.55, 0.66};
  SensingBench bench(compass_decoder_kind);
  double worst = 0;
  for (int deg = 0; deg < 360; ++deg) worst = std::max(worst, std::fabs(error_deg(bench, kBent, deg)));
  EXPECT_GT(worst, 10);
  EXPECT_EQ(bench.out("calibrated"), 1);
  for (int deg = 0; deg < 360; ++deg) ASSERT_NEAR(error_deg(bench, kBent, deg), 0, 0.1) << deg;
}

TEST(CompassDecoder, WaitsForAWholeTurn) {
  SensingBench bench(compass_decoder_kind);
  for (int i = 0; i < 5; ++i) {
    for (int deg = 0; deg < 320; ++deg) error_deg(bench, {}, deg);
  }
  EXPECT_EQ(bench.out("calibrated"), 0);
}

TEST(CompassDecoder, RemembersItsCalibration) {
  constexpr Device kBent{2.60, 2.35, 0.55, 0.66};
  SensingBench bench(compass_decoder_kind);
  EXPECT_TRUE(bench.product().parts().empty());
  for (int deg = 0; deg < 360; ++deg) error_deg(bench, kBent, deg);
  const auto parts = stored_parts(bench.product(), nullptr);
  ASSERT_EQ(parts.size(), 1u);
  SensingBench fresh(compass_decoder_kind);
  const auto before = fresh.product().parts().size();
  ASSERT_TRUE(fresh.product().load(1, parts));
  EXPECT_EQ(before, 0u);
  EXPECT_EQ(fresh.product().parts().front().generation, 1u);
  EXPECT_NEAR(error_deg(fresh, kBent, 33), 0, 0.1);
  EXPECT_EQ(fresh.out("calibrated"), 1);
}

TEST(CompassDecoder, RefusesADamagedCalibration) {
  SensingBench bench(compass_decoder_kind);
  const auto part = [](std::initializer_list<double> voltages) {
    ByteWriter writer;
    for (const double voltage : voltages) writer.f64(voltage);
    return std::vector<ExperiencePart>{{"calibration", writer.take()}};
  };
  for (const auto& voltages : {part({}), part({1, 2, 3}), part({1, 2, 3, 4, 5}), part({2, 1, 1, 2}),
                               part({1, 2, 1, kNan}), part({1, 2, 1, 1e300})}) {
    const auto loaded = bench.product().load(1, voltages);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::Corrupt);
  }
  EXPECT_EQ(bench.product().load(2, part({1, 2, 1, 2})).error().code, ErrorCode::Unsupported);
  EXPECT_NEAR(error_deg(bench, {}, 100), 0, 1e-9);  // as it was
}

TEST(CompassDecoder, GivesNoHeadingFromVoltagesOfNoCompass) {
  SensingBench bench(compass_decoder_kind);
  const auto yaw = [&](double va, double vb) {
    bench.set("va", va);
    bench.set("vb", vb);
    bench.step(0.1);
    return bench.out("yaw");
  };
  EXPECT_TRUE(std::isnan(yaw(0, 0)));      // cut wires: 5.95 times too strong
  EXPECT_TRUE(std::isnan(yaw(2.5, 2.6)));  // 0.17 of the amplitude
  EXPECT_TRUE(std::isnan(yaw(kNan, 2.5)));
  EXPECT_FALSE(std::isnan(yaw(2.5, 3.0)));
}

TEST(CompassDecoder, HasGoodHabitsOnAnyReadings) {
  testing::expect_good_sensing(compass_decoder_kind, {}, {},
                               [](SensingBench& bench) { ASSERT_FALSE(std::fabs(bench.out("yaw")) > kPi); });
}

}  // namespace
}  // namespace ganglion
