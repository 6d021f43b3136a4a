#include "ganglion/grid/unexplored_risk.h"

#include <algorithm>

namespace ganglion::grid {
namespace {

/// Occupied cells seen from a cell along one direction, as far as the first empty one.
struct Sight {
  int occupied = 0;
  bool adjacent = false;  ///< The first of them is the neighbour.
};

Sight look(const RiskMap& map, CellIndex from, int direction, int reach_cells) noexcept {
  Sight sight;
  CellIndex at = from;
  for (int distance = 1; distance <= reach_cells; ++distance) {
    at = neighbour(at, direction);
    const Cell* cell = map.find(at);
    if (cell == nullptr) break;  // beyond the tiles nothing was ever met
    if (cell->label == Label::Empty) break;
    if (cell->label != Label::Occupied) continue;
    ++sight.occupied;
    sight.adjacent = sight.adjacent || distance == 1;
  }
  return sight;
}

double risk_along(const RiskMap& map, CellIndex cell, int direction, const UnexploredRule& rule) noexcept {
  const Sight ahead = look(map, cell, direction, rule.wall_reach_cells);
  const Sight behind = look(map, cell, turned(direction, 4), rule.wall_reach_cells);
  if (ahead.adjacent && behind.adjacent) return rule.between_risk;
  const bool in_line = ahead.occupied + behind.occupied >= kWallCells;
  return ahead.adjacent || behind.adjacent || in_line ? rule.beside_risk : rule.open_risk;
}

}  // namespace

double unexplored_risk(const RiskMap& map, CellIndex cell, const UnexploredRule& rule) noexcept {
  const Cell* known = map.find(cell);
  if (known == nullptr) return rule.inferred ? rule.open_risk : 0;
  if (!rule.inferred) return known->risk;
  constexpr int kAlongRow = 0, kAlongColumn = 2;
  return std::max({known->risk, risk_along(map, cell, kAlongRow, rule), risk_along(map, cell, kAlongColumn, rule)});
}

}  // namespace ganglion::grid
