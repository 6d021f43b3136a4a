#include "ganglion/acting/pid_regulator/pid_regulator.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "ganglion/module/testing/bench.h"
#include "ganglion/module/testing/request_bench.h"

namespace ganglion {
namespace {

constexpr double kStep_s = 0.1;

/// A regulator asked for a set-point, and the value that it sees.
class Loop {
 public:
  explicit Loop(std::initializer_list<testing::Setting> list)
      : module(std::move(*pid_regulator_kind.make(testing::settings(pid_regulator_kind.descriptor, list)))),
        bench(*module, pid_regulator_kind.descriptor, {}, kStep_s) {
    bench.request().standing = true;
  }
  const Command& step(double setpoint, double value) {
    bench.request().keep_asking(std::array{setpoint}, std::numeric_limits<double>::infinity());
    bench.ports().set("value", {value});
    return bench.tick(0);
  }

  std::unique_ptr<ActingModule> module;
  testing::RequestBench bench;
};

TEST(PidRegulator, AddsItsThreePartsByHand) {
  Loop loop({{"kp", 0.5}, {"ki_per_s", 0.2}, {"kd_s", 0.04}, {"base", 0.1}});
  // e = 1: 0.1 + 0.5, no sum yet, no rate yet
  EXPECT_NEAR(loop.step(1, 0).values[0], 0.6, 1e-15);
  // e = 0.75: 0.1 + 0.375 + 0.2 * 1 * 0.1 - 0.04 * 0.25 / 0.1
  EXPECT_NEAR(loop.step(1, 0.25).values[0], 0.1 + 0.375 + 0.02 - 0.1, 1e-15);
  EXPECT_NEAR(loop.bench.ports().output("error"), 0.75, 1e-15);
  EXPECT_NEAR(loop.bench.ports().output("proportional"), 0.375, 1e-15);
  EXPECT_NEAR(loop.bench.ports().output("integral"), 0.02, 1e-15);
  EXPECT_NEAR(loop.bench.ports().output("derivative"), -0.1, 1e-15);
}

TEST(PidRegulator, WeighsTheSetPointAndFiltersTheRate) {
  Loop loop({{"kp", 1}, {"setpoint_weight", 0.5}, {"kd_s", 0.1}, {"filter_s", 0.1}});
  EXPECT_NEAR(loop.step(0.4, 0).values[0], 0.2, 1e-15);
  // P: 0.5 * 0.4 - 0.1; D: (0.1 * 0 + 0.1 * 0.1) / (0.1 + 0.1) = 0.05
  EXPECT_NEAR(loop.step(0.4, 0.1).values[0], 0.1 - 0.05, 1e-15);
}

TEST(PidRegulator, DoesNotWindUpBeyondItsLimits) {
  Loop wound({{"kp", 1}, {"ki_per_s", 1}, {"tracking_s", 1e6}}),
      tracks({{"kp", 1}, {"ki_per_s", 1}, {"tracking_s", 0.2}});
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(wound.step(3, 0).values[0], 1);
    EXPECT_EQ(tracks.step(3, 0).values[0], 1);
  }
  // The sum grows by 0.3 a tick without end; with tracking until 0.3 = (whole - 1) 0.1 / 0.2, so whole = 1.6, I = -1.4.
  EXPECT_NEAR(wound.bench.ports().output("integral"), 0.3 * 99, 0.01);
  EXPECT_NEAR(tracks.bench.ports().output("integral"), -1.4, 1e-6);
}

TEST(PidRegulator, AddsNothingUpWhileAnotherDrives) {
  Loop loop({{"kp", 0.1}, {"ki_per_s", 1}});
  loop.step(1, 0);
  loop.module->carried_out(0);
  loop.step(1, 0);
  EXPECT_NEAR(loop.bench.ports().output("integral"), 0.1, 1e-15) << "of the first tick";
  loop.module->carried_out(1);
  loop.step(1, 0);
  EXPECT_NEAR(loop.bench.ports().output("integral"), 0.1, 1e-15);
  loop.step(1, 0);
  EXPECT_NEAR(loop.bench.ports().output("integral"), 0.2, 1e-15);
}

TEST(PidRegulator, IsInactiveWithoutAReadingAndStartsAnewAfterIt) {
  Loop loop({{"kp", 0.1}, {"ki_per_s", 1}, {"kd_s", 1}});
  loop.step(1, 0);
  loop.step(1, 0);
  EXPECT_EQ(loop.step(1, std::numeric_limits<double>::quiet_NaN()).kind, CommandKind::Inactive);
  EXPECT_NEAR(loop.step(1, 0.5).values[0], 0.05, 1e-15) << "no sum, and no jump of the rate";
}

TEST(PidRegulator, TurnsTracksAgainstEachOtherRoundTheTurn) {
  Loop loop({{"kp", 1}, {"base", 0.5}, {"drives", "tracks"}, {"circular", 1}});
  const Command command = loop.step(3.1, -3.1);  // the short way is 2 pi - 6.2 = 0.0832 clockwise
  ASSERT_EQ(command.size, 2);
  EXPECT_NEAR(command.values[0], 0.5 + 0.0831853, 1e-6);
  EXPECT_NEAR(command.values[1], 0.5 - 0.0831853, 1e-6);
}

TEST(PidRegulator, ShapesItsPortsByWhatItDrives) {
  const auto shaped =
      PidRegulator::shape(testing::settings(pid_regulator_kind.descriptor, {{"drives", "tracks"}, {"circular", 1}}));
  ASSERT_TRUE(shaped);
  EXPECT_EQ(shaped->list()[2].width(), 2);
  EXPECT_EQ(shaped->list()[1].type, ValueType::Circular);
  EXPECT_EQ(PidRegulator::shape(Parameters(pid_regulator_kind.descriptor.parameters))->list()[2].width(), 1);
}

TEST(PidRegulator, RefusesLimitsThatContradictEachOther) {
  const auto made = pid_regulator_kind.make(testing::settings(pid_regulator_kind.descriptor, {{"min", 2}, {"max", 1}}));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().what.en, "min is 2, must be less than max = 1");
}

