#include "ganglion/acting/hold_heading/hold_heading.h"

#include <gtest/gtest.h>

#include "ganglion/module/testing/habits.h"

namespace ganglion {
namespace {

using testing::ActingBench;
using testing::Setting;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

double rad(double deg) { return deg * kPi / 180; }
/// Yaw of a compass bearing, by hand: bearings count clockwise from north, yaw from east the other way.
double yaw_rad(double bearing_deg) { return std::remainder(rad(90 - bearing_deg), 2 * kPi); }
double turn_of(const Command& command) { return (command.values[0] - command.values[1]) / 2; }
double forward_of(const Command& command) { return (command.values[0] + command.values[1]) / 2; }

/// The listing, one program cycle a tick, bearings in degrees.
class Listing {
 public:
  Listing() : bench_(hold_heading_kind, {{"preset", "listing"}}) { bench_.wire("displaced_by", 2); }
  Command step(double bearing_deg, bool displaced = false) {
    bench_.set("heading", yaw_rad(bearing_deg));
    bench_.set("displaced_by", {0, displaced ? 1.0 : 0.0});
    return bench_.step(1.6);
  }
  ActingBench& bench() { return bench_; }

 private:
  ActingBench bench_;
};

/// Ten frames a second, yaw in degrees; the course is 0 deg from the third frame on.
class Recommended {
 public:
  explicit Recommended(std::initializer_list<Setting> list = {}, bool sonars = false)
      : bench_(hold_heading_kind, list) {
    bench_.wire("displaced_by", 2);
    if (sonars) {
      bench_.wire("left");
      bench_.wire("right");
      ranges(kInf, kInf);
    }
    for (int i = 0; i < 3; ++i) step(0);
  }
  Command step(double yaw_deg, bool displaced = false) {
    bench_.set("heading", rad(yaw_deg));
    bench_.set("displaced_by", {displaced ? 1.0 : 0.0, 0});
    return bench_.step(0.1);
  }
  void ranges(double left_m, double right_m) {
    bench_.set("left", left_m);
    bench_.set("right", right_m);
  }
  ActingBench& bench() { return bench_; }

