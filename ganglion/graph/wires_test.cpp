#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ganglion/graph/testing/rig.h"

namespace ganglion {
namespace {

using testing::gain, testing::puppet, testing::Rig, testing::seeker, testing::sensations, testing::wish;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

TEST(Wires, CarryPerceptsInTheirOrderWhateverTheOrderOfTheFile) {
  Rig rig(gain("third", "second", 5) + gain("first", "a", 2) + gain("second", "first", 3) + sensations({"a"}));
  rig.set("a", 1);
  rig.tick();
  EXPECT_EQ(rig.signal("third.out"), 30);
}

TEST(Wires, MarkedPreviousCarryTheValueOfTheTickBefore) {
  Rig rig(sensations({"a"}) + gain("now", "a") + gain("delayed", "now@previous") + gain("late", "a@previous"));
  rig.set("a", 1);
  rig.tick();
  EXPECT_TRUE(std::isnan(rig.signal("delayed.out")));  // nothing was sensed before the first tick
  rig.set("a", 2);
  rig.tick();
  EXPECT_EQ(rig.signal("now.out"), 2);
  EXPECT_EQ(rig.signal("delayed.out"), 1);
  EXPECT_EQ(rig.signal("late.out"), 1);
}

TEST(Wires, ReadTheLastCommandFrame) {
  Rig rig(sensations({"a", "b"}) + puppet("puppet", "a", "b", "command = \"move\"") + gain("echo", "move.x@previous") +
          gain("force", "grip@previous"));
  rig.tick();
  EXPECT_EQ(rig.signal("echo.out"), 0);
  EXPECT_EQ(rig.signal("force.out"), 2);  // safe
  rig.set("a", 1);
  rig.set("b", 30);
  rig.tick(2);
  EXPECT_EQ(rig.signal("echo.out"), 10);  // as it was sent: within limits
}

TEST(Wires, PassMissingReadingsOn) {
  Rig rig(sensations({"a"}) + gain("same", "a"));
  for (const double missing : {kInf, -kInf}) {
    rig.set("a", missing);
    rig.tick();
    EXPECT_EQ(rig.signal("a"), missing);
    EXPECT_EQ(rig.signal("same.out"), missing);
  }
  rig.set("a", kNaN);
  rig.tick();
  EXPECT_TRUE(std::isnan(rig.signal("a")));
  EXPECT_TRUE(std::isnan(rig.signal("same.out")));
}

TEST(Wires, HaveNoNegativeZero) {
  Rig rig(sensations({"a"}));
  rig.set("a", -0.0);
  rig.tick();
  EXPECT_FALSE(std::signbit(rig.signal("a")));
}

TEST(Ages, OfSensationsCanBeWired) {
  Rig rig(sensations({"a"}) + gain("age", "a.age_s"));
  rig.age("a", 0.25);
  rig.tick();
  EXPECT_EQ(rig.signal("a.age_s"), 0.25);
  EXPECT_EQ(rig.signal("age.out"), 0.25);
}

/// A Gain and the age of its input as an acting module sees it: AgeOf's output.
std::string age_of(std::string_view id, std::string_view source) {
  return fmt::format("[[sensing]]\nid = \"{}\"\nkind = \"AgeOf\"\nin.in = \"{}\"\n", id, source);
}

TEST(Ages, OfPerceptsAreThoseOfTheOldestReading) {
  Rig rig(sensations({"a", "b"}) + "[[sensing]]\nid = \"both\"\nkind = \"Sum\"\nin.in = [\"a\", \"b\"]\n" +
          gain("later", "both") + age_of("age", "later"));
  rig.age("a", 0.25);
  rig.age("b", 0.75);
  rig.tick();
  EXPECT_EQ(rig.signal("age.out"), 0.75);
}

TEST(Ages, GrowByATickOnThePreviousWire) {
  Rig rig(sensations({"a"}) + gain("now", "a") + age_of("age", "now@previous") + age_of("of_command", "move@previous"));
  rig.age("a", 0.25);
  rig.tick(2);
  EXPECT_DOUBLE_EQ(rig.signal("age.out"), 0.35);
  EXPECT_DOUBLE_EQ(rig.signal("of_command.out"), 0.1);
}

TEST(Ages, ThatAreNotNumbersMeanNeverMeasured) {
  Rig rig(sensations({"a"}) + gain("now", "a") + age_of("age", "now"));
  for (const double bad : {kNaN, -1.0}) {
    rig.age("a", bad);
    rig.tick();
    EXPECT_EQ(rig.signal("a.age_s"), kInf);
    EXPECT_EQ(rig.signal("age.out"), kInf);
  }
}

TEST(Ages, OfAPerceptDoNotGrowByItsOwnMemory) {
  Rig rig(sensations({"a"}) + "[[sensing]]\nid = \"total\"\nkind = \"Sum\"\nin.in = [\"a\", \"echo\"]\n" +
          gain("echo", "total@previous") + age_of("age", "total"));
  rig.age("a", 0.25);
  rig.tick(5);
  EXPECT_EQ(rig.signal("age.out"), 0.25);
}

TEST(Ages, OfAPerceptDoNotDependOnWhatWasExpected) {
  Rig rig(sensations({"place"}) + wish("wish", "values = [5]") + seeker("seeker", "wish", "command = \"move\"") +
          R"([[sensing]]
id = "surprise"
kind = "Surprise"
in.in = "place"
in.expected = "seeker.expected"
)" + age_of("age", "surprise.error"));
  rig.age("place", 0.05);
  rig.tick();
  EXPECT_EQ(rig.signal("age.out"), 0.05);
}

TEST(Ages, OfSignalsOfGoalsAndActingModulesAreZeroInTheirTick) {
  Rig rig(sensations({"a", "place"}) + wish("wish", "in.wanted = \"a\"\nvalues = [5]") +
          seeker("seeker", "wish", "command = \"move\"") + age_of("of_goal", "wish.bids@previous") +
          age_of("of_acting", "seeker.cycles@previous"));
  rig.tick(2);
  EXPECT_DOUBLE_EQ(rig.signal("of_goal.out"), 0.1);
  EXPECT_DOUBLE_EQ(rig.signal("of_acting.out"), 0.1);
}

TEST(Appraisals, ArriveWhereTheySenseAtTheNextTick) {
  Rig rig(sensations({"place"}) + R"([[sensing]]
id = "surprise"
kind = "Surprise"
in.in = "place"
in.expected = "seeker.expected"
)" + wish("wish", "values = [5]") +
          seeker("seeker", "wish", "relative = true\ncommand = \"move\""));
  rig.set("place", 2);
  rig.tick();
  EXPECT_TRUE(std::isnan(rig.signal("surprise.heard")));  // nobody expected anything of the first frame
  rig.set("place", 2.75);
  rig.tick();
  EXPECT_EQ(rig.signal("surprise.heard"), 3);
  EXPECT_EQ(rig.signal("surprise.error"), -0.25);
}

TEST(Appraisals, ComeFromAppraisalPortsOnly) {
  const std::string text = sensations({"place"}) + R"([[sensing]]
id = "surprise"
kind = "Surprise"
in.in = "place"
in.expected = "place"
)";
  EXPECT_EQ(testing::problems_of(text),
            "controller.toml:9:15: surprise: input \"expected\" takes what an acting module expects; \"place\" is no "
            "appraisal\n");
}

TEST(Wires, GiveOpenPortsTheShapeAndUnitOfWhatIsWired) {
  Rig rig(sensations({"pair", "place"}) + R"([[sensing]]
id = "second"
kind = "Copy"
in.in = "first"
[[sensing]]
id = "first"
kind = "Copy"
in.in = "pair"
[[sensing]]
id = "metres"
kind = "Copy"
in.in = "place"
[[acting]]
id = "seeker"
kind = "Seeker"
in.goal = "wish"
in.place = "metres"
command = "move"
)" + wish("wish", "values = [5]") +
          gain("half", "second.out.y"));
  rig.set("pair", {3, 4});
  rig.tick();
  EXPECT_EQ(rig.signal("second.out.x"), 3);
  EXPECT_EQ(rig.signal("half.out"), 4);
}

TEST(Wires, LeaveTheNameOfACommandToTheCommand) {
  EXPECT_EQ(testing::problems_of("[[sensation]]\nid = \"move\"\nchannel = \"a\"\n"),
            "controller.toml:3:6: move: the robot has a command of this name; choose another id\n");
}

}  // namespace
}  // namespace ganglion
