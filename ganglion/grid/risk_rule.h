#pragma once

#include <cstddef>
#include <cstdint>

#include "ganglion/grid/cell.h"

namespace ganglion::grid {

/// How experience alters the risk of a cell. The papers give the directions of change; every number is ours.
struct RiskRule {
  double first_risk = 0.2;            ///< Of a cell found blocked; the least that a failure leaves.
  double failure_step = 0.15;         ///< A failure: r += step * (1 - r).
  double static_relief = 0.3;         ///< A crossing of a static cell: r *= relief.
  double dynamic_relief = 0.7;        ///< A crossing of a dynamic cell: r *= relief.
  std::uint32_t inhibition_base = 2;  ///< After a failure no attempt for base + floor(span * r) ticks.
  std::uint32_t inhibition_span = 18;
};

/// Risk stays below 1: what has always been blocked may still be tried again, at a price.
inline constexpr double kMaxRisk = 1 - 1e-6;

/// An attempt to enter the cell failed: an unexplored one is occupied and static with the first risk; one crossed
/// before turns occupied and dynamic; an occupied one keeps its nature.
void note_failure(Cell& cell, const RiskRule& rule) noexcept;
/// The cell was entered: it is empty and dynamic; its risk falls much if it was static, a little if dynamic; a cell
/// unexplored until now has none.
void note_crossing(Cell& cell, const RiskRule& rule) noexcept;
/// Books the cost of entering the cell, for the length of one straight step, on its running mean.
void note_cost(Cell& cell, double cost_j) noexcept;
/// What a failed diagonal step leaves on each of the unexplored cells that may have blocked it, in (0, 1): ours.
double suspicion(std::size_t suspects) noexcept;
/// How long a cell of this risk stays closed after a failure [ticks].
std::uint32_t inhibition_ticks(double risk, const RiskRule& rule) noexcept;

}  // namespace ganglion::grid
