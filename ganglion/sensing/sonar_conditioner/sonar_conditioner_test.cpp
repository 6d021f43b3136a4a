#include "ganglion/sensing/sonar_conditioner/sonar_conditioner.h"

#include <gtest/gtest.h>

#include "ganglion/module/testing/sensing_habits.h"

namespace ganglion {
namespace {

using testing::SensingBench;
using testing::Setting;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

double of_echo(double echo_s, std::initializer_list<Setting> list = {}) {
  SensingBench bench(sonar_conditioner_kind, list);
  bench.wire("echo_time");
  bench.set("echo_time", echo_s);
  bench.step(0.1);
  return bench.out("range");
}

double then(SensingBench& bench, double range_m, double age_s = 0) {
  bench.set("raw_range", range_m);
  bench.age("raw_range", age_s);
  bench.step(0.1);
  return bench.out("range");
}

// Row 12: 331.3 + 0.606 T: 343.42 m/s at 20 deg C, 319.18 at -20.
TEST(SonarConditioner, KnowsTheSpeedOfSoundAtATemperature) {
  EXPECT_NEAR(of_echo(0.01), 1.7171, 1e-12);
  EXPECT_NEAR(of_echo(0.01, {{"temperature_C", -20.0}}), 1.5959, 1e-12);
  SensingBench bench(sonar_conditioner_kind);
  bench.wire("echo_time");
  bench.wire("temperature");
  bench.set("echo_time", 0.01);
  bench.set("temperature", -20);
  bench.step(0.1);
  EXPECT_NEAR(bench.out("range"), 1.5959, 1e-12);
  bench.set("temperature", kNan);  // the parameter stands in
  for (int i = 0; i < 2; ++i) bench.step(0.1);
  EXPECT_NEAR(bench.out("range"), 1.7171, 1e-12);
}

// Row 12: below 0.02 m is -inf, no echo is +inf, echo 0 (no pulse) is NaN.
TEST(SonarConditioner, SaysWhatAnEchoCannotMeasure) {
  EXPECT_EQ(of_echo(115e-6), -kInf);  // 0.0197 m
  EXPECT_NEAR(of_echo(117e-6), 0.02009007, 1e-9);
  EXPECT_EQ(of_echo(0.0185), kInf);  // a PING's longest pulse: 3.18 m
  EXPECT_EQ(of_echo(kInf), kInf);
  EXPECT_TRUE(std::isnan(of_echo(0)));
  EXPECT_TRUE(std::isnan(of_echo(kNan)));
}

TEST(SonarConditioner, PassesRangesOn) {
  for (const auto& [raw_m, range_m] :
       {std::pair{1.0, 1.0}, {0.019, -kInf}, {3.01, kInf}, {-kInf, -kInf}, {kInf, kInf}}) {
    SensingBench bench(sonar_conditioner_kind);
    bench.wire("raw_range");
    EXPECT_EQ(then(bench, raw_m), range_m);
    EXPECT_EQ(bench.out("dead"), 0);
  }
}

TEST(SonarConditioner, TakesTheMedianOfThree) {
  SensingBench bench(sonar_conditioner_kind);
  bench.wire("raw_range");
  EXPECT_EQ(then(bench, 1.0), 1.0);
  EXPECT_EQ(then(bench, 2.0), 1.0);  // of two the nearer
  EXPECT_EQ(then(bench, 1.5), 1.5);
  EXPECT_EQ(then(bench, kInf), 2.0);  // 2.0 1.5 inf: one lost echo changes little
  EXPECT_EQ(then(bench, 1.4), 1.5);
  EXPECT_EQ(then(bench, -kInf), 1.4);
  EXPECT_EQ(then(bench, -kInf), -kInf);
}

TEST(SonarConditioner, CountsARepeatedReadingOnce) {
  SensingBench bench(sonar_conditioner_kind);
  bench.wire("raw_range");
  then(bench, 1.0);
  then(bench, 1.1);
  EXPECT_EQ(then(bench, 0.3), 1.0);
  EXPECT_EQ(then(bench, 0.3, 0.1), 1.0);  // still the one outlier
  EXPECT_EQ(then(bench, 0.3, 0.2), 1.0);
  EXPECT_EQ(then(bench, 0.3), 0.3);  // measured again
}

TEST(SonarConditioner, IsDeadAtOnceAndForgets) {
  SensingBench bench(sonar_conditioner_kind);
  bench.wire("raw_range");
  then(bench, 1.0);
  EXPECT_TRUE(std::isnan(then(bench, kNan)));
  EXPECT_EQ(bench.out("dead"), 1);
  EXPECT_EQ(then(bench, 2.0), 2.0);
  EXPECT_EQ(bench.out("dead"), 0);
}

TEST(SonarConditioner, IsDeadWhenItHasNotFiredForHalfASecond) {
  SensingBench bench(sonar_conditioner_kind);
  bench.wire("raw_range");
  EXPECT_EQ(then(bench, 1.0, 0.5), 1.0);
  EXPECT_TRUE(std::isnan(then(bench, 1.0, 0.6)));
  EXPECT_EQ(bench.out("dead"), 1);
}

TEST(SonarConditioner, IsDeadWhereNothingIsWired) {
  SensingBench bench(sonar_conditioner_kind);
  bench.step(0.1);
  EXPECT_TRUE(std::isnan(bench.out("range")));
}

TEST(SonarConditioner, RefusesRangesOutOfOrder) {
  const auto made =
      sonar_conditioner_kind.make(testing::settings(sonar_conditioner_kind.descriptor, {{"min_range_m", 3.0}}));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().what.en, "min_range_m is 3, must be < max_range_m = 3");
}

TEST(SonarConditioner, HasGoodHabitsOnAnyReadings) {
  const auto check = [](SensingBench& bench) {
    const double range_m = bench.out("range");
    ASSERT_EQ(std::isnan(range_m), bench.out("dead") == 1);
    if (std::isfinite(range_m)) {
      ASSERT_GE(range_m, 0.02);
      ASSERT_LE(range_m, 3.0);
    }
  };
  testing::expect_good_sensing(sonar_conditioner_kind, {}, {"raw_range"}, check);
  testing::expect_good_sensing(sonar_conditioner_kind, {{"readings", 2.0}}, {"echo_time", "temperature"}, check);
  testing::expect_good_sensing(sonar_conditioner_kind, {{"readings", 1.0}}, {"raw_range"}, check);
}

}  // namespace
}  // namespace ganglion