/// The same closed loop worked out apart from the module: first-order plant y' = (K u - y) / T held over each tick,
/// parts as the book has them. Gives the largest value over the set-point and the last tick outside of 2 %.
struct Response {
  double overshoot = 0;
  int settled_after = 0;
};
Response by_hand(double gain, double time_s, double kp, double ki, int ticks) {
  const double decay = std::exp(-kStep_s / time_s);
  double y = 0, sum = 0;
  Response response;
  for (int k = 0; k < ticks; ++k) {
    const double e = 1 - y, u = kp * e + sum;
    sum += ki * e * kStep_s;
    y = decay * y + gain * (1 - decay) * u;
    response.overshoot = std::max(response.overshoot, y - 1);
    if (std::fabs(y - 1) > 0.02) response.settled_after = k + 1;
  }
  return response;
}

TEST(PidRegulator, OvershootsAndSettlesAsTheSampledLoopDoesByHand) {
  const double gain = 2, time_s = 1.5, kp = 1.2, ki = 2.5;
  Loop loop({{"kp", kp}, {"ki_per_s", ki}, {"min", -100}, {"max", 100}});
  const double decay = std::exp(-kStep_s / time_s);
  double y = 0;
  Response found;
  for (int k = 0; k < 200; ++k) {
    y = decay * y + gain * (1 - decay) * loop.step(1, y).values[0];
    found.overshoot = std::max(found.overshoot, y - 1);
    if (std::fabs(y - 1) > 0.02) found.settled_after = k + 1;
  }
  const Response expected = by_hand(gain, time_s, kp, ki, 200);
  EXPECT_GT(expected.overshoot, 0.05) << "a loop that shows something";
  EXPECT_NEAR(found.overshoot, expected.overshoot, 0.01 * expected.overshoot);
  EXPECT_EQ(found.settled_after, expected.settled_after);
}

}  // namespace
}  // namespace ganglion
