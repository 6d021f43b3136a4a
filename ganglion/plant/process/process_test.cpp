#include "ganglion/plant/process/process.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion {
namespace {

/// After so many steps of that length under one command.
double value_after(const ProcessConfig& config, double command, double step_s, int steps) {
  Process process(config);
  process.reset();
  Draws draws({}, 0);
  const std::array commands = {command};
  for (int n = 0; n < steps; ++n) process.step(commands, step_s, draws);
  std::array<double, 1> values{};
  process.sense(values);
  return values[0];
}

TEST(Process, AnswersAStepAsTextbooksSay) {
  EXPECT_NEAR(value_after({.gain = 2, .lag_s = 1}, 1, 1, 1), 2 * (1 - std::exp(-1.0)), 1e-12);
  EXPECT_NEAR(value_after({.gain = -2, .lag_s = 4, .start = 3}, 1, 2, 1), -2 + 5 * std::exp(-0.5), 1e-12);
  // Two lags: 1 - (t1 exp(-t / t1) - t2 exp(-t / t2)) / (t1 - t2); two equal ones: 1 - (1 + t / t1) exp(-t / t1).
  const double two = 1 - (1 * std::exp(-1.5) - 0.5 * std::exp(-3.0)) / 0.5;
  EXPECT_NEAR(value_after({.lag_s = 1, .second_lag_s = 0.5}, 1, 1.5, 1), two, 1e-12);
  EXPECT_NEAR(value_after({.lag_s = 0.5, .second_lag_s = 1}, 1, 1.5, 1), two, 1e-12);
  EXPECT_NEAR(value_after({.lag_s = 1, .second_lag_s = 1}, 1, 1.5, 1), 1 - 2.5 * std::exp(-1.5), 1e-12);
}

TEST(Process, ComesToTheSameHoweverLongTheStepsAre) {
  const ProcessConfig config{
      .gain = 3, .lag_s = 0.7, .second_lag_s = 0.3, .dead_time_s = 0.25, .loads = {0.5, -0.5}, .load_s = {0.4, 1.1}};
  const double once = value_after(config, 0.8, 2, 1);
  EXPECT_NEAR(value_after(config, 0.8, 0.1, 20), once, 1e-12);
  EXPECT_NEAR(value_after(config, 0.8, 0.001, 2000), once, 1e-11);
}

TEST(Process, LetsACommandActAfterTheDeadTimeAndALoadAtOnce) {
  const ProcessConfig dead{.lag_s = 1, .dead_time_s = 0.25};
  EXPECT_EQ(value_after(dead, 1, 0.25, 1), 0);
  EXPECT_NEAR(value_after(dead, 1, 1, 1), 1 - std::exp(-0.75), 1e-12);
  const ProcessConfig loaded{.lag_s = 1, .dead_time_s = 0.25, .loads = {2, 0}, .load_s = {0.5, 1}};
  // 2 acts from 0.5 to 1 s only; what it made by then decays.
  EXPECT_NEAR(value_after(loaded, 0, 3, 1), 2 * (1 - std::exp(-0.5)) * std::exp(-2.0), 1e-12);
}

TEST(Process, MeasuresWithNoiseButIsNotMovedByIt) {
  Process process({.lag_s = 1, .noise = 0.5});
  process.reset();
  Draws draws({}, 1);
  process.step(std::array{1.0}, 1, draws);
  std::array<double, 1> measured{};
  std::array<double, 3> truth{};
  process.sense(measured);
  process.tell(truth);
  EXPECT_NEAR(truth[0], 1 - std::exp(-1.0), 1e-12);
  Draws again({}, 1);
  EXPECT_DOUBLE_EQ(measured[0], truth[0] + 0.5 * again.normal());
}

TEST(Process, FailsWhereItTrips) {
  Process process({.gain = 10, .lag_s = 1, .trip = 5});
  process.reset();
  Draws draws({}, 0);
  process.step(std::array{1.0}, 0.5, draws);
  EXPECT_FALSE(process.failed()) << 10 * (1 - std::exp(-0.5));
  process.step(std::array{1.0}, 0.5, draws);
  EXPECT_TRUE(process.failed()) << 10 * (1 - std::exp(-1.0));
  process.reset();
  EXPECT_FALSE(process.failed());
}

TEST(Process, CostsItsCommandOverTime) {
  Process process({.lag_s = 1});
  process.reset();
  Draws draws({}, 0);
  process.step(std::array{-0.5}, 0.2, draws);
  EXPECT_DOUBLE_EQ(process.cost(), 0.1);
}

TEST(Process, RefusesWhatDoesNotGoTogether) {
  ProcessConfig crossed{.min = 1, .max = 0};
  EXPECT_EQ(Process::judge(crossed).error().what.en, "min is 1, must be <= max = 0");
  ProcessConfig few{.loads = {1, 2}, .load_s = {3}};
  EXPECT_EQ(Process::judge(few).error().what.en, "loads has 2 numbers and load_s 1: one time for each load is needed");
  ProcessConfig many{.loads = std::vector<double>(1001), .load_s = std::vector<double>(1001)};
  EXPECT_EQ(Process::judge(many).error().what.en, "loads has 1001 numbers; the limit is 1000");
  ProcessConfig late{.loads = {1, 2}, .load_s = {3, 1}};
  EXPECT_EQ(Process::judge(late).error().what.en, "load_s must be in order of time");
}

}  // namespace
}  // namespace ganglion
