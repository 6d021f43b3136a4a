#include "ganglion/sim/robot/trainer_ledger.h"

#include <array>
#include <vector>

namespace ganglion::sim {
namespace {

struct Column {
  std::string_view name, unit;
  double (*value)(const GoalRecord&);
};

constexpr std::array kColumns = {
    Column{"tick", "", [](const GoalRecord& g) { return static_cast<double>(g.tick); }},
    Column{"start_column", "", [](const GoalRecord& g) { return static_cast<double>(g.start.column); }},
    Column{"start_row", "", [](const GoalRecord& g) { return static_cast<double>(g.start.row); }},
    Column{"goal_column", "", [](const GoalRecord& g) { return static_cast<double>(g.goal.column); }},
    Column{"goal_row", "", [](const GoalRecord& g) { return static_cast<double>(g.goal.row); }},
    Column{"reachable", "", [](const GoalRecord& g) { return g.reachable ? 1.0 : 0.0; }},
    Column{"shortest_m", "m", [](const GoalRecord& g) { return g.shortest_m; }},
    Column{"static_shortest_m", "m", [](const GoalRecord& g) { return g.static_shortest_m; }},
    Column{"steered_shortest_m", "m", [](const GoalRecord& g) { return g.steered_shortest_m; }},
    Column{"travelled_m", "m", [](const GoalRecord& g) { return g.travelled_m; }},
    Column{"ticks", "", [](const GoalRecord& g) { return static_cast<double>(g.ticks); }},
    Column{"outcome", "", [](const GoalRecord& g) { return static_cast<double>(g.outcome); }},
    Column{"reason", "", [](const GoalRecord& g) { return static_cast<double>(g.reason); }},
};

}  // namespace

std::span<const LedgerColumn> TrainerLedger::columns_of_goals() noexcept {
  static const std::vector<LedgerColumn> kList = [] {
    std::vector<LedgerColumn> list;
    for (const Column& one : kColumns) list.push_back({std::string(one.name), std::string(one.unit)});
    return list;
  }();
  return kList;
}

double TrainerLedger::at(std::size_t row, std::size_t column) const noexcept {
  return kColumns[column].value(log_->records()[row]);
}

}  // namespace ganglion::sim
