#include <gtest/gtest.h>

#include "ganglion/graph/testing/rig.h"

namespace ganglion {
namespace {

using testing::Rig, testing::seeker, testing::sensations, testing::wish;

/// Of a module that goes to its goal exactly, by steps that it commands.
const std::string kStep = "tolerance = 0\nrelative = true\ncommand = \"move\"\n";

/// Top to middle to bottom: strides of 2, 1 and 0.5 m; the bottom one commands steps, which the tests carry out.
std::string three_levels(std::string_view goal = "values = [4]", std::string_view bottom = "") {
  return sensations({"place", "a", "b"}) + wish("wish", goal) +
         seeker("bottom", "middle", kStep + "stride = 0.5\n" + std::string(bottom)) +
         seeker("middle", "top", "tolerance = 0\nstride = 1") + seeker("top", "wish", "tolerance = 0\nstride = 2");
}

/// Carries the last step out, at a cost of 1 J for each metre.
void advance(Rig& rig) {
  const double step = rig.command("move");
  rig.set("place", rig.signal("place") + step);
  rig.cost = step;
  rig.tick();
}

TEST(Hierarchy, WastesNoTickWhenRequestsAreHandedOver) {
  Rig rig(three_levels());
  rig.tick();  // 4 m in steps of half a metre: 8 ticks that move, and the ninth finds the goal reached
  for (int tick = 2; tick <= 8; ++tick) {
    advance(rig);
    EXPECT_EQ(rig.command("move"), 0.5) << "tick " << tick;
    EXPECT_EQ(rig.signal("wish.satisfied"), 0) << "tick " << tick;
  }
  advance(rig);
  EXPECT_EQ(rig.signal("place"), 4);
  EXPECT_EQ(rig.signal("wish.satisfied"), 1);
}

TEST(Hierarchy, LetsAModuleWaitWhileItsCommandIsCarriedOutBelow) {
  Rig rig(three_levels());
  rig.tick();
  for (int tick = 2; tick <= 8; ++tick) advance(rig);
  EXPECT_EQ(rig.signal("bottom.cycles"), 8);
  EXPECT_EQ(rig.signal("middle.cycles"), 4);  // waypoints 1, 2, 3, 4
  EXPECT_EQ(rig.signal("top.cycles"), 2);     // waypoints 2, 4
  EXPECT_EQ(rig.signal("bottom.fresh"), 4);
}

TEST(Hierarchy, ChargesAnUpperModuleTheSumOverTheTicksBelow) {
  Rig rig(three_levels());
  rig.tick();
  for (int tick = 2; tick <= 5; ++tick) advance(rig);  // at 2 m
  EXPECT_EQ(rig.signal("bottom.adaptations"), 4);
  EXPECT_EQ(rig.signal("bottom.charged"), 0.5);
  EXPECT_EQ(rig.signal("middle.adaptations"), 2);
  EXPECT_EQ(rig.signal("middle.charged"), 1);
  EXPECT_EQ(rig.signal("top.adaptations"), 1);
  EXPECT_EQ(rig.signal("top.charged"), 2);
}

TEST(Hierarchy, AdaptsNothingInTheFirstFrameWhichHasNoCost) {
  Rig rig(three_levels());
  rig.tick();
  rig.tick();
  EXPECT_EQ(rig.signal("bottom.adaptations"), 0);
  rig.cost = 3;
  rig.tick();
  EXPECT_EQ(rig.signal("bottom.adaptations"), 1);
  EXPECT_EQ(rig.signal("bottom.charged"), 3);
}

TEST(Hierarchy, ReplacesWhatIsUnderWayBelowWhenTheRequestIsReplacedAbove) {
  Rig rig(three_levels("in.wish = \"a\"\nreplaces = true"));
  rig.set("a", 4);
  rig.tick();
  rig.set("a", -4);
  advance(rig);
  EXPECT_EQ(rig.signal("top.command.0"), -1.5);     // 2 m back from 0.5 m
  EXPECT_EQ(rig.signal("middle.command.0"), -0.5);  // 1 m back
  EXPECT_EQ(rig.command("move"), -0.5);
}

/// As three_levels(), but the middle one is content 0.6 m short of its goal, halfway through its last step.
std::string content_middle(std::string_view goal) {
  std::string text = three_levels(goal);
  const std::string exact = "in.goal = \"top\"\nin.place = \"place\"\ntolerance = 0";
  return text.replace(text.find(exact) + exact.size() - 1, 1, "0.6");
}

TEST(Hierarchy, StopsWhatIsUnderWayBelowWhenTheRequestEndsAbove) {
  Rig rig(sensations({"place", "a"}) + wish("wish", "in.wanted = \"a\"\nvalues = [1.5]") +
          seeker("upper", "wish", "tolerance = 0.6\nstride = 2") + seeker("lower", "upper", kStep + "stride = 0.5"));
  rig.set("a", 1);
  rig.tick();
  rig.set("a", 0);
  advance(rig);
  EXPECT_EQ(rig.command("move"), 0.5);
  advance(rig);  // at 1 m, content; the lower one was still on its way to 1.5 m
  EXPECT_EQ(rig.signal("upper.status"), 2);
  EXPECT_EQ(rig.signal("lower.status"), 0);
  EXPECT_EQ(rig.signal("lower.cycles"), 2);
  EXPECT_EQ(rig.origin("move"), CommandOrigin::Safe);
}

TEST(Hierarchy, ChargesAlsoForWhatWasBrokenOffBelow) {
  Rig rig(content_middle("values = [4]"));
  rig.tick();
  for (int tick = 2; tick <= 4; ++tick) advance(rig);  // at 1.5 m: 1 J to the waypoint 1 m, 0.5 J on the way to 2 m
  EXPECT_EQ(rig.signal("middle.adaptations"), 1);      // nothing is learned from half a step
  EXPECT_EQ(rig.signal("top.charged"), 1.5);
}

TEST(Hierarchy, TellsTheUpperModuleWhyTheLowerOneGaveUp) {
  Rig rig(three_levels("values = [4]", "give_up_at = 1\n"));
  rig.tick();
  advance(rig);
  advance(rig);  // at 1 m the bottom one withdraws from 2 m
  EXPECT_EQ(rig.signal("bottom.status"), 3);
  EXPECT_EQ(rig.origin("move"), CommandOrigin::Withdrawn);
  EXPECT_EQ(rig.reason("move"), ReasonCode::Trapped);
  EXPECT_EQ(rig.command("move"), 0);
  EXPECT_EQ(rig.signal("middle.told"), 0);
  rig.tick();
  EXPECT_EQ(rig.signal("middle.told"), static_cast<double>(ReasonCode::Trapped));
  EXPECT_EQ(rig.signal("top.told"), 0);
  EXPECT_EQ(rig.signal("middle.cycles"), 3);  // waypoints 1, 2, and 2 once more
}

TEST(Hierarchy, CostsNothingMoreOnceNothingIsAskedBelow) {
  Rig rig(three_levels("in.wanted = \"a\"\nvalues = [1]"));
  rig.set("a", 1);
  rig.tick();
  rig.set("a", 0);
  advance(rig);
  advance(rig);  // reached
  const double before = rig.signal("top.adaptations");
  rig.tick(5);
  EXPECT_EQ(rig.signal("top.adaptations"), before);
  EXPECT_EQ(rig.signal("wish.satisfied"), 1);
}

}  // namespace
}  // namespace ganglion
