#pragma once

#include <cstdint>

#include "ganglion/grid/risk_map.h"
#include "ganglion/grid/unexplored_risk.h"

namespace ganglion::grid {

/// Costs of routes are whole numbers, so that equal routes are equal to the bit: 13860 units are the length of one
/// cell, 19601 that of a diagonal (19601 / 13860 = sqrt 2 + 1.8e-9, a convergent of its continued fraction).
inline constexpr std::uint32_t kStraightUnits = 13860;
inline constexpr std::uint32_t kDiagonalUnits = 19601;
inline constexpr std::uint32_t kNever = 0xFFFFFFFF;

/// What a route may go over.
enum class Query : std::uint8_t {
  /// Cells unexplored, or empty with a risk of at most secure_risk. Costs: length - weight ln(1 - r) where unexplored.
  Secure,
  /// Every cell that may be tried at this tick, occupied ones included. Costs: length - weight ln(1 - r).
  Feasible,
};

/// Ours throughout, but for the two queries.
struct PriceRule {
  double secure_risk = 0.2;
  double risk_weight = 4;          ///< Cells of detour that are worth a certainty of 1/e.
  bool secure_weighs_cost = true;  ///< Learned costs count in secure routes as well, not in feasible ones only.
  UnexploredRule unexplored{};
};

/// What it takes to enter a cell, in units. Not to be entered: straight = 0.
struct Price {
  std::uint32_t straight = 0;
  std::uint32_t diagonal = 0;
  std::uint32_t risk = 0;             ///< On top, for entering it.
  std::uint32_t side = 0;             ///< On top, for passing its corner in a diagonal step.
  std::uint8_t closed_diagonals = 0;  ///< Bit k / 2: not to be left in direction k.

  bool lets_leave(int direction) const noexcept { return (closed_diagonals >> (direction / 2) & 1) == 0; }
};

/// Prices cells after the map. Learned costs enter as a factor on the length, at least 1: the mean of the cell over the
/// mean of all crossings. Beyond the tiles the ground counts as unexplored, until the map is full: then it is closed.
class Pricing {
 public:
  Pricing(const RiskMap& map, const PriceRule& rule, Query query, std::uint32_t now) noexcept
      : map_(&map), rule_(rule), query_(query), now_(now) {}
  Price operator()(CellIndex cell) const noexcept;
  bool may_enter(CellIndex cell) const noexcept { return (*this)(cell).straight != 0; }
  /// Whether one step is allowed: its cell may be entered, and in a diagonal step both cells beside it as well.
  bool may_step(CellIndex from, int direction) const noexcept;

 private:
  bool open(const Cell& cell) const noexcept;
  static std::uint32_t risk_units(double risk, double weight) noexcept;
  void price_unexplored(CellIndex cell, Price& price) const noexcept;

  const RiskMap* map_;
  PriceRule rule_;
  Query query_;
  std::uint32_t now_;
};

}  // namespace ganglion::grid
