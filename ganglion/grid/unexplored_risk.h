#pragma once

#include "ganglion/grid/risk_map.h"

namespace ganglion::grid {

/// What to expect of ground never tried, from what is known around it. Obstacles are longer than one cell: beside an
/// occupied cell the next one is often occupied too, and between two of them nearly always. Ours throughout; the papers
/// take unexplored ground for free.
struct UnexploredRule {
  bool inferred = true;       ///< False: as in the papers, free but for suspicion.
  double weight = 3;          ///< Cells of detour worth a certainty of 1/e; less makes for curiosity, more for habit.
  double open_risk = 0.1;     ///< Of a cell with nothing known to stand near it.
  double beside_risk = 0.3;   ///< Next to an occupied cell, or in line with at least kWallCells of them.
  double between_risk = 0.8;  ///< Between two occupied cells.
  int wall_reach_cells = 12;  ///< How far a line of occupied cells is looked for.
};

/// Occupied cells in one line, nothing empty between them, that pass for a wall which may go on.
inline constexpr int kWallCells = 3;

/// Belief that entering an unexplored cell fails, in [0, 1): what its row and its column suggest, and what failed
/// diagonal steps past it have left.
double unexplored_risk(const RiskMap& map, CellIndex cell, const UnexploredRule& rule) noexcept;

}  // namespace ganglion::grid
