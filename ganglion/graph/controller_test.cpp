#include "ganglion/graph/controller.h"

#include <gtest/gtest.h>

#include "ganglion/graph/testing/rig.h"
#include "ganglion/module/testing/allocations.h"

namespace ganglion {
namespace {

using testing::first, testing::gain, testing::puppet, testing::Rig, testing::seeker, testing::sensations, testing::wish;

std::string steady_seeker(std::string_view settings) {
  return sensations({"place"}) + wish("wish", "values = [9]") +
         seeker("seeker", "wish", "tolerance = 0\nrelative = true\n" + std::string(settings));
}

const std::string kSeeker = steady_seeker("command = \"move\"");

TEST(Controller, OfNoComponentsSendsSafeValues) {
  Rig rig("");
  rig.tick(3);
  EXPECT_EQ(rig.controller.components(), 0);
  EXPECT_EQ(rig.act.tick, 3u);
  EXPECT_EQ(rig.command("grip"), 2);
  EXPECT_EQ(rig.origin("grip"), CommandOrigin::Safe);
  EXPECT_EQ(rig.controller.signals().size(), 4u);  // the command frame
}

TEST(Controller, GoesOnWhereItWasAfterItIsMoved) {
  Rig rig(kSeeker);
  rig.tick();
  Controller moved = std::move(rig.controller);
  Rig other("");
  other.controller = std::move(moved);
  other.sense.tick = 1;
  other.set("place", 3);
  other.tick();
  EXPECT_EQ(other.signal("seeker.cycles"), 2);
  EXPECT_EQ(other.signal("place"), 3);
  EXPECT_EQ(other.command("move"), 1);
}

/// Every class of component, wires of every sort, a hierarchy behind a coordinator.
std::string everything() {
  return steady_seeker("") + sensations({"a", "b", "pair"}) + puppet("puppet", "a", "b") +
         first("arbiter", R"("puppet", "seeker")", "command = \"move\"") + R"([[sensing]]
id = "surprise"
kind = "Surprise"
in.in = "place"
in.expected = "seeker.expected"
[[sensing]]
id = "sum"
kind = "Sum"
in.in = ["a", "pair.x", "move.x@previous", "arbiter.share.seeker@previous", "b.age_s"]
[[sensing]]
id = "noise"
kind = "Noise"
)";
}

TEST(Controller, AllocatesNothingInATick) {
  Rig rig(everything());
  rig.cost = 1;
  rig.tick(3);
  const std::uint64_t before = testing::allocations();
  for (int i = 0; i < 100; ++i) {
    rig.sense.tick += 1;
    rig.sense.values[0] = i;
    rig.sense.values[5] = i % 3;  // a: inactive, act, withdraw in turn
    rig.controller.tick(rig.sense, 0.1, rig.act);
  }
  EXPECT_EQ(testing::allocations(), before);
}

TEST(Controller, GrowsBetweenTicksOnly) {
  Rig rig(kSeeker);
  for (int i = 0; i < 10; ++i) {
    ++rig.sense.tick;
    rig.controller.tick(rig.sense, 0.1, rig.act);
  }
  EXPECT_EQ(rig.signal("seeker.remembered"), 4);  // the Seeker grows by four steps at a time
  rig.controller.grow();
  rig.controller.tick(rig.sense, 0.1, rig.act);
  EXPECT_EQ(rig.signal("seeker.remembered"), 5);
}

TEST(Controller, NamesTheComponentWhoseKindRefusesItsParameters) {
  EXPECT_EQ(testing::problems_of(steady_seeker("command = \"move\"\nstride = 0")),
            "controller.toml:10:6: seeker: stride is 0, must be another number\n");
}

TEST(Controller, IsRefusedForARobotWhoseLimitsWouldLetNoSafeCommandThrough) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const CommandElement& bad :
       {CommandElement{.name = "x", .min = 1, .max = -1, .safe = 0}, CommandElement{.name = "x", .safe = 2},
        CommandElement{.name = "x", .max = infinite, .safe = infinite},
        CommandElement{.name = "x", .min = std::numeric_limits<double>::quiet_NaN()}}) {
    Description robot = testing::test_robot();
    robot.commands[1].elements[0] = bad;
    Problems problems;
    EXPECT_FALSE(testing::compiled("", problems, robot));
    EXPECT_NE(problems.text().find("robot \"test\": move.x: its safe value"), std::string::npos) << problems.text();
  }
}

TEST(Controller, IsRefusedWhereItsSignalsAreBeyondAllMeasure) {
  Description robot = testing::test_robot();
  for (int i = 0; i < 300'000; ++i) robot.sensations[3].elements.push_back(std::to_string(i));
  std::string text;
  for (int i = 0; i < 100; ++i) text += fmt::format("[[sensation]]\nid = \"s{}\"\nchannel = \"pair\"\n", i);
  Problems problems;
  EXPECT_FALSE(testing::compiled(text, problems, robot));
  EXPECT_NE(problems.text().find("s3: with it the signals have more than 1048576 values"), std::string::npos)
      << problems.text();
}

TEST(Controller, IsRefusedWhereItsInputsAreBeyondAllMeasure) {
  Description robot = testing::test_robot();
  for (int i = 0; i < 300'000; ++i) robot.sensations[3].elements.push_back(std::to_string(i));
  std::string text = "[[sensation]]\nid = \"s\"\nchannel = \"pair\"\n";
  for (int i = 0; i < 100; ++i) text += wish(fmt::format("g{}", i), "in.wish = \"s\"");
  Problems problems;
  EXPECT_FALSE(testing::compiled(text, problems, robot));
  EXPECT_NE(problems.text().find("the limit is 1048576"), std::string::npos) << problems.text();
}

/// A list of a thousand percepts one from the other and a hundred Puppets under one coordinator.
TEST(Controller, OfAThousandComponentsWorksAsAnyOther) {
  std::string text = sensations({"a", "b"}) + gain("n0", "a");
  for (int i = 1; i < 900; ++i) text += gain(fmt::format("n{}", i), fmt::format("n{}", i - 1));
  std::string list;
  for (int i = 0; i < 100; ++i) {
    text += puppet(fmt::format("p{}", i), i == 99 ? "b" : "b.age_s", "n899");
    list += fmt::format("\"p{}\", ", i);
  }
  Rig rig(text + first("arbiter", list, "command = \"move\""));
  rig.set("a", 5);
  rig.set("b", 1);
  rig.tick();
  EXPECT_EQ(rig.controller.components(), 1003);
  EXPECT_EQ(rig.command("move"), 5);
  EXPECT_EQ(rig.signal("arbiter.share.p99"), 1);
}

}  // namespace
}  // namespace ganglion
