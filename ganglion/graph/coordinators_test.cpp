#include <gtest/gtest.h>

#include "ganglion/graph/testing/rig.h"

namespace ganglion {
namespace {

using testing::first, testing::puppet, testing::Rig, testing::seeker, testing::sensations, testing::wish;

/// Two puppets compete for `move`: `a` and `b` say whether they act, `c` and `d` what they command.
std::string competition(std::string_view settings = "") {
  return sensations({"a", "b", "c", "d"}) + first("arbiter", R"("one", "two")", "command = \"move\"") +
         std::string(settings) + "\n" + puppet("one", "a", "c") + puppet("two", "b", "d");
}

Rig both_acting(std::string_view settings = "") {
  Rig rig(competition(settings));
  rig.set("a", 1);
  rig.set("b", 1);
  rig.set("c", 3);
  rig.set("d", 4);
  return rig;
}

TEST(Coordinator, ShowsWhoDrivesWhoWantedToAndWhoWasSuppressed) {
  Rig rig = both_acting();
  rig.tick();
  EXPECT_EQ(rig.command("move"), 3);
  EXPECT_EQ(rig.signal("arbiter.share.one"), 1);
  EXPECT_EQ(rig.signal("arbiter.share.two"), 0);
  EXPECT_EQ(rig.signal("arbiter.wanted.two"), 1);
  EXPECT_EQ(rig.signal("arbiter.suppressed.two"), 1);
  EXPECT_EQ(rig.signal("arbiter.suppressed.one"), 0);
  EXPECT_EQ(rig.signal("two.active"), 1);
  EXPECT_EQ(rig.signal("arbiter.command.x"), 3);
}

TEST(Coordinator, ChargesTheFrameOnlyToTheCandidateCarriedOut) {
  Rig rig = both_acting();
  rig.tick();
  rig.cost = 2;
  rig.tick();
  EXPECT_EQ(rig.signal("one.adaptations"), 1);
  EXPECT_EQ(rig.signal("one.charged"), 2);
  EXPECT_EQ(rig.signal("one.granted"), 1);
  EXPECT_EQ(rig.signal("two.adaptations"), 0);
  EXPECT_EQ(rig.signal("two.granted"), 0);
  rig.set("a", 0);
  rig.tick();  // now two drives; what this frame cost was still one's
  EXPECT_EQ(rig.signal("two.adaptations"), 0);
  rig.tick();
  EXPECT_EQ(rig.signal("two.adaptations"), 1);
}

TEST(Coordinator, GivesNoShareToWhatDidNotAct) {
  Rig rig = both_acting("generous = true");
  rig.set("a", 0);
  rig.cost = 2;
  rig.tick(2);
  EXPECT_EQ(rig.command("move"), 4);
  EXPECT_EQ(rig.signal("arbiter.share.one"), 0);  // whatever the kind claims
  EXPECT_EQ(rig.signal("one.adaptations"), 0);
  EXPECT_EQ(rig.signal("one.granted"), 0);
  EXPECT_EQ(rig.signal("two.adaptations"), 1);
}

TEST(Coordinator, IsSafeWhereNobodyActs) {
  Rig rig(competition());
  rig.set("a", 2);  // withdraws: for a coordinator the same as inactive
  rig.tick();
  EXPECT_EQ(rig.origin("move"), CommandOrigin::Safe);
  EXPECT_EQ(rig.command("move"), 0);
}

TEST(Coordinator, GrantsThroughCoordinatorsOfCoordinators) {
  Rig rig(sensations({"a", "b", "c", "d"}) + first("outer", R"("alarm", "inner")", "command = \"move\"") +
          first("inner", R"("one", "two")") + puppet("alarm", "b", "d") + puppet("one", "a", "c") +
          puppet("two", "a", "d"));
  rig.set("a", 1);
  rig.set("c", 3);
  rig.cost = 1;
  rig.tick(2);
  EXPECT_EQ(rig.command("move"), 3);
  EXPECT_EQ(rig.signal("one.adaptations"), 1);
  EXPECT_EQ(rig.signal("two.adaptations"), 0);
  EXPECT_EQ(rig.signal("inner.granted"), 1);
  rig.set("b", 1);
  rig.tick(2);  // the second of them is charged to the alarm
  EXPECT_EQ(rig.signal("one.adaptations"), 2);
  EXPECT_EQ(rig.signal("alarm.adaptations"), 1);
  EXPECT_EQ(rig.signal("inner.granted"), 0);
  EXPECT_EQ(rig.signal("one.granted"), 0);
}

/// The winner's command is a request to a Seeker that walks 1 m a tick on `move`.
std::string request_by_arbiter(std::string_view settings = "") {
  return sensations({"a", "b", "c", "d", "place"}) +
         seeker("lower", "arbiter", "tolerance = 0\nrelative = true\ncommand = \"move\"") + std::string(settings) +
         "\n" + first("arbiter", R"("one", "two")") + puppet("one", "a", "c") + puppet("two", "b", "d");
}

TEST(Coordinator, MayMakeItsCommandARequest) {
  Rig rig(request_by_arbiter());
  rig.set("a", 1);
  rig.set("c", 3);
  rig.tick();
  EXPECT_EQ(rig.command("move"), 1);
  rig.set("place", 1);
  rig.tick();
  EXPECT_EQ(rig.signal("lower.fresh"), 1);  // the same command is the same request
  rig.set("c", -3);
  rig.tick();
  EXPECT_EQ(rig.signal("lower.fresh"), 2);
  EXPECT_EQ(rig.command("move"), -1);
  rig.set("a", 0);
  rig.tick();
  EXPECT_EQ(rig.signal("lower.status"), 0);
  EXPECT_EQ(rig.origin("move"), CommandOrigin::Safe);
}

TEST(Coordinator, OfRequestsChargesItsCandidatesWhatTheModuleBelowPays) {
  Rig rig(request_by_arbiter("[[sensing]]\nid = \"unused\"\nkind = \"Gain\"\nin.in = \"a\""));
  rig.set("a", 1);
  rig.set("b", 1);
  rig.set("c", 3);
  rig.set("d", 9);
  rig.tick();
  rig.cost = 4;
  rig.tick();
  EXPECT_EQ(rig.signal("lower.charged"), 4);
  EXPECT_EQ(rig.signal("one.charged"), 4);
  EXPECT_EQ(rig.signal("two.adaptations"), 0);
}

TEST(Coordinator, OfRequestsChargesNothingWhileTheModuleBelowIsOverruled) {
  // The seeker competes with an alarm for `move`, and what the alarm costs is nobody else's.
  Rig rig(sensations({"a", "b", "c", "d", "place"}) + first("top", R"("one")") + puppet("one", "a", "c") +
          seeker("lower", "top", "tolerance = 0") + puppet("alarm", "b", "d") +
          first("bottom", R"("alarm", "lower")", "command = \"move\""));
  rig.set("a", 1);
  rig.set("b", 1);
  rig.set("c", 3);
  rig.cost = 4;
  rig.tick(3);
  EXPECT_EQ(rig.signal("alarm.adaptations"), 2);
  EXPECT_EQ(rig.signal("lower.adaptations"), 0);
  EXPECT_EQ(rig.signal("one.adaptations"), 0);
}

TEST(Coordinator, OfRequestsTellsTheCandidateWhatBecameOfIt) {
  // The candidate is a Seeker itself, so that it shows what it is told.
  Rig rig(sensations({"place"}) + wish("wish", "values = [9]") + seeker("upper", "wish", "tolerance = 0") +
          first("arbiter", "\"upper\"") +
          seeker("lower", "arbiter", "tolerance = 0\ngive_up_at = 2\nrelative = true\ncommand = \"move\""));
  rig.tick();
  rig.set("place", 1);
  rig.tick();
  EXPECT_EQ(rig.signal("upper.outcome"), 2);  // satisfied
  EXPECT_EQ(rig.signal("upper.told"), 0);
  rig.set("place", 2);
  rig.tick();
  EXPECT_EQ(rig.origin("move"), CommandOrigin::Withdrawn);
  rig.tick();
  EXPECT_EQ(rig.signal("upper.outcome"), 3);
  EXPECT_EQ(rig.signal("upper.told"), static_cast<double>(ReasonCode::Trapped));
}

/// An acting module that commands two values.
std::string walker() {
  return sensations({"cell", "place"}) + wish("wish", "values = [1, 2]") + R"([[acting]]
id = "walker"
kind = "Walker"
in.goal = "wish"
in.place = "cell"
)";
}

TEST(Coordinator, RefusesCandidatesOfAnotherSizeThanItsCommandNeeds) {
  EXPECT_EQ(testing::problems_of(walker() + R"([[coordinator]]
id = "arbiter"
kind = "First"
in.commands = ["walker"]
command = "move"
)"),
            "controller.toml:13:6: walker: commands 2 values, but \"move\" takes 1\n");
}

TEST(Request, IsRefusedWhereTheModuleAboveCommandsAnotherSize) {
  EXPECT_EQ(testing::problems_of(walker() + R"([[acting]]
id = "seeker"
kind = "Seeker"
in.goal = "walker"
in.place = "place"
command = "move"
)"),
            "controller.toml:13:6: walker: commands 2 values, but requests to \"seeker\" have 1\n");
}

}  // namespace
}  // namespace ganglion
