#include "ganglion/goal/app/app.h"

#include <gtest/gtest.h>

#include <limits>

#include "ganglion/module/testing/request_bench.h"

namespace ganglion {
extern const GlobalGoalKind app_kind;
namespace {

/// The goal with two numbers on its wire.
class Trainer {
 public:
  Trainer() : ports(app_kind.descriptor, {"request:2"}), goal(AppConfig{}) { goal.bind(ports.links()); }
  std::vector<double> wish() {
    static_cast<GlobalGoal&>(goal).decide(Tick{});
    const Bid& bid = goal.wanted();
    replaces = bid.replaces;
    return {bid.values.begin(), bid.values.end()};
  }
  testing::PortBlock ports;
  AppGoal goal;
  bool replaces = false;
};

using Values = std::vector<double>;

TEST(AppGoal, AsksForWhatTheApplicationSendsAndMayReplaceIt) {
  Trainer trainer;
  trainer.ports.set("request", {3, 4});
  EXPECT_EQ(trainer.wish(), (Values{3, 4}));
  EXPECT_TRUE(trainer.replaces);
  trainer.ports.set("request", {5, 4});
  EXPECT_EQ(trainer.wish(), (Values{5, 4}));
}

TEST(AppGoal, RestsUntilOtherValuesComeOnceItsRequestIsConcluded) {
  for (const auto status : {RequestStatus::Satisfied, RequestStatus::Withdrawn}) {
    Trainer trainer;
    trainer.ports.set("request", {3, 4});
    trainer.wish();
    trainer.goal.concluded(status, {});
    EXPECT_EQ(trainer.wish(), Values{});
    trainer.ports.set("request", {3, 5});
    EXPECT_EQ(trainer.wish(), (Values{3, 5}));
    trainer.ports.set("request", {3, 4});
    EXPECT_EQ(trainer.wish(), (Values{3, 4}));
  }
}

TEST(AppGoal, AsksAgainWhatAnotherGoalCutShort) {
  Trainer trainer;
  trainer.ports.set("request", {3, 4});
  trainer.wish();
  trainer.goal.concluded(RequestStatus::Withdrawn, {ReasonCode::Preempted, 0, 1});
  EXPECT_EQ(trainer.wish(), (Values{3, 4}));
}

TEST(AppGoal, WantsNothingWhileAReadingIsMissing) {
  Trainer trainer;
  for (const double lost : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    trainer.ports.set("request", {3, lost});
    EXPECT_EQ(trainer.wish(), Values{});
  }
}

TEST(AppGoal, IsMadeFromItsParameters) { EXPECT_TRUE(app_kind.make(Parameters(app_kind.descriptor.parameters))); }

}  // namespace
}  // namespace ganglion
