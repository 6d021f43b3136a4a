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
  Trainer() : ports(app_kind.descriptor, {"request:2"}), goal(AppConfig{0.75}) { goal.bind(ports.links()); }
  std::vector<double> wish() {
    static_cast<GlobalGoal&>(goal).decide(Tick{});
    return {goal.wanted().values.begin(), goal.wanted().values.end()};
  }
  testing::PortBlock ports;
  AppGoal goal;
};

using Values = std::vector<double>;

TEST(AppGoal, AsksForWhatTheApplicationSendsOnceAndMayReplaceIt) {
  Trainer trainer;
  trainer.ports.set("request", {3, 4});
  EXPECT_EQ(trainer.wish(), (Values{3, 4}));
  EXPECT_TRUE(trainer.goal.wanted().replaces);
  EXPECT_TRUE(trainer.goal.wanted().once);
  EXPECT_EQ(trainer.goal.wanted().intensity, 0.75);
  trainer.ports.set("request", {5, 4});
  EXPECT_EQ(trainer.wish(), (Values{5, 4}));
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
