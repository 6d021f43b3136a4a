#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ganglion/graph/testing/rig.h"

namespace ganglion {
namespace {

using testing::Rig, testing::seeker, testing::sensations, testing::wish;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// A puppet on `drive`: `a` is what it does (0 nothing, 1 act, 2 withdraw), `pair` its values, `b` their time to live.
std::string driver() {
  return sensations({"a", "b", "pair"}) + R"([[acting]]
id = "driver"
kind = "Puppet"
in.act = "a"
in.value = "pair"
in.ttl_s = "b"
command = "drive"
)";
}

Rig driving(double left, double right, double ttl_s = kInf) {
  Rig rig(driver());
  rig.set("a", 1);
  rig.set("b", ttl_s);
  rig.set("pair", {left, right});
  rig.tick();
  return rig;
}

TEST(Commands, AreClampedToTheirLimits) {
  const Rig rig = driving(1.5, -7);
  EXPECT_EQ(rig.command("drive", 0), 1);
  EXPECT_EQ(rig.command("drive", 1), -1);
  EXPECT_EQ(rig.origin("drive"), CommandOrigin::Commanded);
  EXPECT_EQ(rig.signal("driver.command.left"), 1.5);  // as commanded
  EXPECT_EQ(rig.signal("drive.left"), 1);             // as sent
}

TEST(Commands, ThatAreNotNumbersBecomeTheSafeValueAndRaiseAFlag) {
  for (const double bad : {kNaN, kInf, -kInf}) {
    const Rig rig = driving(0.5, bad);
    EXPECT_EQ(rig.command("drive", 0), 0);
    EXPECT_EQ(rig.command("drive", 1), 0);
    EXPECT_EQ(rig.origin("drive"), CommandOrigin::Refused);
  }
}

TEST(Commands, OfNobodyAreSafe) {
  Rig rig(driver());
  rig.tick();
  EXPECT_EQ(rig.origin("drive"), CommandOrigin::Safe);
  EXPECT_EQ(rig.origin("grip"), CommandOrigin::Safe);
  EXPECT_EQ(rig.command("grip"), 2);
  EXPECT_EQ(rig.signal("grip.force"), 2);
  EXPECT_EQ(rig.act.tick, 1u);
}

TEST(Commands, HaveNoNegativeZero) {
  const Rig rig = driving(-0.0, 0.0);
  EXPECT_FALSE(std::signbit(rig.command("drive", 0)));
}

TEST(Commands, LiveForThreeTenthsOfASecondUnlessTheModuleSaysLess) {
  EXPECT_EQ(driving(0, 0).ttl_s("drive"), 0.3);
  EXPECT_EQ(driving(0, 0, 0.04).ttl_s("drive"), 0.04);
  EXPECT_EQ(driving(0, 0, 60).ttl_s("drive"), 0.3);
  EXPECT_EQ(driving(0, 0, kNaN).ttl_s("drive"), 0.3);
  EXPECT_EQ(driving(0, 0, -1).ttl_s("drive"), 0.3);
}

TEST(Commands, LiveForOneAndAHalfTicksWhereTicksAreLong) {
  Rig rig = driving(0, 0);
  rig.controller.tick(rig.sense, 1.6, rig.act);
  EXPECT_DOUBLE_EQ(rig.ttl_s("drive"), 2.4);
}

TEST(Commands, WithdrawnAreSafeAndGiveTheReason) {
  Rig rig(driver());
  rig.set("a", 2);
  rig.set("pair", {1, 1});
  rig.tick();
  EXPECT_EQ(rig.command("drive", 0), 0);
  EXPECT_EQ(rig.origin("drive"), CommandOrigin::Withdrawn);
  EXPECT_EQ(rig.reason("drive"), ReasonCode::NoReading);
  rig.set("a", 1);
  rig.tick();
  EXPECT_EQ(rig.origin("drive"), CommandOrigin::Commanded);
  EXPECT_EQ(rig.reason("drive"), ReasonCode::None);
}

/// Upper on lower on `move`; the upper one gives up at once where a = 5, and both serve one wish.
std::string pair_of_seekers() {
  return sensations({"place", "a"}) + wish("wish", "in.wish = \"a\"\nreplaces = true") +
         seeker("upper", "wish", "tolerance = 0\ngive_up_at = 5") +
         seeker("lower", "upper", "tolerance = 0\nrelative = true\ncommand = \"move\"");
}

TEST(Commands, StayWithdrawnUntilANewRequestAndSayWhyTheTopGaveUp) {
  Rig rig(pair_of_seekers());
  rig.set("a", 9);
  rig.set("place", 5);
  for (int tick = 1; tick <= 2; ++tick) {  // backed off for the second tick
    rig.tick();
    EXPECT_EQ(rig.origin("move"), CommandOrigin::Withdrawn) << tick;
    EXPECT_EQ(rig.reason("move"), ReasonCode::Trapped) << tick;
    EXPECT_EQ(rig.signal("upper.status"), 3) << tick;
    EXPECT_EQ(rig.signal("lower.cycles"), 0) << tick;
  }
  rig.set("place", 4);
  rig.set("a", 3);
  rig.tick();
  EXPECT_EQ(rig.origin("move"), CommandOrigin::Commanded);
  EXPECT_EQ(rig.command("move"), -1);
  EXPECT_EQ(rig.reason("move"), ReasonCode::None);
}

TEST(Costs, AreNotChargedForACommandThatWasNotCarriedOut) {
  Rig rig(driver());
  rig.cost = 1;
  rig.tick(2);
  EXPECT_EQ(rig.signal("driver.adaptations"), 0);  // inactive
  rig.set("a", 2);
  rig.tick(2);
  EXPECT_EQ(rig.signal("driver.adaptations"), 0);  // withdrawn
  rig.set("a", 1);
  rig.set("pair", {kNaN, 0});
  rig.tick(2);
  EXPECT_EQ(rig.signal("driver.adaptations"), 0);  // refused
  EXPECT_EQ(rig.signal("driver.granted"), 0);
  rig.set("pair", {1, 0});
  rig.tick(2);
  EXPECT_EQ(rig.signal("driver.adaptations"), 1);
  EXPECT_EQ(rig.signal("driver.granted"), 1);
}

TEST(Costs, ThatAreNotNumbersAreUnknown) {
  Rig rig = driving(0.5, 0.5);
  for (const double bad : {kNaN, kInf, -kInf}) {
    rig.cost = bad;
    rig.tick();
  }
  EXPECT_EQ(rig.signal("driver.adaptations"), 0);
}

}  // namespace
}  // namespace ganglion
