#include "ganglion/acting/escape/escape.h"

#include <gtest/gtest.h>

#include "ganglion/module/testing/habits.h"

namespace ganglion {
namespace {

using testing::ActingBench;
using testing::Setting;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Command step(ActingBench& bench, double left_m, double right_m, double step_s = 0.1) {
  bench.set("left", left_m);
  bench.set("right", right_m);
  return bench.step(step_s);
}

bool escapes_at(double left_m, double right_m, const char* preset) {
  ActingBench bench(escape_kind, {{"preset", preset}});
  return step(bench, left_m, right_m).kind == CommandKind::Act;
}

/// Ticks of 0.1 s, clear readings, until it is idle; how many of them were of each phase.
std::array<int, 4> run_out(ActingBench& bench, double left_m = 1, double right_m = 1) {
  std::array<int, 4> ticks{};
  for (int i = 0; i < 1000; ++i) {
    const Command command = step(bench, left_m, right_m);
    const double phase = bench.out("phase");
    ++ticks[static_cast<std::size_t>(phase)];
    EXPECT_EQ(command.kind == CommandKind::Act, phase != 0);
    if (phase == 0) return ticks;
  }
  ADD_FAILURE() << "never idle";
  return ticks;
}

// Row 1: listing < 0.10 m; recommended <= 0.10 m or too close.
TEST(Escape, BeginsBelowTenCentimetresInTheListing) {
  EXPECT_FALSE(escapes_at(0.10, 1.0, "listing"));
  EXPECT_TRUE(escapes_at(0.0999, 1.0, "listing"));
  EXPECT_TRUE(escapes_at(1.0, 0.0999, "listing"));
}

TEST(Escape, BeginsAtTenCentimetresOrTooClose) {
  EXPECT_TRUE(escapes_at(0.10, 1.0, "recommended"));
  EXPECT_FALSE(escapes_at(0.1001, 1.0, "recommended"));
  EXPECT_TRUE(escapes_at(kInf, -kInf, "recommended"));
  EXPECT_FALSE(escapes_at(kInf, kInf, "recommended"));
}

// Row 7 and row 4: back 2.0 s at 1/6, then clockwise 0.8 s at 1/6: left forward, right backward.
TEST(Escape, FollowsTheListingAtTicksOfOneCycle) {
  ActingBench bench(escape_kind, {{"preset", "listing"}});
  Command command = step(bench, 0.05, 1, 1.6);
  EXPECT_DOUBLE_EQ(command.values[0], -1.0 / 6);
  EXPECT_DOUBLE_EQ(command.values[1], -1.0 / 6);
  EXPECT_DOUBLE_EQ(command.ttl_s, 1.6);
  command = step(bench, 1, 1, 1.6);
  EXPECT_DOUBLE_EQ(command.values[0], -1.0 / 6);
  EXPECT_NEAR(command.ttl_s, 0.4, 1e-9);
  command = step(bench, 1, 1, 1.6);
  EXPECT_DOUBLE_EQ(command.values[0], 1.0 / 6);
  EXPECT_DOUBLE_EQ(command.values[1], -1.0 / 6);
  EXPECT_NEAR(command.ttl_s, 0.8, 1e-9);
  EXPECT_EQ(step(bench, 1, 1, 1.6).kind, CommandKind::Inactive);
}

TEST(Escape, LastsAsLongAtShortTicks) {
  ActingBench listing(escape_kind, {{"preset", "listing"}});
  step(listing, 0.05, 1);
  EXPECT_EQ(run_out(listing), (std::array<int, 4>{1, 19, 8, 0}));  // 20 ticks back with the first
  ActingBench recommended(escape_kind);
  step(recommended, 0.05, 1);
  EXPECT_EQ(run_out(recommended), (std::array<int, 4>{1, 19, 15, 0}));  // turn 1.5 s
}

TEST(Escape, NeverMovesBeyondItsPartWhenAFrameIsLate) {
  ActingBench bench(escape_kind);
  EXPECT_NEAR(step(bench, 0.05, 1).ttl_s, 0.3, 1e-9);
  Command command{};
  for (int i = 1; i < 20; ++i) command = step(bench, 1, 1);
  EXPECT_NEAR(command.ttl_s, 0.1, 1e-9);  // the twentieth tick: 0.1 s of the 2.0 s is left
}

TEST(Escape, RunsToItsEndWhateverIsRead) {
  for (const double reading : {kNan, kInf, -kInf, 0.05}) {
    ActingBench bench(escape_kind);
    step(bench, 0.05, 1);
    for (int i = 1; i < 35; ++i) ASSERT_EQ(step(bench, reading, reading).kind, CommandKind::Act) << reading << i;
  }
}

TEST(Escape, TurnsTowardsTheFreerSide) {
  const auto turn = [](double left_m, double right_m) {
    ActingBench bench(escape_kind);
    Command command{};
    for (int i = 0; i <= 20; ++i) command = step(bench, left_m, right_m);
    EXPECT_EQ(bench.out("phase"), 2);
    EXPECT_DOUBLE_EQ(command.values[0], -command.values[1]);
    return command.values[0];
  };
  EXPECT_DOUBLE_EQ(turn(0.05, 0.5), 0.3);  // clockwise: the right side is freer
  EXPECT_DOUBLE_EQ(turn(0.5, 0.05), -0.3);
  EXPECT_DOUBLE_EQ(turn(kInf, -kInf), -0.3);
  EXPECT_DOUBLE_EQ(turn(0.05, 0.05), 0.3);  // as the listing
  EXPECT_DOUBLE_EQ(turn(0.05, kNan), 0.3);  // away from what was seen
  EXPECT_DOUBLE_EQ(turn(kNan, 0.05), -0.3);
}

// Avoiding has begun to turn one way: escape does not undo that.
TEST(Escape, TurnsToTheWiredSideWhicheverIsFreer) {
  const auto turn = [](double side) {
    ActingBench bench(escape_kind);
    bench.wire("side");
    bench.set("side", side);
    Command command{};
    for (int i = 0; i <= 20; ++i) command = step(bench, 0.5, 0.05);
    return command.values[0];
  };
  EXPECT_DOUBLE_EQ(turn(1), 0.3);
  EXPECT_DOUBLE_EQ(turn(-1), -0.3);
  EXPECT_DOUBLE_EQ(turn(0), -0.3);     // the left is freer
  EXPECT_DOUBLE_EQ(turn(kNan), -0.3);  // nothing known of it
}

TEST(Escape, AlwaysTurnsClockwiseInTheListing) {
  ActingBench bench(escape_kind, {{"preset", "listing"}});
  Command command{};
  for (int i = 0; i <= 20; ++i) command = step(bench, 0.5, 0.05);
  EXPECT_DOUBLE_EQ(command.values[0], 1.0 / 6);
}

// Row 7: 3 escapes in 20 s raise `stuck` and turn 180 deg.
TEST(Escape, TurnsRoundAtTheThirdEscapeInTwentySeconds) {
  ActingBench bench(escape_kind);
  for (int i = 0; i < 2; ++i) {
    step(bench, 0.05, 1);
    EXPECT_EQ(bench.out("stuck"), 0);
    run_out(bench);
  }
  step(bench, 0.05, 1);
  EXPECT_EQ(bench.out("stuck"), 1);
  EXPECT_EQ(run_out(bench), (std::array<int, 4>{1, 19, 0, 47}));  // without a heading 4.7 s
  EXPECT_EQ(bench.out("stuck"), 0);
  step(bench, 0.05, 1);
  EXPECT_EQ(bench.out("stuck"), 0);  // counted anew
}

TEST(Escape, MeasuresTheHalfTurnByHeading) {
  ActingBench bench(escape_kind);
  bench.wire("heading");
  bench.set("heading", 3.0);
  for (int i = 0; i < 2; ++i) {
    step(bench, 0.05, 1);
    run_out(bench);
  }
  step(bench, 0.05, 1);
  ASSERT_EQ(bench.out("stuck"), 1);
  double heading_rad = 3.0;
  int ticks = 0;
  while (bench.out("phase") != 0) {
    if (bench.out("phase") == 3) {
      heading_rad -= 0.1;  // clockwise: yaw falls
      ++ticks;
    }
    bench.set("heading", heading_rad);
    step(bench, 1, 1);
  }
  EXPECT_EQ(ticks, 30);  // 170 deg = 2.967 rad, ten degrees early for the lag of the compass
}

TEST(Escape, GivesUpAHalfTurnThatDoesNotTurn) {
  ActingBench bench(escape_kind, {{"half_turn_s", 4.0}});
  bench.wire("heading");
  bench.set("heading", 1.0);
  for (int i = 0; i < 2; ++i) {
    step(bench, 0.05, 1);
    run_out(bench);
  }
  step(bench, 0.05, 1);
  EXPECT_EQ(run_out(bench)[3], 80);  // twice 4 s
}

TEST(Escape, IsStuckOnlyByEscapesWithinTwentySeconds) {
  for (const double third_s : {19.5, 20.5}) {
    ActingBench bench(escape_kind);
    for (int i = 0; i < 2; ++i) {
      step(bench, 0.05, 1);
      run_out(bench);
    }
    while (bench.tick().time_s < third_s) step(bench, 1, 1);
    step(bench, 0.05, 1);
    EXPECT_EQ(bench.out("phase"), 1);
    EXPECT_EQ(bench.out("stuck"), third_s < 20 ? 1 : 0);
  }
}

// Row 13: echo 0 is distance 0: escapes for ever; recommended uses the other sonar.
TEST(Escape, EscapesForEverFromADeadSonarInTheListing) {
  ActingBench bench(escape_kind, {{"preset", "listing"}});
  for (int i = 0; i < 100; ++i) ASSERT_EQ(step(bench, 1.0, kNan, 1.6).kind, CommandKind::Act);
  EXPECT_EQ(bench.out("stuck"), 0);
}

TEST(Escape, IgnoresADeadSonar) {
  EXPECT_FALSE(escapes_at(1.0, kNan, "recommended"));
  EXPECT_TRUE(escapes_at(0.05, kNan, "recommended"));
  EXPECT_FALSE(escapes_at(kNan, kNan, "recommended"));
}

TEST(Escape, RefusesParametersThatTheListingFixes) {
  const auto made =
      escape_kind.make(testing::settings(escape_kind.descriptor, {{"preset", "listing"}, {"trigger_range_m", 0.2}}));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::BadParameter);
  EXPECT_EQ(made.error().what.en,
            "preset \"listing\" fixes trigger_range_m: leave trigger_range_m = 0.2 out, or take preset = "
            "\"recommended\"");
}

TEST(Escape, HasGoodHabitsOnAnyReadings) {
  testing::expect_good_habits(escape_kind, {}, {"heading", "side"}, 0.1);
  testing::expect_good_habits(escape_kind, {}, {}, 1.6);
  testing::expect_good_habits(escape_kind, {{"preset", "listing"}}, {}, 1.6);
}

}  // namespace
}  // namespace ganglion
