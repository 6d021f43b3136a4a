#include "ganglion/run/robot_measures.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "ganglion/base/file.h"
#include "ganglion/run/run.h"

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

/// Nimrod for 20 s on a field that rises 30 deg to the east, heading uphill, its body changed.
Measures on_a_hillside(const char* slope_deg, const char* limit) {
  namespace fs = std::filesystem;
  const fs::path world = fs::temp_directory_path() / fmt::format("ganglion_hillside_{}.toml", ::getpid());
  EXPECT_TRUE(write_file(world, fmt::format("format = 1\n[[floor]]\nx_m = 0\ny_m = 0\nlength_m = 40\nwidth_m = 40\n"
                                            "slope_deg = {}\n",
                                            slope_deg)));
  Problems problems;
  const auto prepared = prepare(fs::path(GANGLION_SOURCE_DIR) / "experiments/nimrod",
                                {{"run.duration_s", "20"},
                                 {"run.free_ground", "false"},
                                 {"application.world", world.string()},
                                 {"application.spawn", "{pose = [0, 0, 0]}"},
                                 {std::string("application.robot.body.") + limit, "20"}},
                                problems);
  EXPECT_TRUE(prepared) << problems.text();
  const auto result = run(*prepared, {});
  EXPECT_TRUE(result) << result.error().text();
  fs::remove(world);
  return result->measures;
}

TEST(RobotMeasures, TellForHowLongTheRobotLayOnItsSide) {
  const Measures measures = on_a_hillside("30", "tip_deg");
  EXPECT_NEAR(value_of(measures, "tipped_s"), 20, 1e-9);  // from the first moment
  EXPECT_EQ(value_of(measures, "stalled_s"), 0);
  EXPECT_EQ(value_of(measures, "travelled_m"), 0);
}

TEST(RobotMeasures, TellForHowLongASlopeWasTooSteep) {
  const Measures measures = on_a_hillside("30", "climb_deg");
  EXPECT_GT(value_of(measures, "stalled_s"), 15);  // whenever it does not turn
  EXPECT_LE(value_of(measures, "stalled_s"), 20 + 1e-9);
  EXPECT_EQ(value_of(measures, "tipped_s"), 0);
  EXPECT_NEAR(value_of(measures, "progress_m"), 0, 1e-9);
  EXPECT_EQ(value_of(on_a_hillside("19", "climb_deg"), "stalled_s"), 0);
}

TEST(RobotMeasures, LeaveOutSlopesWhereThereAreNone) {
  const Measures level = on_a_hillside("0", "tip_deg");
  EXPECT_TRUE(std::ranges::none_of(level, [](const auto& one) { return one.first == "tipped_s"; }));
}

}  // namespace
}  // namespace ganglion