 private:
  ActingBench bench_;
};

// Row 3: u = 3 int(x + 360 - 360) / 1200; row 4: clockwise for a target further clockwise; row 6: 0.04 s.
TEST(HoldHeading, TurnsByWholeDegreesInTheListing) {
  Listing robot;
  robot.step(100);
  const Command right = robot.step(78.5);  // x = 21.5: 3 * 21 / 1200
  EXPECT_DOUBLE_EQ(right.values[0], 0.0525);
  EXPECT_DOUBLE_EQ(right.values[1], -0.0525);
  EXPECT_DOUBLE_EQ(right.ttl_s, 0.04);
  const Command left = robot.step(121.5);  // x + 360 = 338.5: 3 * (338 - 360) / 1200
  EXPECT_DOUBLE_EQ(left.values[0], -0.055);
}

// Row 5: |x| < 10 deg: forward at 1/3 instead of the turn, for 0.2 s.
TEST(HoldHeading, GoesAheadWithinTenDegreesInTheListing) {
  Listing robot;
  robot.step(100);
  const Command ahead = robot.step(90.5);
  EXPECT_DOUBLE_EQ(ahead.values[0], 1.0 / 3);
  EXPECT_DOUBLE_EQ(ahead.values[1], 1.0 / 3);
  EXPECT_DOUBLE_EQ(ahead.ttl_s, 0.2);
  EXPECT_DOUBLE_EQ(robot.step(90).values[0], 0.025);  // x = 10: M = 370 is no longer below 370
  EXPECT_DOUBLE_EQ(robot.step(110).values[0], -0.025);
}

// Row 9: no wrap: 10 against 350 gives -340: 3 * -340 / 1200.
TEST(HoldHeading, DoesNotWrapInTheListing) {
  Listing robot;
  robot.step(10);
  EXPECT_DOUBLE_EQ(robot.step(350).values[0], -0.85);
  EXPECT_NEAR(robot.bench().out("error"), rad(340), 1e-6);  // counter-clockwise, the long way round
}

// Row 10: the first heading at start.
TEST(HoldHeading, TakesTheFirstHeadingForItsCourseInTheListing) {
  Listing robot;
  EXPECT_DOUBLE_EQ(robot.step(300).values[0], 1.0 / 3);
  robot.step(200);
  robot.step(201);
  EXPECT_NEAR(robot.bench().out("original"), yaw_rad(300), 1e-6);
}

// Row 8, from the program: EVITAR sets CONTADOR = 0 and its cycle ends with CONTADOR = 1. The n-th cycle of NAVEGAR
// after it begins with CONTADOR = n; the one that begins with 15 still steers RUMBO and puts the course back at its
// end.
TEST(HoldHeading, HoldsACourseForFifteenCyclesInTheListing) {
  Listing robot;
  robot.step(100);
  for (int cycle = 1; cycle <= 15; ++cycle) {
    const Command command = robot.step(40, cycle == 1);
    ASSERT_DOUBLE_EQ(command.values[0], 1.0 / 3) << cycle;
    ASSERT_EQ(robot.bench().out("held"), 1) << cycle;
    ASSERT_NEAR(robot.bench().out("target"), yaw_rad(40), 1e-6);
  }
  EXPECT_DOUBLE_EQ(robot.step(40).values[0], 0.15);  // back to 100: 3 * 60 / 1200
  EXPECT_EQ(robot.bench().out("held"), 0);
  EXPECT_NEAR(robot.bench().out("original"), yaw_rad(100), 1e-6);
  for (int cycle = 17; cycle < 60; ++cycle) ASSERT_DOUBLE_EQ(robot.step(40).values[0], 0.15) << cycle;
}

TEST(HoldHeading, CountsAgainWhenDisplacedAgainInTheListing) {
  Listing robot;
  robot.step(100);
  for (int cycle = 1; cycle <= 10; ++cycle) robot.step(40, cycle == 1);
  for (int cycle = 1; cycle <= 15; ++cycle) ASSERT_DOUBLE_EQ(robot.step(160, cycle == 1).values[0], 1.0 / 3) << cycle;
  EXPECT_DOUBLE_EQ(robot.step(160).values[0], -0.15);
}

TEST(HoldHeading, KeepsAStaleHeadingInTheListing) {
  Listing robot;
  robot.step(100);
  robot.step(70);
  robot.bench().set("heading", kNan);
  EXPECT_DOUBLE_EQ(robot.bench().step(1.6).values[0], 0.075);  // still 70
}

// Row 3 recommended: the same gain without rounding, 0.0025 a degree; yaw 21.5 deg to the left of the course:
// clockwise.
TEST(HoldHeading, TurnsInProportionWithoutRounding) {
  Recommended robot;
  EXPECT_NEAR(turn_of(robot.step(21.5)), 0.05375, 1e-12);
  EXPECT_NEAR(turn_of(robot.step(-21.5)), -0.05375, 1e-12);
  EXPECT_NEAR(robot.bench().out("error"), rad(21.5), 1e-12);
}

TEST(HoldHeading, ClampsTheTurn) {
  Recommended robot({{"gain_per_deg", 1.0}});
  const Command command = robot.step(170);
  EXPECT_EQ(command.values[0], 1);
  EXPECT_EQ(command.values[1], -1);
}

// Row 5 recommended: the speed ahead falls with |x|, here by 1/3 (1 - |x| / 90).
TEST(HoldHeading, SlowsAheadAsTheErrorGrows) {
  Recommended robot;
  EXPECT_NEAR(forward_of(robot.step(0)), 1.0 / 3, 1e-12);
  EXPECT_NEAR(forward_of(robot.step(9)), 0.9 / 3, 1e-12);
  EXPECT_NEAR(forward_of(robot.step(45)), 0.5 / 3, 1e-12);
  EXPECT_EQ(forward_of(robot.step(120)), 0);
  for (int deg = -179; deg <= 180; ++deg) {
    const Command command = robot.step(deg);
    ASSERT_GT(forward_of(command) + std::fabs(turn_of(command)), 0.1) << deg;
  }
}

// Row 9 recommended: 10 against 350 is 20 deg, and so is 260 against 280, where yaw leaps from -180 to 180.
TEST(HoldHeading, WrapsTheError) {
  for (const auto& [course_deg, bearing_deg] : {std::pair{10.0, 350.0}, {260.0, 240.0}, {280.0, 260.0}}) {
    ActingBench bench(hold_heading_kind);
    bench.set("heading", yaw_rad(course_deg));
    for (int i = 0; i < 3; ++i) bench.step(0.1);
    bench.set("heading", yaw_rad(bearing_deg));
    EXPECT_NEAR(turn_of(bench.step(0.1)), 0.05, 1e-12) << course_deg;
  }
}

// Row 10 recommended: the median of three that agree within 5 deg; it stands until then.
TEST(HoldHeading, StandsUntilThreeReadingsAgree) {
  ActingBench bench(hold_heading_kind);
  const auto step = [&](double deg) {
    bench.set("heading", rad(deg));
    return bench.step(0.1);
  };
  for (const double deg : {178.0, 90.0, -179.0, -90.0}) {
    const Command command = step(deg);
    EXPECT_EQ(command.kind, CommandKind::Act);
    EXPECT_EQ(command.values[0], 0);
    EXPECT_EQ(command.values[1], 0);
    EXPECT_TRUE(std::isnan(bench.out("original")));
  }
  EXPECT_GT(step(-178).values[0], 0);
  EXPECT_NEAR(bench.out("original"), rad(-179), 1e-12);  // of 178, -179, -178 across the half turn
}

TEST(HoldHeading, DoesNotTakeOneOldReadingForThree) {
  ActingBench bench(hold_heading_kind);
  bench.set("heading", 1);
  for (int i = 0; i < 10; ++i) {
    bench.age("heading", 0.1 * i);
    ASSERT_EQ(bench.step(0.1).values[0], 0);
  }
}

TEST(HoldHeading, SteersAWiredCourse) {
  ActingBench bench(hold_heading_kind);
  bench.wire("course");
  bench.set("heading", 0);
  for (int i = 0; i < 5; ++i) ASSERT_EQ(bench.step(0.1).values[0], 0);  // no course yet: stands
  bench.set("course", rad(-20));
  EXPECT_NEAR(turn_of(bench.step(0.1)), 0.05, 1e-12);
  bench.set("course", kNan);
  EXPECT_NEAR(turn_of(bench.step(0.1)), 0.05, 1e-12);  // the last one stays
}

TEST(HoldHeading, SteersAWiredCourseInTheListing) {
  ActingBench bench(hold_heading_kind, {{"preset", "listing"}});
  bench.wire("course");
  bench.set("heading", yaw_rad(100));
  bench.set("course", yaw_rad(120));
  EXPECT_DOUBLE_EQ(bench.step(1.6).values[0], 0.05);
}

// Row 8 recommended: 3 s = 30 frames, the one after the displacement included.
TEST(HoldHeading, HoldsTheHeadingItWasLeftWith) {
  Recommended robot;
  for (int i = 0; i < 30; ++i) {
    ASSERT_NEAR(turn_of(robot.step(60, i == 0)), 0, 1e-12) << i;
    ASSERT_EQ(robot.bench().out("held"), 1) << i;
  }
  EXPECT_NEAR(turn_of(robot.step(60)), 0.15, 1e-12);
  EXPECT_EQ(robot.bench().out("held"), 0);
}

TEST(HoldHeading, LetsALaggingCompassCatchUpBeforeItHolds) {
  Recommended robot;
  for (int i = 0; i < 15; ++i) ASSERT_NEAR(turn_of(robot.step(60 + i, i == 0)), 0, 1e-12) << i;  // settle_s = 1.5
  EXPECT_NEAR(turn_of(robot.step(80)), 0.0025 * 6, 1e-12);                                       // holds 74
}

TEST(HoldHeading, HoldsLongerTheLongerItWasDisplaced) {
  Recommended robot;
  const auto held_after = [&robot](int displaced_ticks) {
    for (int i = 0; i < displaced_ticks; ++i) robot.step(60, true);
    int ticks = 0;
    while (robot.bench().out("held") == 1 && ticks < 1000) {
      robot.step(60);
      ++ticks;
    }
    return ticks;
  };
  EXPECT_EQ(held_after(100), 200);  // 10 s, twice that
  EXPECT_EQ(held_after(50), 300);   // not calm for 5 s since: 15 s
  EXPECT_EQ(held_after(200), 480);  // no more than 48 s
  for (int i = 0; i < 50; ++i) robot.step(0);
  EXPECT_EQ(held_after(1), 30);  // forgotten
}

// Displaced for 10 s it holds for 20 s: 3 s fully, and then back to the course at 0 deg in the 17 s that are left.
TEST(HoldHeading, ComesBackLittleByLittleWhereItIsToldTo) {
  Recommended robot({{"hold_return", 1.0}});
  for (int i = 0; i < 100; ++i) robot.step(60, true);
  const auto target_deg_after = [&robot](int ticks) {
    for (int i = 0; i < ticks; ++i) robot.step(60);
    return robot.bench().out("target") * 180 / kPi;
  };
  EXPECT_NEAR(target_deg_after(29), 60, 1e-9);
  EXPECT_NEAR(target_deg_after(86), 30, 1e-9);  // 11.5 s: half of the rest
  EXPECT_EQ(robot.bench().out("held"), 1);
  EXPECT_NEAR(target_deg_after(85), 0, 1e-9);
  EXPECT_EQ(robot.bench().out("held"), 0);
}

// More than 110 deg off the course: back little by little would be a circle into the same dead end.
TEST(HoldHeading, LeavesADeadEndBeforeItComesBack) {
  Recommended robot({{"hold_return", 1.0}});
  for (int i = 0; i < 100; ++i) robot.step(150, true);
  for (int i = 0; i < 199; ++i) robot.step(150);
  EXPECT_NEAR(robot.bench().out("target") * 180 / kPi, 150, 1e-9);
  robot.step(150);
  EXPECT_NEAR(robot.bench().out("target"), 0, 1e-9);
}

TEST(HoldHeading, HoldsTheFirstHeadingThatIsBackAfterADisplacement) {
  Recommended robot;
  robot.step(kNan, true);
  EXPECT_NEAR(turn_of(robot.step(50)), 0, 1e-12);
  EXPECT_EQ(robot.bench().out("held"), 1);
}

TEST(HoldHeading, KnowsWithoutAWireThatItWasOverruled) {
  ActingBench bench(hold_heading_kind);
  bench.set("heading", 0);
  for (int i = 0; i < 4; ++i) bench.step(0.1);
  bench.set("heading", rad(60));
  EXPECT_EQ(turn_of(bench.step(0.1, false)), 0);
  EXPECT_EQ(bench.out("held"), 1);
}

// Row 13 recommended: half speed with one sonar, stops with none and says so.
TEST(HoldHeading, GoesHalfAsFastWithOneSonar) {
  Recommended robot({}, true);
  robot.ranges(1.0, kNan);
  EXPECT_NEAR(forward_of(robot.step(0)), 0.5 / 3, 1e-12);
  EXPECT_EQ(robot.bench().out("blind"), 0);
}

TEST(HoldHeading, StopsWithoutSonarsAndSaysSo) {
  Recommended robot({}, true);
  robot.ranges(kNan, kNan);
  const Command command = robot.step(10);
  EXPECT_EQ(command.kind, CommandKind::Act);
  EXPECT_EQ(command.values[0], 0);
  EXPECT_EQ(command.values[1], 0);
  EXPECT_EQ(robot.bench().out("blind"), 1);
  robot.ranges(1, 1);
  EXPECT_GT(forward_of(robot.step(10)), 0);
  EXPECT_EQ(robot.bench().out("blind"), 0);
}

TEST(HoldHeading, SlowsNearObstacles) {
  Recommended robot({}, true);
  robot.ranges(0.45, 2.0);  // 0.45 / 0.60
  EXPECT_NEAR(forward_of(robot.step(0)), 0.75 / 3, 1e-12);
  robot.ranges(-kInf, kInf);
  EXPECT_NEAR(forward_of(robot.step(0)), 0.3 / 3, 1e-12);
  robot.ranges(kInf, kInf);
  EXPECT_NEAR(forward_of(robot.step(0)), 1.0 / 3, 1e-12);
}

TEST(HoldHeading, KeepsOnForHalfASecondWithoutACompassThenGoesStraightAtHalfSpeed) {
  Recommended robot;
  robot.step(20);
  for (int i = 1; i <= 5; ++i) {
    ASSERT_NEAR(turn_of(robot.step(kNan)), 0.05, 1e-12) << i;
    ASSERT_EQ(robot.bench().out("blind"), 0);
  }
  const Command command = robot.step(kNan);
  EXPECT_NEAR(command.values[0], 0.5 / 3, 1e-12);
  EXPECT_NEAR(command.values[1], 0.5 / 3, 1e-12);
  EXPECT_EQ(robot.bench().out("blind"), 1);
}

TEST(HoldHeading, StandsWithoutACompassWhereItIsToldTo) {
  Recommended robot({{"blind_share", 0.0}});
  for (int i = 0; i < 7; ++i) robot.step(kNan);
  EXPECT_EQ(forward_of(robot.step(kNan)), 0);
  EXPECT_EQ(robot.bench().out("blind"), 1);
}

TEST(HoldHeading, HasGoodHabitsOnAnyReadings) {
  testing::expect_good_habits(hold_heading_kind, {}, {"displaced_by", "left", "right"}, 0.1);
  testing::expect_good_habits(hold_heading_kind, {}, {"course"}, 0.1);
  testing::expect_good_habits(hold_heading_kind, {{"hold_return", 1.0}}, {"displaced_by"}, 0.1);
  testing::expect_good_habits(hold_heading_kind, {{"preset", "listing"}}, {"displaced_by", "course"}, 1.6);
}

}  // namespace
}  // namespace ganglion
