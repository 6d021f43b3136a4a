#include "ganglion/acting/avoid_obstacle/avoid_obstacle.h"

#include <gtest/gtest.h>

#include "ganglion/module/testing/habits.h"

namespace ganglion {
namespace {

using testing::ActingBench;
using testing::Setting;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Command step(ActingBench& bench, double left_m, double right_m) {
  bench.set("left", left_m);
  bench.set("right", right_m);
  return bench.step(0.1);
}

Command first(double left_m, double right_m, const char* preset) {
  ActingBench bench(avoid_obstacle_kind, {{"preset", preset}});
  return step(bench, left_m, right_m);
}

double turn_of(const Command& command) { return (command.values[0] - command.values[1]) / 2; }
double forward_of(const Command& command) { return (command.values[0] + command.values[1]) / 2; }

// Row 2: 0.10..0.40 m, escape inactive.
TEST(AvoidObstacle, IsActiveFromTenToFortyCentimetresInTheListing) {
  EXPECT_EQ(first(0.40, 1.0, "listing").kind, CommandKind::Act);
  EXPECT_EQ(first(0.401, 1.0, "listing").kind, CommandKind::Inactive);
  EXPECT_EQ(first(1.0, 0.10, "listing").kind, CommandKind::Act);
  EXPECT_EQ(first(0.30, 0.099, "listing").kind, CommandKind::Inactive);  // FLAG_ESCAPE = 1
}

TEST(AvoidObstacle, IsActiveUpToFortyCentimetres) {
  EXPECT_EQ(first(0.40, 1.0, "recommended").kind, CommandKind::Act);
  EXPECT_EQ(first(0.401, 1.0, "recommended").kind, CommandKind::Inactive);
  EXPECT_EQ(first(0.05, 1.0, "recommended").kind, CommandKind::Act);
  EXPECT_EQ(first(-kInf, kInf, "recommended").kind, CommandKind::Act);
  EXPECT_EQ(first(kInf, kInf, "recommended").kind, CommandKind::Inactive);
}

TEST(AvoidObstacle, YieldsWhileEscaping) {
  for (const char* preset : {"listing", "recommended"}) {
    ActingBench bench(avoid_obstacle_kind, {{"preset", preset}});
    bench.wire("escaping");
    bench.set("escaping", 1);
    EXPECT_EQ(step(bench, 0.3, 1).kind, CommandKind::Inactive) << preset;
    bench.set("escaping", 0);
    EXPECT_EQ(step(bench, 0.3, 1).kind, CommandKind::Act) << preset;
  }
}

// Rows 3, 4 and 6: u = 3 int(x + 360 - 360) / 1200, clockwise for more room on the right, for 0.04 s.
TEST(AvoidObstacle, TurnsByWholeCentimetresInTheListing) {
  const Command right = first(0.30, 0.507, "listing");  // x = 20.7: 3 * 20 / 1200
  EXPECT_DOUBLE_EQ(right.values[0], 0.05);
  EXPECT_DOUBLE_EQ(right.values[1], -0.05);
  EXPECT_DOUBLE_EQ(right.ttl_s, 0.04);
  const Command left = first(0.507, 0.30, "listing");  // x + 360 = 339.3: 3 * (339 - 360) / 1200
  EXPECT_DOUBLE_EQ(left.values[0], -0.0525);
  EXPECT_DOUBLE_EQ(left.values[1], 0.0525);
}

TEST(AvoidObstacle, KeepsTheListingsCountsWithinFullSpeed) {
  EXPECT_DOUBLE_EQ(first(0.20, 2.70, "listing").values[0], 0.625);  // 3 * 250 / 1200
  EXPECT_DOUBLE_EQ(first(0.10, kInf, "listing").values[0], 0.77);   // 318.59 cm: 3 * 308 / 1200
}

// Rows 5 and 6: strictly below 4 cm forward at 1/3 replaces the turn, for 0.2 s.
TEST(AvoidObstacle, GoesStraightBelowFourCentimetresInTheListing) {
  const Command straight = first(0.30, 0.339, "listing");
  EXPECT_DOUBLE_EQ(straight.values[0], 1.0 / 3);
  EXPECT_DOUBLE_EQ(straight.values[1], 1.0 / 3);
  EXPECT_DOUBLE_EQ(straight.ttl_s, 0.2);
  const Command turn = first(0.30, 0.34, "listing");  // x = 4: M = 364
  EXPECT_DOUBLE_EQ(turn.values[0], 0.01);
  EXPECT_DOUBLE_EQ(turn.values[1], -0.01);
  EXPECT_DOUBLE_EQ(first(0.34, 0.30, "listing").values[0], -0.01);  // M = 356
}

// Row 3: the same gain without rounding: 0.0025 a cm.
TEST(AvoidObstacle, TurnsInProportionWithoutRounding) {
  EXPECT_NEAR(turn_of(first(0.30, 0.507, "recommended")), 0.05175, 1e-12);
  EXPECT_NEAR(turn_of(first(0.507, 0.30, "recommended")), -0.05175, 1e-12);
  EXPECT_EQ(turn_of(first(0.30, 0.39, "recommended")), 0);  // |x| < 10 cm
}

TEST(AvoidObstacle, ClampsTheTurn) {
  ActingBench bench(avoid_obstacle_kind, {{"gain_per_m", 10.0}});
  const Command command = step(bench, 0.3, 3.0);
  EXPECT_DOUBLE_EQ(command.values[0], 1);
  EXPECT_DOUBLE_EQ(command.values[1], -1);
}

// Row 5: < 10 cm with 4 cm hysteresis; forward speed falls with |x|, no dead stop between the bands.
TEST(AvoidObstacle, LeavesTheStraightBandLaterThanItEntersIt) {
  ActingBench bench(avoid_obstacle_kind);
  EXPECT_NE(turn_of(step(bench, 0.38, 0.50)), 0);  // 12 cm: not yet straight
  EXPECT_EQ(turn_of(step(bench, 0.38, 0.47)), 0);  // 9 cm
  EXPECT_EQ(turn_of(step(bench, 0.38, 0.50)), 0);  // 12 cm: still straight
  EXPECT_NE(turn_of(step(bench, 0.38, 0.53)), 0);  // 15 cm
}

TEST(AvoidObstacle, SlowsAheadAsTheDifferenceGrows) {
  // At 0.40 m nothing is taken off for nearness: 1/3 straight, then 1/3 (1 - |x| / 1 m).
  EXPECT_NEAR(forward_of(first(0.40, 0.45, "recommended")), 1.0 / 3, 1e-12);
  EXPECT_NEAR(forward_of(first(0.40, 0.60, "recommended")), 0.8 / 3, 1e-12);
  EXPECT_NEAR(forward_of(first(0.40, 0.90, "recommended")), 0.5 / 3, 1e-12);
  EXPECT_EQ(forward_of(first(0.40, 2.0, "recommended")), 0);
}

TEST(AvoidObstacle, SlowsAheadAsItComesNear) {
  // (0.26 - 0.12) / (0.40 - 0.12) = 1/2
  EXPECT_NEAR(forward_of(first(0.26, 0.26, "recommended")), 0.5 / 3, 1e-12);
  EXPECT_NEAR(forward_of(first(0.11, 0.11, "recommended")), 0, 1e-12);
}

TEST(AvoidObstacle, NeverStandsStill) {
  for (double left_m = 0.001; left_m <= 0.40; left_m += 0.013) {
    for (double right_m = 0.001; right_m < 3; right_m += 0.017) {
      const Command command = first(left_m, right_m, "recommended");
      ASSERT_GT(std::fabs(turn_of(command)) + forward_of(command), 0.01) << left_m << " " << right_m;
    }
  }
}

TEST(AvoidObstacle, KeepsTurningToOneSideInACorner) {
  ActingBench bench(avoid_obstacle_kind);
  EXPECT_DOUBLE_EQ(turn_of(step(bench, 0.20, 0.21)), 0.3);  // commits to the right
  EXPECT_EQ(bench.out("side"), 1);
  EXPECT_DOUBLE_EQ(turn_of(step(bench, 0.30, 0.15)), 0.3);  // the right is nearer now: no swinging back
  EXPECT_EQ(step(bench, 0.50, 0.50).kind, CommandKind::Inactive);
  for (int i = 0; i < 18; ++i) step(bench, 0.50, 0.50);     // 1.9 s
  EXPECT_DOUBLE_EQ(turn_of(step(bench, 0.39, 0.20)), 0.3);  // within 2 s of the last near reading: still right
  for (int i = 0; i < 21; ++i) step(bench, 0.50, 0.50);
  EXPECT_EQ(bench.out("side"), 0);
  EXPECT_LT(turn_of(step(bench, 0.39, 0.20)), 0);
}

// A post straight ahead, at 0.35 m: the readings change over as it turns a little.
TEST(AvoidObstacle, CommitsItselfAfterSwingingThreeTimes) {
  ActingBench bench(avoid_obstacle_kind);
  EXPECT_GT(turn_of(step(bench, 0.35, 1.70)), 0);
  EXPECT_LT(turn_of(step(bench, 1.70, 0.35)), 0);
  EXPECT_EQ(turn_of(step(bench, 0.35, 0.36)), 0);  // about equal: no change of side
  EXPECT_GT(turn_of(step(bench, 0.35, 1.70)), 0);
  EXPECT_EQ(bench.out("side"), 0);
  EXPECT_LT(turn_of(step(bench, 1.70, 0.35)), 0);  // the third time
  EXPECT_EQ(bench.out("side"), -1);
  EXPECT_DOUBLE_EQ(turn_of(step(bench, 0.35, 1.70)), -0.3);
}

TEST(AvoidObstacle, CountsSwingsAnewAfterAClearStretch) {
  ActingBench bench(avoid_obstacle_kind);
  step(bench, 0.35, 1.70);
  step(bench, 1.70, 0.35);
  step(bench, 0.35, 1.70);
  for (int i = 0; i < 21; ++i) step(bench, 1, 1);  // longer than commit_s
  step(bench, 1.70, 0.35);
  EXPECT_EQ(bench.out("side"), 0);
}

// The two ends of a niche are alike: turning once right, once left it would never look at the opening between them.
TEST(AvoidObstacle, TurnsAsLastTimeWhereBothSidesAreAlike) {
  ActingBench bench(avoid_obstacle_kind);
  const auto leave = [&bench](int ticks) {
    for (int i = 0; i < ticks; ++i) step(bench, 1, 1);
  };
  step(bench, 0.20, 0.60);  // right, plainly
  leave(50);
  ASSERT_EQ(bench.out("side"), 0);
  step(bench, 0.25, 0.20);
  EXPECT_EQ(bench.out("side"), 1);  // 5 cm tell nothing: as last time
  leave(50);
  step(bench, 0.60, 0.20);
  EXPECT_EQ(bench.out("side"), -1);  // the left is plainly freer
  leave(400);                        // longer than side_memory_s and commit_s
  step(bench, 0.20, 0.25);
  EXPECT_EQ(bench.out("side"), 1);
}

// Row 13.
TEST(AvoidObstacle, IsInactiveWithADeadSonarInTheListing) {
  EXPECT_EQ(first(0.30, kNan, "listing").kind, CommandKind::Inactive);  // distance 0: escape has it
}

TEST(AvoidObstacle, TurnsAwayAtHalfSpeedWithOneSonar) {
  const Command command = first(0.26, kNan, "recommended");  // x = 0.40 - 0.26, room (0.26 - 0.12) / 0.28
  EXPECT_NEAR(turn_of(command), 0.25 * 0.14, 1e-12);
  EXPECT_NEAR(forward_of(command), 0.5 * (1.0 / 3) * 0.5 * 0.86, 1e-12);
  EXPECT_LT(turn_of(first(kNan, 0.26, "recommended")), 0);
  EXPECT_EQ(first(1.0, kNan, "recommended").kind, CommandKind::Inactive);
  EXPECT_EQ(first(kNan, kNan, "recommended").kind, CommandKind::Inactive);
}

TEST(AvoidObstacle, RefusesRangesOutOfOrder) {
  const auto made =
      avoid_obstacle_kind.make(testing::settings(avoid_obstacle_kind.descriptor, {{"stop_range_m", 0.3}}));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().what.en,
            "must be stop_range_m < commit_range_m <= trigger_range_m, are 0.3, 0.25, 0.4: it could come to a stand");
  EXPECT_EQ(made.error().what.es,
            "debe ser stop_range_m < commit_range_m <= trigger_range_m, son 0.3, 0.25, 0.4: podría quedarse parado");
}

TEST(AvoidObstacle, HasGoodHabitsOnAnyReadings) {
  testing::expect_good_habits(avoid_obstacle_kind, {}, {}, 0.1);
  testing::expect_good_habits(avoid_obstacle_kind, {}, {"escaping"}, 0.1);
  testing::expect_good_habits(avoid_obstacle_kind, {{"preset", "listing"}}, {}, 1.6);
}

}  // namespace
}  // namespace ganglion
