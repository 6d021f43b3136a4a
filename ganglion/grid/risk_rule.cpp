#include "ganglion/grid/risk_rule.h"

#include <algorithm>
#include <cmath>

namespace ganglion::grid {

void note_failure(Cell& cell, const RiskRule& rule) noexcept {
  if (cell.label == Label::Unexplored) {
    cell.label = Label::Occupied;
    cell.nature = Nature::Static;
    cell.risk = rule.first_risk;
    return;
  }
  if (cell.label == Label::Empty) cell.nature = Nature::Dynamic;
  cell.label = Label::Occupied;
  cell.risk = std::clamp(cell.risk + rule.failure_step * (1 - cell.risk), rule.first_risk, kMaxRisk);
}

void note_crossing(Cell& cell, const RiskRule& rule) noexcept {
  if (cell.label == Label::Unexplored) {
    cell.risk = 0;
  } else {
    cell.risk *= cell.nature == Nature::Static ? rule.static_relief : rule.dynamic_relief;
  }
  cell.label = Label::Empty;
  cell.nature = Nature::Dynamic;
  cell.inhibited_until = 0;
  cell.strain = 0;
}

void note_cost(Cell& cell, double cost_j) noexcept {
  constexpr std::uint32_t kMemory = 1000;  // beyond that the mean follows changes instead of freezing
  cell.costed = std::min(cell.costed + 1, kMemory);
  cell.cost_j += (cost_j - cell.cost_j) / cell.costed;
}

double suspicion(std::size_t suspects) noexcept {
  constexpr double kBlocked = 0.9;  // that it is one of them at all: the robot may have slipped
  return kBlocked / static_cast<double>(suspects);
}

std::uint32_t inhibition_ticks(double risk, const RiskRule& rule) noexcept {
  return rule.inhibition_base + static_cast<std::uint32_t>(std::floor(rule.inhibition_span * risk));
}

}  // namespace ganglion::grid
