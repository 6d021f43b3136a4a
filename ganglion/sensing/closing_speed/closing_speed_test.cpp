#include "ganglion/sensing/closing_speed/closing_speed.h"

#include <gtest/gtest.h>

#include "ganglion/module/testing/sensing_habits.h"

namespace ganglion {
namespace {

using testing::SensingBench;
using testing::Setting;

void step(SensingBench& bench, double range_m, double age_s = 0) {
  bench.set("range", range_m);
  bench.age("range", age_s);
  bench.step(0.1);
}

// Row 14: true dt.
TEST(ClosingSpeed, DividesByTheTimeBetweenReadings) {
  SensingBench bench(closing_speed_kind);
  step(bench, 1.00);
  EXPECT_TRUE(std::isnan(bench.out("speed")));
  step(bench, 0.98);
  EXPECT_NEAR(bench.out("speed"), 0.2, 1e-9);
  EXPECT_TRUE(std::isnan(bench.out("acceleration")));
  step(bench, 0.95);
  EXPECT_NEAR(bench.out("speed"), 0.3, 1e-9);
  EXPECT_NEAR(bench.out("acceleration"), 1.0, 1e-9);
}

TEST(ClosingSpeed, WaitsForANewReading) {
  SensingBench bench(closing_speed_kind);
  step(bench, 1.00);
  step(bench, 0.98);
  step(bench, 0.98, 0.1);  // not fired again
  EXPECT_NEAR(bench.out("speed"), 0.2, 1e-9);
  step(bench, 0.94);  // 0.2 s after the last one
  EXPECT_NEAR(bench.out("speed"), 0.2, 1e-9);
  EXPECT_NEAR(bench.out("acceleration"), 0, 1e-9);
}

TEST(ClosingSpeed, BeginsAgainAfterALostEcho) {
  SensingBench bench(closing_speed_kind);
  step(bench, 1.00);
  step(bench, 0.98);
  step(bench, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(bench.out("speed")));
  step(bench, 0.9);
  EXPECT_TRUE(std::isnan(bench.out("speed")));
  step(bench, 0.9);
  EXPECT_NEAR(bench.out("speed"), 0, 1e-9);
}

// Row 14: dt 0.3 s, D1OLD = 300 cm, V1OLD = 0: (3 - 2.7) / 0.3 and 1 / 0.3.
TEST(ClosingSpeed, FollowsTheListing) {
  SensingBench bench(closing_speed_kind, {{"preset", "listing"}});
  step(bench, 2.7);
  EXPECT_NEAR(bench.out("speed"), 1.0, 1e-9);
  EXPECT_NEAR(bench.out("acceleration"), 1 / 0.3, 1e-9);
  step(bench, 2.4, 0.1);
  EXPECT_NEAR(bench.out("speed"), 1.0, 1e-9);
}

TEST(ClosingSpeed, HasGoodHabitsOnAnyReadings) {
  testing::expect_good_sensing(closing_speed_kind, {}, {}, [](SensingBench&) {});
}

}  // namespace
}  // namespace ganglion
