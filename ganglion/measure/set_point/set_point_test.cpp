#include <gtest/gtest.h>

#include <cmath>

#include "ganglion/measure/testing/measure_bench.h"

namespace ganglion {

extern const MeasureKind set_point_kind;

namespace {

using testing::channels;
using testing::MeasureBench;

class Asked final : public Ledger {
 public:
  struct Row {
    double time_s, setpoint;
  };
  explicit Asked(std::vector<Row> rows) : list(std::move(rows)) {}
  std::span<const LedgerColumn> columns() const noexcept override { return {}; }
  std::size_t rows() const noexcept override { return list.size(); }
  double at(std::size_t row, std::size_t column) const noexcept override {
    return column == 0 ? list[row].time_s : list[row].setpoint;
  }
  bool done() const noexcept override { return false; }
  std::uint64_t changes() const noexcept override { return 0; }

  std::vector<Row> list;
};

const std::vector<TruthChannel> kTruth = channels({"command", "value"});
const std::vector<LedgerForm> kForms = {{"wanted", {{"time_s", "s", {}}, {"setpoint", "", {}}}, {}}};
MeasureScope scope() { return {.truth = kTruth, .ledgers = kForms}; }

TEST(SetPoint, IsMeasuredWhereSetPointsAreAskedAndTheValueIsKnown) {
  EXPECT_EQ(testing::figure_names(set_point_kind, scope()),
            (std::vector<std::string>{"overshoot", "settling_s", "mean_error"}));
  EXPECT_TRUE(set_point_kind.figures({.truth = kTruth}).empty());
  EXPECT_TRUE(set_point_kind.figures({.ledgers = kForms}).empty());
}

TEST(SetPoint, TakesTheOvershootAsAShareOfTheStepAndTheTimeUntilItStaysNear) {
  // A step from 1 to 3, of 2: the value goes to 3.5 (0.25 of the step) and is outside of 3 +- 0.04 up to 4 s.
  Asked asked({{0, 3}});
  MeasureBench bench(set_point_kind, scope());
  bench.show(&asked);
  bench.begin({0, 1});
  for (const double value : {2.0, 3.5, 3.03, 2.95, 3.03, 3.0}) bench.step({0, value});
  EXPECT_DOUBLE_EQ(bench.figure("overshoot"), 0.25);
  EXPECT_DOUBLE_EQ(bench.figure("settling_s"), 4);
  EXPECT_NEAR(bench.figure("mean_error"), (1 + 0.5 + 0.03 + 0.05 + 0.03 + 0) / 6, 1e-12);
}

TEST(SetPoint, TakesTheWorstOfSeveralAndKnowsNoTimeWhereOneWasNeverReached) {
  Asked asked({{0, 1}});
  MeasureBench bench(set_point_kind, scope());
  bench.show(&asked);
  bench.begin({0, 0});
  bench.step({0, 1.1});
  bench.step({0, 1});
  EXPECT_DOUBLE_EQ(bench.figure("settling_s"), 1);
  asked.list.push_back({2, 0});  // set at 2 s, down by 1: past 0 by 0.3 of the step
  for (const double value : {0.5, -0.3, 0.0}) bench.step({0, value});
  EXPECT_DOUBLE_EQ(bench.figure("overshoot"), 0.3);
  EXPECT_DOUBLE_EQ(bench.figure("settling_s"), 2);
  bench.step({0, 0.1});
  EXPECT_TRUE(std::isnan(bench.figure("settling_s"))) << "it is not at rest";
}

TEST(SetPoint, KnowsNothingOfWhatNobodyTold) {
  MeasureBench bench(set_point_kind, scope());
  bench.begin({0, 0});
  bench.step({0, 1});
  EXPECT_TRUE(std::isnan(bench.figure("overshoot")));
  EXPECT_TRUE(std::isnan(bench.figure("mean_error")));
}

}  // namespace
}  // namespace ganglion
