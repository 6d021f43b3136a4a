#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ganglion/measure/testing/measure_bench.h"

namespace ganglion {

extern const MeasureKind goals_kind;

namespace {

using testing::figure_names;
using testing::MeasureBench;
using Names = std::vector<std::string>;

constexpr double kInf = std::numeric_limits<double>::infinity();

enum Outcome { kOpen, kReached, kWithdrawn, kTimedOut, kReplaced };

struct Goal {
  double travelled_m = 0, static_m = kInf, steered_m = kInf;
  Outcome outcome = kReached;
  bool reachable = true;
};

/// What a task keeps, in an order of its own and with more than is asked for.
class Kept final : public Ledger {
 public:
  explicit Kept(std::vector<Goal> list = {}) : goals(std::move(list)) {}
  static const std::vector<LedgerColumn>& kept_columns() {
    static const std::vector<LedgerColumn> kList = {{"outcome", ""},
                                                    {"tick", ""},
                                                    {"steered_shortest_m", "m"},
                                                    {"travelled_m", "m"},
                                                    {"static_shortest_m", "m"},
                                                    {"reachable", ""},
                                                    {"shortest_m", "m"}};
    return kList;
  }
  std::span<const LedgerColumn> columns() const noexcept override { return kept_columns(); }
  std::size_t rows() const noexcept override { return goals.size(); }
  double at(std::size_t row, std::size_t column) const noexcept override {
    const Goal& goal = goals[row];
    const std::array values = {static_cast<double>(goal.outcome), 77.0, goal.steered_m, goal.travelled_m, goal.static_m,
                               goal.reachable ? 1.0 : 0.0,        0.001};
    return values[column];
  }
  bool done() const noexcept override { return finished; }
  std::uint64_t changes() const noexcept override { return 0; }

