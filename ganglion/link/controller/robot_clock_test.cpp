#include "ganglion/link/controller/robot_clock.h"

#include <gtest/gtest.h>

#include <limits>

namespace ganglion::link {
namespace {

using Step = RobotClock::Step;

RobotClock begun_at(double told_s) {
  RobotClock clock;
  clock.start(told_s);
  return clock;
}

TEST(RobotClock, GivesTheBitsOfAClockThatGrows) {
  RobotClock clock = begun_at(0.1);
  EXPECT_EQ(clock.time_s(), 0.1);
  for (const double told_s : {0.2, 0.30000000000000004, 0.4}) {
    EXPECT_EQ(clock.take(told_s, 0.1, 0.002), Step::Regular);
    EXPECT_EQ(clock.time_s(), told_s);
    EXPECT_FALSE(clock.news());
  }
}

TEST(RobotClock, CarriesOnCountersOf32Bits) {
  for (const double span_s : {4294.967296, 4294967.296}) {
    RobotClock clock = begun_at(span_s - 0.04);
    EXPECT_EQ(clock.take(0.06, 0.1, 0), Step::Wrapped) << span_s;
    EXPECT_TRUE(clock.news());
    EXPECT_NEAR(clock.time_s(), span_s + 0.06, 1e-9);
    EXPECT_EQ(clock.take(0.16, 0.1, 0), Step::Regular);
    EXPECT_NEAR(clock.time_s(), span_s + 0.16, 1e-9);
  }
  RobotClock early = begun_at(4200);
  EXPECT_EQ(early.take(0.06, 0.1, 0), Step::WentBack) << "95 s before its end a counter does not wrap";
}

TEST(RobotClock, TakesUpAgainWhereTheFrameWasDue) {
  RobotClock clock = begun_at(3600);
  EXPECT_EQ(clock.take(0.1, 0.1, 0), Step::WentBack);
  EXPECT_NEAR(clock.time_s(), 3600.1, 1e-9);
  EXPECT_EQ(clock.stood_s(), 0) << "what it reads is new";
  EXPECT_EQ(clock.take(0.2, 0.1, 0), Step::Regular);
  EXPECT_NEAR(clock.time_s(), 3600.2, 1e-9);
  EXPECT_EQ(clock.take(1e9, 0.1, 0), Step::Jumped);
  EXPECT_NEAR(clock.time_s(), 3600.3, 1e-6);
  EXPECT_EQ(clock.take(1e9 + 0.1, 0.1, 0), Step::Regular);
  EXPECT_NEAR(clock.time_s(), 3600.4, 1e-6);
}

TEST(RobotClock, MayBeLateByHalfAndASecondAndFollowsARobotThatWaitedForUs) {
  RobotClock clock = begun_at(0);
  EXPECT_EQ(clock.take(1.1, 0.1, 0), Step::Regular);
  EXPECT_EQ(clock.take(2.3, 0.1, 0), Step::Jumped);
  EXPECT_EQ(clock.take(62.3, 0.1, 59.5), Step::Regular) << "somebody paused the run for a minute";
  EXPECT_NEAR(clock.time_s(), 61.2, 1e-9);
}

TEST(RobotClock, LetsReadingsGrowOldWhileItStands) {
  RobotClock clock = begun_at(5);
  EXPECT_EQ(clock.take(5, 0.1, 0.1), Step::Stood);
  EXPECT_TRUE(clock.news());
  EXPECT_NEAR(clock.time_s(), 5.1, 1e-12);
  EXPECT_NEAR(clock.stood_s(), 0.1, 1e-12);
  EXPECT_EQ(clock.take(5.005, 0.1, 0.1), Step::Stood) << "a twentieth of what had to pass";
  EXPECT_FALSE(clock.news());
  EXPECT_NEAR(clock.stood_s(), 0.2, 1e-12);
  EXPECT_EQ(clock.take(5.105, 0.1, 0.1), Step::Regular);
  EXPECT_NEAR(clock.time_s(), 5.3, 1e-12);
  EXPECT_EQ(clock.stood_s(), 0);
}

TEST(RobotClock, IsHopelessAfterThreeIrregularFramesInARowAndNotAfterTwo) {
  RobotClock clock = begun_at(5);
  clock.take(5, 0.1, 0);
  clock.take(5, 0.1, 0);
  EXPECT_FALSE(clock.hopeless());
  RobotClock better = clock;
  clock.take(5, 0.1, 0);
  EXPECT_TRUE(clock.hopeless());
  EXPECT_NE(clock.words(Step::Stood).en.find("stands at 5 s"), std::string::npos);
  for (int n = 1; n <= 6; ++n) better.take(5 + 0.1 * n, 0.1, 0);
  better.take(0, 0.1, 0);
  EXPECT_FALSE(better.hopeless()) << "forgiven";
  EXPECT_TRUE(better.news());
}

TEST(RobotClock, DoesNotRepeatWhatIsNoNumber) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  RobotClock clock = begun_at(kNan);
  EXPECT_EQ(clock.time_s(), 0);
  EXPECT_EQ(clock.take(kNan, 0.1, 0), Step::Stood);
  EXPECT_EQ(clock.take(std::numeric_limits<double>::infinity(), 0.1, 0), Step::Stood);
  EXPECT_NEAR(clock.time_s(), 0.2, 1e-12);
}

TEST(RobotClock, SaysWhatItDidInBothLanguages) {
  RobotClock clock = begun_at(40);
  clock.take(4, 0.1, 0);
  for (const Step step : {Step::Wrapped, Step::WentBack, Step::Jumped, Step::Stood}) {
    EXPECT_FALSE(clock.words(step).en.empty());
    EXPECT_FALSE(clock.words(step).es.empty());
  }
  EXPECT_NE(clock.words(Step::WentBack).en.find("by 36 s, to 4 s, where 0.1 s"), std::string::npos);
}

}  // namespace
}  // namespace ganglion::link
