#include "ganglion/run/robot_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ganglion {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

double value_of(const Measures& measures, std::string_view name) {
  const auto found = std::find_if(measures.begin(), measures.end(), [&](const auto& m) { return m.first == name; });
  EXPECT_NE(found, measures.end()) << name;
  return found == measures.end() ? kInf : found->second;
}

sim::GoalRecord goal_of(double travelled_m, double static_m, double steered_m) {
  return {.static_shortest_m = static_m,
          .steered_shortest_m = steered_m,
          .travelled_m = travelled_m,
          .outcome = sim::GoalOutcome::Reached};
}

TEST(GoalMeasures, CompareTheTravelWithTheWayOfARobotThatTurnsAndOfOneThatIsSteered) {
  // Travelled 12 m, then 6 m five times; 2 m each on the spot; steered 4 m, then 3 m each.
  std::vector<sim::GoalRecord> goals(6, goal_of(6, 2, 3));
  goals[0] = goal_of(12, 2, 4);
  sim::GoalRecord missed = goal_of(100, 1, 1);
  missed.outcome = sim::GoalOutcome::Withdrawn;
  goals.push_back(missed);
  Measures measures;
  report_goals(goals, measures);
  EXPECT_NEAR(value_of(measures, "travel_ratio_first"), 36.0 / 10, 1e-12);
  EXPECT_NEAR(value_of(measures, "travel_ratio_last"), 30.0 / 10, 1e-12);
  EXPECT_NEAR(value_of(measures, "travel_ratio_late"), 18.0 / 6, 1e-12);
  EXPECT_NEAR(value_of(measures, "travel_ratio_first_steered"), 36.0 / 16, 1e-12);
  EXPECT_NEAR(value_of(measures, "travel_ratio_last_steered"), 30.0 / 15, 1e-12);
  EXPECT_NEAR(value_of(measures, "travel_ratio_late_steered"), 18.0 / 9, 1e-12);
}

TEST(GoalMeasures, LeaveOutGoalsWithoutAWayToCompareWith) {
  // Reached with a start between two cells, say: the truth knows no steered way there.
  const std::vector<sim::GoalRecord> goals = {goal_of(6, 2, 3), goal_of(5, 1, kInf)};
  Measures measures;
  report_goals(goals, measures);
  EXPECT_NEAR(value_of(measures, "travel_ratio_first"), 11.0 / 3, 1e-12);
  EXPECT_NEAR(value_of(measures, "travel_ratio_first_steered"), 2, 1e-12);
  EXPECT_TRUE(std::isnan(value_of(measures, "travel_ratio_late_steered")));
}

}  // namespace
}  // namespace ganglion