  std::vector<Goal> goals;
  bool finished = false;
};

MeasureScope trained() {
  static const std::vector<LedgerForm> kForms = {{"trainer", Kept::kept_columns(), {}}};
  return {.ledgers = kForms};
}

/// At the end of a run that left these goals.
MeasureBench after(const Kept& kept) {
  MeasureBench bench(goals_kind, trained());
  bench.show(&kept);
  bench.step({});
  return bench;
}

TEST(GoalMeasures, CompareTheTravelWithTheWayOfARobotThatTurnsAndOfOneThatIsSteered) {
  // Travelled 12 m, then 6 m five times; 2 m each on the spot; steered 4 m, then 3 m each.
  Kept kept(std::vector<Goal>(6, {6, 2, 3}));
  kept.goals[0] = {12, 2, 4};
  kept.goals.push_back({100, 1, 1, kWithdrawn});
  const MeasureBench bench = after(kept);
  EXPECT_NEAR(bench.figure("travel_ratio_first"), 36.0 / 10, 1e-12);
  EXPECT_NEAR(bench.figure("travel_ratio_last"), 30.0 / 10, 1e-12);
  EXPECT_NEAR(bench.figure("travel_ratio_late"), 18.0 / 6, 1e-12);
  EXPECT_NEAR(bench.figure("travel_ratio_first_steered"), 36.0 / 16, 1e-12);
  EXPECT_NEAR(bench.figure("travel_ratio_last_steered"), 30.0 / 15, 1e-12);
  EXPECT_NEAR(bench.figure("travel_ratio_late_steered"), 18.0 / 9, 1e-12);
}

TEST(GoalMeasures, LeaveOutGoalsWithoutAWayToCompareWith) {
  // Reached with a start between two cells, say: the truth knows no steered way there.
  const Kept kept({{6, 2, 3}, {5, 1, kInf}});
  const MeasureBench bench = after(kept);
  EXPECT_NEAR(bench.figure("travel_ratio_first"), 11.0 / 3, 1e-12);
  EXPECT_NEAR(bench.figure("travel_ratio_first_steered"), 2, 1e-12);
  EXPECT_TRUE(std::isnan(bench.figure("travel_ratio_late_steered")));
}

TEST(GoalMeasures, CompareTheLaterHalfWithTheMiddleOneInIt) {
  const Kept kept({{7, 1, 1}, {4, 1, 1}, {2, 1, 1}});
  const MeasureBench bench = after(kept);
  EXPECT_NEAR(bench.figure("travel_ratio_late"), 6.0 / 2, 1e-12);
  EXPECT_NEAR(bench.figure("travel_ratio_first"), 13.0 / 3, 1e-12) << "fewer than five: all";
  EXPECT_NEAR(bench.figure("travel_ratio_last"), 13.0 / 3, 1e-12);
}

TEST(GoalMeasures, CountWhatBecameOfThem) {
  const Kept kept({{1, 1, 1, kReached},
                   {1, 1, 1, kWithdrawn},
                   {1, kInf, kInf, kWithdrawn, false},
                   {1, 1, 1, kTimedOut},
                   {1, 1, 1, kReplaced},
                   {1, kInf, kInf, kTimedOut, false},
                   {1, 1, 1, kOpen},
                   {1, 1, 1, kReplaced}});
  const MeasureBench bench = after(kept);
  EXPECT_EQ(bench.figure("goals_set"), 8);
  EXPECT_EQ(bench.figure("goals_reached"), 1);
  EXPECT_EQ(bench.figure("goals_withdrawn"), 2);
  EXPECT_EQ(bench.figure("goals_timed_out"), 2);
  EXPECT_EQ(bench.figure("goals_unreachable"), 2);
  EXPECT_EQ(bench.figure("goals_missed"), 3) << "the second, fourth and seventh: within reach, and nobody's wish";
  EXPECT_EQ(bench.figure("goals_replaced"), 2);
  EXPECT_EQ(bench.figure("unreachable_withdrawn"), 1);
}

TEST(GoalMeasures, FollowTheLedgerAsItGrows) {
  Kept kept;
  MeasureBench bench(goals_kind, trained());
  bench.show(&kept);
  bench.begin({});
  EXPECT_EQ(bench.figure("goals_set"), 0);
  EXPECT_EQ(bench.figure("goals_done"), 0);
  EXPECT_TRUE(std::isnan(bench.figure("travel_ratio_first")));
  kept.goals.push_back({3, 2, 2, kOpen});
  bench.step({});
  EXPECT_EQ(bench.figure("goals_set"), 1);
  EXPECT_EQ(bench.figure("goals_reached"), 0);
  EXPECT_EQ(bench.figure("goals_missed"), 1) << "so far";
  EXPECT_TRUE(std::isnan(bench.figure("travel_ratio_first")));
  kept.goals[0] = {5, 2, 2, kReached};
  bench.step({});
  EXPECT_EQ(bench.figure("goals_reached"), 1);
  EXPECT_EQ(bench.figure("goals_missed"), 0);
  EXPECT_EQ(bench.figure("travel_ratio_first"), 2.5);
  EXPECT_EQ(bench.figure("goals_done"), 0);
  kept.finished = true;
  bench.step({});
  EXPECT_EQ(bench.figure("goals_done"), 1);
}

TEST(GoalMeasures, LeaveOutReplacedOnesWhereNobodyReplacedAny) {
  const Kept none({{1, 1, 1, kReached}}), one({{1, 1, 1, kReplaced}});
  EXPECT_TRUE(std::isnan(after(none).figure("goals_replaced")));
  EXPECT_EQ(after(one).figure("goals_replaced"), 1);
  for (const Figure& figure : goals_kind.figures(trained())) {
    EXPECT_EQ(figure.sparse, figure.name == "goals_replaced") << figure.name;
    EXPECT_EQ(figure.listed, figure.name != "goals_done") << figure.name;
  }
}

TEST(GoalMeasures, AreInTheOrderOfResults) {
  EXPECT_EQ(
      figure_names(goals_kind, trained()),
      (Names{"goals_set", "goals_reached", "goals_withdrawn", "goals_timed_out", "goals_unreachable", "goals_missed",
             "goals_replaced", "unreachable_withdrawn", "travel_ratio_first", "travel_ratio_last", "travel_ratio_late",
             "travel_ratio_first_steered", "travel_ratio_last_steered", "travel_ratio_late_steered", "goals_done"}));
}

TEST(GoalMeasures, AreNoneWithoutATrainerOrWhereItKeepsTooLittle) {
  EXPECT_EQ(figure_names(goals_kind, {}), Names{});
  for (const std::string_view needed :
       {"reachable", "outcome", "travelled_m", "static_shortest_m", "steered_shortest_m"}) {
    std::vector<LedgerColumn> fewer = Kept::kept_columns();
    std::erase_if(fewer, [&](const LedgerColumn& column) { return column.name == needed; });
    const std::vector<LedgerForm> forms = {{"trainer", fewer, {}}};
    EXPECT_EQ(figure_names(goals_kind, {.ledgers = forms}), Names{}) << needed;
  }
}

TEST(GoalMeasures, AreNotKnownWhereTheLedgerIsNotAtHand) {
  MeasureBench bench(goals_kind, trained());
  bench.begin({});
  bench.step({});
  for (const std::string& name : figure_names(goals_kind, trained())) {
    EXPECT_TRUE(std::isnan(bench.figure(name))) << name;
  }
}

}  // namespace
}  // namespace ganglion
