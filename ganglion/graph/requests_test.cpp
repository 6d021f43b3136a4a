#include <gtest/gtest.h>

#include <limits>

#include "ganglion/graph/testing/rig.h"

namespace ganglion {
namespace {

using testing::Rig, testing::seeker, testing::sensations, testing::wish;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kPending = 1, kSatisfied = 2;

/// A Seeker that jumps straight to its goal, which is whatever sensation `a` says.
std::string one_seeker(std::string_view settings = "") {
  return sensations({"place", "a"}) + wish("wish", "in.wish = \"a\"") +
         seeker("seeker", "wish", "stride = 100\ncommand = \"move\"\n" + std::string(settings));
}

TEST(Request, IsLatchedUntilItIsSatisfied) {
  Rig rig(one_seeker("tolerance = 0"));
  rig.set("a", 4);
  rig.tick();
  EXPECT_EQ(rig.command("move"), 4);
  rig.set("a", 7);
  rig.tick(3);
  EXPECT_EQ(rig.command("move"), 4);
  EXPECT_EQ(rig.signal("seeker.status"), kPending);
  EXPECT_EQ(rig.signal("seeker.fresh"), 1);
}

TEST(Request, GivesWayToTheNextInTheTickInWhichItIsSatisfied) {
  Rig rig(one_seeker("tolerance = 0"));
  rig.set("a", 4);
  rig.tick();
  rig.set("a", 7);
  rig.set("place", 4);
  rig.tick();
  EXPECT_EQ(rig.signal("wish.satisfied"), 1);
  EXPECT_EQ(rig.command("move"), 7);
  EXPECT_EQ(rig.signal("seeker.fresh"), 2);
}

TEST(Request, IsSatisfiedWithinItsOwnTolerance) {
  Rig rig(one_seeker("tolerance = 0.25"));
  rig.set("a", 4);
  rig.set("place", 3.5);
  rig.tick(2);
  EXPECT_EQ(rig.signal("wish.satisfied"), 0);
  rig.set("place", 3.75);
  rig.tick();
  EXPECT_EQ(rig.signal("wish.satisfied"), 1);
}

TEST(Request, OfTurnsIsComparedRoundTheCircle) {
  Rig rig(sensations({"heading"}) + wish("wish", "values = [3.1]") + R"([[acting]]
id = "turner"
kind = "Turner"
in.goal = "wish"
in.place = "heading"
tolerance = 0.1
command = "move"
)");
  rig.set("heading", -2.9);  // 2 pi - 6.0 = 0.283 apart
  rig.tick(2);
  EXPECT_EQ(rig.signal("wish.satisfied"), 0);
  rig.set("heading", -3.1);  // 2 pi - 6.2 = 0.083 apart
  rig.tick();
  EXPECT_EQ(rig.signal("wish.satisfied"), 1);
}

TEST(Request, IsNotSatisfiedByAMissingReading) {
  Rig rig(one_seeker("tolerance = 1000"));
  rig.set("a", 4);
  rig.set("place", kNaN);
  rig.tick(3);
  rig.set("place", -std::numeric_limits<double>::infinity());
  rig.tick(3);
  EXPECT_EQ(rig.signal("wish.satisfied"), 0);
  EXPECT_EQ(rig.signal("seeker.status"), kPending);
}

std::string one_walker(std::string_view settings = "") {
  return sensations({"cell"}) + R"([[goal]]
id = "wish"
kind = "Wish"
values = [3, 1]
[[acting]]
id = "walker"
kind = "Walker"
in.goal = "wish"
in.place = "cell"
command = "drive"
)" + std::string(settings);
}

TEST(Request, OfCellsNeedsEveryElementExactly) {
  Rig rig(one_walker());
  rig.set("cell", {3, 0});
  rig.tick(2);
  EXPECT_EQ(rig.signal("wish.satisfied"), 0);
  rig.set("cell", {3, 1});
  rig.tick();
  EXPECT_EQ(rig.signal("wish.satisfied"), 1);
}

TEST(Request, OfCellsTakesNoTolerance) {
  EXPECT_EQ(
      testing::problems_of(one_walker("tolerance = 0.5\n")),
      "controller.toml:15:13: walker: tolerance is 0.5, but \"place\" is made of whole numbers, which are compared "
      "exactly; leave it out\n");
}

TEST(Request, OfMetresIsSatisfiedWithinFiveCentimetresUnlessToldOtherwise) {
  Rig rig(one_seeker());
  rig.set("a", 4);
  rig.set("place", 3.94);
  rig.tick(2);
  EXPECT_EQ(rig.signal("wish.satisfied"), 0);
  rig.set("place", 3.96);
  rig.tick();
  EXPECT_EQ(rig.signal("wish.satisfied"), 1);
}

/// A Seeker that is asked for 4 m while `a` is above 0.
std::string asked_at_times(std::string_view command) {
  return sensations({"place", "a"}) + wish("wish", "in.wanted = \"a\"\nvalues = [4]") +
         seeker("seeker", "wish", command);
}

TEST(Request, LeavesAModuleInactiveWhileNothingIsAsked) {
  Rig rig(asked_at_times("command = \"grip\""));
  rig.tick(2);
  EXPECT_EQ(rig.signal("seeker.cycles"), 0);
  EXPECT_EQ(rig.signal("seeker.active"), 0);
  EXPECT_EQ(rig.signal("seeker.status"), 0);
  EXPECT_EQ(rig.origin("grip"), CommandOrigin::Safe);
  EXPECT_EQ(rig.command("grip"), 2);
}

TEST(Request, KeepsItsStatusAfterSatisfactionForOnlookers) {
  Rig rig(asked_at_times("command = \"move\""));
  rig.set("a", 1);
  rig.tick();
  rig.set("a", 0);
  rig.set("place", 4);
  rig.tick();
  EXPECT_EQ(rig.signal("seeker.status"), kSatisfied);
  EXPECT_EQ(rig.origin("move"), CommandOrigin::Safe);
}

}  // namespace
}  // namespace ganglion
