#include "ganglion/task/hold/hold.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion {
namespace {

double asked(Hold& hold, double time_s) {
  const Outlook now{.tick = 0, .time_s = time_s, .truth = {}};
  hold.judge(now);
  std::array<double, 2> values{};
  hold.tell(now, values);
  return values[0];
}

TEST(Hold, AsksForEachInTurnAndKeepsTheLast) {
  Hold hold({.values = {1, 5, 2}, .each_s = 0.5});
  ASSERT_TRUE(hold.begin({}, Draws({}, 0)));
  EXPECT_EQ(asked(hold, 0.4), 1);
  EXPECT_EQ(asked(hold, 0.1 + 0.1 + 0.1 + 0.1 + 0.1), 5) << "sums of steps are not exact";
  EXPECT_FALSE(hold.ledger()->done());
  EXPECT_EQ(asked(hold, 1.0), 2);
  EXPECT_TRUE(hold.ledger()->done());
  EXPECT_EQ(asked(hold, 100), 2);
  EXPECT_EQ(hold.ledger()->rows(), 3u);
}

TEST(Hold, BeginsAgainWhereItIsToldTo) {
  Hold hold({.values = {1, 5}, .each_s = 1, .again = true});
  ASSERT_TRUE(hold.begin({}, Draws({}, 0)));
  EXPECT_EQ(asked(hold, 1), 5);
  EXPECT_EQ(asked(hold, 2), 1);
  EXPECT_EQ(asked(hold, 3), 5);
  EXPECT_FALSE(hold.ledger()->done());
  ASSERT_TRUE(hold.begin({}, Draws({}, 0)));
  EXPECT_EQ(hold.ledger()->rows(), 1u) << "an episode begins";
}

TEST(Hold, RefusesToAskForNothing) {
  HoldConfig nothing{.values = {}};
  EXPECT_EQ(Hold::judge(nothing).error().what.en, "values has 0 set-points, must have 1 to 1000");
}

}  // namespace
}  // namespace ganglion
