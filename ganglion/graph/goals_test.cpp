#include <gtest/gtest.h>

#include <limits>

#include "ganglion/graph/testing/rig.h"

namespace ganglion {
namespace {

using testing::Rig, testing::sensations, testing::wish;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Sensations place, a, b, c, d, the goals given, and a Seeker that jumps to the goal that `goals` lists decide on.
std::string contest(std::string_view goals, std::string_view list, std::string_view settings = "") {
  return sensations({"place", "a", "b", "c", "d", "pair"}) + std::string(goals) + R"([[acting]]
id = "seeker"
kind = "Seeker"
in.place = "place"
stride = 100
tolerance = 0
command = "move"
in.goal = )" +
         std::string(list) + "\n" + std::string(settings);
}

TEST(Goals, OfAHigherClassWinHoweverStrongTheOthersAre) {
  Rig rig(contest(wish("low", "values = [1]\npriority_class = 0\nintensity = 1") +
                      wish("high", "values = [2]\npriority_class = 1\nintensity = 0.1"),
                  R"(["low", "high"])"));
  rig.tick();
  EXPECT_EQ(rig.command("move"), 2);
}

TEST(Goals, ThatAreEquallyStrongWinInTheOrderOfTheirWires) {
  const std::string two = wish("one", "values = [1]") + wish("two", "values = [2]");
  EXPECT_EQ((Rig(contest(two, R"(["one", "two"])")).controller.components()), 9);
  Rig rig(contest(two, R"(["two", "one"])"));
  rig.tick();
  EXPECT_EQ(rig.command("move"), 2);
}

TEST(Goals, ThatHeldTheRequestKeepItUnlessAChallengerIsATenthStronger) {
  Rig rig(contest(wish("holder", "values = [1]\nintensity = 0.5") + wish("rival", "values = [2]\nin.strength = \"a\""),
                  R"(["holder", "rival"])"));
  rig.tick();
  EXPECT_EQ(rig.command("move"), 1);
  rig.set("a", 0.59);
  rig.set("place", 1);  // satisfied: free again
  rig.tick();
  EXPECT_EQ(rig.command("move"), 1);
  rig.set("a", 0.61);
  rig.tick();
  EXPECT_EQ(rig.command("move"), 2);
}

TEST(Goals, DoNotTakeAPendingRequestFromTheirOwnClass) {
  Rig rig(contest(wish("holder", "values = [1]\nintensity = 0.1") + wish("rival", "values = [2]\nin.wanted = \"a\""),
                  R"(["holder", "rival"])"));
  rig.tick();
  rig.set("a", 1);
  rig.tick(3);
  EXPECT_EQ(rig.command("move"), 1);
}

const std::string kAlarm =
    wish("work", "values = [1]") + wish("alarm", "values = [2]\npriority_class = 1\nin.wanted = \"a\"");

TEST(Goals, OfAHigherClassPreemptAPendingRequest) {
  Rig rig(contest(kAlarm, R"(["work", "alarm"])"));
  rig.tick();
  EXPECT_EQ(rig.command("move"), 1);
  rig.set("a", 1);
  rig.tick();
  EXPECT_EQ(rig.command("move"), 2);
  EXPECT_EQ(rig.signal("work.withdrawn"), 1);
  EXPECT_EQ(rig.signal("work.reason"), static_cast<double>(ReasonCode::Preempted));
  rig.set("a", 0);
  rig.set("place", 2);
  rig.tick();
  EXPECT_EQ(rig.signal("alarm.satisfied"), 1);
  EXPECT_EQ(rig.command("move"), 1);  // the work goes on without a rest: it had not failed
}

TEST(Goals, OfAHigherClassWaitWherePreemptionIsSwitchedOff) {
  Rig rig(contest(kAlarm, R"(["work", "alarm"])", "preemption = false"));
  rig.tick();
  rig.set("a", 1);
  rig.tick(3);
  EXPECT_EQ(rig.command("move"), 1);
  rig.set("place", 1);
  rig.tick();
  EXPECT_EQ(rig.command("move"), 2);
}

TEST(Goals, KeepTheClassOfTheirPendingRequestWhenTheyNoLongerBid) {
  Rig rig(contest(wish("high", "values = [1]\npriority_class = 2\nin.wanted = \"a\"") +
                      wish("middle", "values = [2]\npriority_class = 1"),
                  R"(["high", "middle"])"));
  rig.set("a", 1);
  rig.tick();
  rig.set("a", 0);
  rig.tick(3);
  EXPECT_EQ(rig.command("move"), 1);
}

TEST(Goals, MayReplaceTheirOwnPendingRequestWhereTheyTrain) {
  Rig rig(contest(wish("trainer", "in.wish = \"a\"\nreplaces = true"), "\"trainer\""));
  rig.set("a", 4);
  rig.tick();
  rig.set("a", 7);
  rig.tick();
  EXPECT_EQ(rig.command("move"), 7);
  EXPECT_EQ(rig.signal("seeker.fresh"), 2);
  rig.tick();
  EXPECT_EQ(rig.signal("seeker.fresh"), 2);  // the same values are no new request
}

TEST(Goals, MayReplaceTheirOwnRequestThoughAnotherOfTheirClassIsStronger) {
  Rig rig(contest(wish("trainer", "in.wish = \"a\"\nreplaces = true\nintensity = 0.2") +
                      wish("rival", "values = [9]\nin.wanted = \"b\""),
                  R"(["trainer", "rival"])"));
  rig.set("a", 4);
  rig.tick();
  rig.set("b", 1);
  rig.set("a", 7);
  rig.tick();
  EXPECT_EQ(rig.command("move"), 7);
}

/// Gives up at once, and again whenever it is asked.
const std::string kHopeless = contest(wish("wish", "values = [9]"), "\"wish\"", "give_up_at = 0");

TEST(Goals, RestTwiceAsLongAfterEachWithdrawalUpTo256Ticks) {
  Rig rig(kHopeless);
  std::vector<int> asked_at;
  for (int tick = 1; tick <= 1100; ++tick) {
    const double before = rig.signal("seeker.fresh");
    rig.tick();
    if (rig.signal("seeker.fresh") > before) asked_at.push_back(tick);
  }
  // Asked and withdrawn at tick t, known at t + 1, kept still for 2^k ticks from there.
  EXPECT_EQ(asked_at, (std::vector<int>{1, 4, 9, 18, 35, 68, 133, 262, 519, 776, 1033}));
}

TEST(Goals, RestNoLongerOnceARequestWasSatisfied) {
  Rig rig(contest(wish("wish", "in.wish = \"a\""), "\"wish\"", "give_up_at = 5"));
  rig.set("place", 5);
  rig.set("a", 9);
  rig.tick(4);  // withdrawn at 1 and 4
  EXPECT_EQ(rig.signal("wish.withdrawn"), 1);
  rig.set("place", 1);
  rig.set("a", 1);
  rig.tick(5);  // asked at 9
  EXPECT_EQ(rig.signal("wish.withdrawn"), 2);
  rig.tick();  // satisfied at 10, asked again
  EXPECT_EQ(rig.signal("wish.satisfied"), 1);
  rig.set("place", 5);
  rig.set("a", 9);
  rig.tick();  // 11: withdraws
  const double cycles = rig.signal("seeker.cycles");
  rig.tick(2);
  EXPECT_EQ(rig.signal("seeker.cycles"), cycles);  // 12 and 13: two ticks, as after a first withdrawal
  rig.tick();
  EXPECT_EQ(rig.signal("seeker.cycles"), cycles + 1);
}

TEST(Goals, LetAnotherHaveItsTurnWhileTheyRest) {
  Rig rig(contest(wish("first", "values = [9]\nintensity = 1") + wish("second", "values = [8]\nintensity = 0.1"),
                  R"(["first", "second"])", "give_up_at = 0"));
  rig.tick();
  EXPECT_EQ(rig.signal("seeker.fresh"), 1);
  rig.tick();
  EXPECT_EQ(rig.signal("first.withdrawn"), 1);
  EXPECT_EQ(rig.signal("seeker.fresh"), 2);
  rig.tick();
  EXPECT_EQ(rig.signal("second.withdrawn"), 1);
}

TEST(Goals, ThatTrainRestAfterAWithdrawalButNotWithANewRequest) {
  Rig rig(contest(wish("trainer", "in.wish = \"a\"\nreplaces = true"), "\"trainer\"", "give_up_at = 5"));
  rig.set("place", 5);
  rig.set("a", 9);
  rig.tick(3);  // at 2 and 3 it rests
  EXPECT_EQ(rig.signal("seeker.cycles"), 1);
  rig.set("a", 8);
  rig.tick();
  EXPECT_EQ(rig.signal("seeker.cycles"), 2);
}

const std::string kOnce = contest(wish("trainer", "in.wish = \"a\"\nreplaces = true\nonce = true"), "\"trainer\"");

TEST(Goals, ThatAskOnceRestWhileWhatTheyReachedHolds) {
  Rig rig(kOnce);
  rig.set("a", 4);
  rig.tick();
  rig.set("place", 4);
  rig.tick(3);
  EXPECT_EQ(rig.signal("trainer.satisfied"), 1);
  EXPECT_EQ(rig.signal("seeker.fresh"), 1);
  EXPECT_EQ(rig.command("move"), 0);
  rig.set("place", kNaN);
  rig.tick(2);
  EXPECT_EQ(rig.signal("seeker.fresh"), 1) << "a missing reading shows nothing";
  rig.set("place", 6);  // carried off
  rig.tick();
  EXPECT_EQ(rig.signal("seeker.fresh"), 2);
  EXPECT_EQ(rig.command("move"), 4);
}

TEST(Goals, ThatAskOnceAskAgainWhenTheirWishComesBack) {
  Rig rig(kOnce);
  rig.set("a", 4);
  rig.set("place", 4);
  rig.tick(3);
  EXPECT_EQ(rig.signal("seeker.fresh"), 1);
  rig.set("a", kNaN);
  rig.tick();
  rig.set("a", 4);
  rig.tick(3);
  EXPECT_EQ(rig.signal("seeker.fresh"), 2);
  EXPECT_EQ(rig.signal("trainer.satisfied"), 2);
}

TEST(Goals, ThatAskOnceAskAgainWhenAnotherHadTheModule) {
  Rig rig(contest(wish("trainer", "in.wish = \"a\"\nreplaces = true\nonce = true") +
                      wish("rival", "values = [9]\nintensity = 0.1\nin.wanted = \"b\""),
                  R"(["trainer", "rival"])"));
  rig.set("a", 4);
  rig.set("place", 4);
  rig.tick(2);
  rig.set("b", 1);
  rig.tick();
  EXPECT_EQ(rig.command("move"), 9);
  rig.set("place", 9);
  rig.set("b", 0);
  rig.tick();
  EXPECT_EQ(rig.signal("rival.satisfied"), 1);
  EXPECT_EQ(rig.command("move"), 4);
}

TEST(Goals, ThatAskOnceAskAgainAfterAWithdrawalOnceTheyHaveRested) {
  Rig rig(contest(wish("trainer", "in.wish = \"a\"\nreplaces = true\nonce = true"), "\"trainer\"", "give_up_at = 0"));
  rig.set("a", 4);
  rig.tick(3);
  EXPECT_EQ(rig.signal("seeker.fresh"), 1);
  rig.tick();  // two ticks after it heard of it
  EXPECT_EQ(rig.signal("seeker.fresh"), 2);
}

TEST(Goals, ThatAreNotNumbersAskForNothing) {
  Rig rig(contest(wish("first", "in.strength = \"a\"\nvalues = [1]") + wish("second", "values = [2]\nintensity = 0.1"),
                  R"(["first", "second"])"));
  rig.set("a", kNaN);
  rig.tick();
  EXPECT_EQ(rig.command("move"), 2);
  Rig trainer(contest(wish("trainer", "in.wish = \"a\"\nreplaces = true"), "\"trainer\""));
  trainer.set("a", 4);
  trainer.tick();
  trainer.set("a", kNaN);
  trainer.tick();
  EXPECT_EQ(trainer.command("move"), 4);
}

TEST(Goals, OfAnotherShapeThanTheRequestAreWithdrawnAsBad) {
  for (const char* values : {"values = [1, 2]", "values = [1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17]"}) {
    Rig rig(contest(wish("wish", values), "\"wish\""));
    rig.tick();
    EXPECT_EQ(rig.signal("seeker.cycles"), 0);
    EXPECT_EQ(rig.signal("seeker.status"), 3);
    EXPECT_EQ(rig.origin("move"), CommandOrigin::Withdrawn);
    EXPECT_EQ(rig.reason("move"), ReasonCode::BadRequest);
  }
}

TEST(Goals, ServeOneModuleOnly) {
  const std::string text = contest(wish("wish", "values = [1]"), R"(["wish", "wish"])");
  EXPECT_NE(testing::problems_of(text).find("seeker: \"wish\" already asks \"seeker\""), std::string::npos)
      << testing::problems_of(text);
}

}  // namespace
}  // namespace ganglion
