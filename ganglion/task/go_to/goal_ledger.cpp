#include "ganglion/task/go_to/goal_ledger.h"

#include <array>

namespace ganglion {
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
    Column{"x_m", "m", [](const GoalRecord& g) { return g.centre.x; }},
    Column{"y_m", "m", [](const GoalRecord& g) { return g.centre.y; }},
};

/// Of the values of `outcome`, in their order.
constexpr std::array kRoles = {Role::Goal, Role::Reached, Role::GivenUp, Role::GivenUp, Role::Past};
constexpr std::array kOutcomes = {
    Text{"set", "fijado"},           Text{"reached", "alcanzado"},
    Text{"withdrawn", "retirado"},   Text{"timed_out", "fuera de tiempo"},
    Text{"replaced", "reemplazado"},
};

const std::vector<LedgerColumn>& list() {
  static const std::vector<LedgerColumn> kList = [] {
    std::vector<LedgerColumn> columns;
    for (const Column& one : kColumns) {
      columns.push_back({std::string(one.name), std::string(one.unit), {}, {}});
      if (one.name != "outcome") continue;
      for (const Text& word : kOutcomes) columns.back().words.push_back(say({"{}", "{}"}, word));
      columns.back().roles.assign(kRoles.begin(), kRoles.end());
    }
    return columns;
  }();
  return kList;
}

}  // namespace

LedgerForm GoalLedger::form(double cell_m) {
  constexpr Text kLine{"goal {#} at cell {goal_column}, {goal_row}: {outcome}",
                       "objetivo {#} en la celda {goal_column}, {goal_row}: {outcome}"};
  return {"", list(), say({"{}", "{}"}, kLine), {"Goals", "Objetivos"}, cell_m};
}

std::span<const LedgerColumn> GoalLedger::columns() const noexcept { return list(); }

double GoalLedger::at(std::size_t row, std::size_t column) const noexcept {
  return kColumns[column].value(records_[row]);
}

}  // namespace ganglion
