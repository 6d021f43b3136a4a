#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ganglion/kinds/kinds.h"
#include "ganglion/measure/testing/measure_bench.h"
#include "ganglion/sim/robot/truth_channels.h"

namespace ganglion {
namespace {

/// A test for each kind there is, named after it: whoever adds one sees it walked.
class OfMeasures : public ::testing::TestWithParam<const MeasureKind*> {};

TEST_P(OfMeasures, TellsAllItsFiguresWhateverTheTruth) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  constexpr std::array kTruths = {0.5, std::nan(""), kInf, -kInf, 1e300, -2.0, 0.0};
  constexpr double kUntold = -12345;
  const testing::WalledTerrain ground(5, true);
  const auto truth = sim::truth_channels();
  const std::vector<MeasuredSignal> signals = {{"arbiter.share.escape", "", Meaning::None}};
  std::vector<LedgerForm> forms;  // of every kind of task, as if nobody knew what they keep
  for (const TaskKind* kind : task_kinds())
    forms.push_back((*kind->make(Parameters(kind->descriptor.parameters)))->form());
  const std::vector<const Ledger*> ledgers(forms.size(), nullptr);
  for (const MeasureScope& scope :
       {MeasureScope{},
        MeasureScope{.truth = truth, .signals = signals, .ledgers = forms, .terrain = &ground, .radius_m = 0.1}}) {
    const std::vector<Figure> figures = GetParam()->figures(scope);
    if (figures.empty()) continue;
    const auto measure = GetParam()->make(scope);
    std::vector<double> row(scope.truth.size(), 0.0), told(scope.signals.size(), 0.0);
    measure->begin({.time_s = 0, .step_s = 0.1, .truth = row, .signals = told, .ledgers = ledgers}, nullptr);
    for (std::size_t tick = 1; tick <= 70; ++tick) {
      std::fill(row.begin(), row.end(), kTruths[tick % kTruths.size()]);
      measure->update({.time_s = 0.1 * static_cast<double>(tick),
                       .step_s = 0.1,
                       .truth = row,
                       .signals = told,
                       .ledgers = ledgers});
    }
    std::vector<double> values(figures.size(), kUntold);
    measure->report(values);
    for (std::size_t i = 0; i < figures.size(); ++i) EXPECT_NE(values[i], kUntold) << figures[i].name;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, OfMeasures, ::testing::ValuesIn(measure_kinds()),
                         [](const auto& one) { return std::string(one.param->descriptor.name); });

}  // namespace
}  // namespace ganglion
