#include "ganglion/grid/price.h"

#include <algorithm>

#include "ganglion/math/functions.h"

namespace ganglion::grid {
namespace {

std::uint32_t rounded(double units) noexcept { return static_cast<std::uint32_t>(units + 0.5); }

}  // namespace

bool Pricing::open(const Cell& cell) const noexcept {
  if (RiskMap::inhibited(cell, now_)) return false;
  if (cell.label == Label::Unexplored) return true;
  if (query_ == Query::Secure) return cell.label == Label::Empty && cell.risk <= rule_.secure_risk;
  return !map_->spent(cell);
}

std::uint32_t Pricing::risk_units(double risk, double weight) noexcept {
  return risk > 0 ? rounded(-weight * math::log(1 - risk) * kStraightUnits) : 0;
}

void Pricing::price_unexplored(CellIndex index, Price& price) const noexcept {
  const double risk = unexplored_risk(*map_, index, rule_.unexplored);
  price.risk = risk_units(risk, rule_.unexplored.weight);
  // A diagonal attempt that fails beside unexplored ground teaches little; straight attempts come first.
  const bool suspects = query_ == Query::Feasible;
  price.side = suspects ? std::max(price.risk, risk_units(map_->rule().first_risk, rule_.risk_weight)) : price.risk;
}

Price Pricing::operator()(CellIndex index) const noexcept {
  const Cell* cell = map_->find(index);
  Price price;
  if (cell != nullptr) price.closed_diagonals = map_->closed_diagonals(*cell);
  if (cell == nullptr ? map_->full() : !open(*cell)) return price;
  const bool known = cell != nullptr && cell->label != Label::Unexplored;
  const bool weighs = known && (query_ == Query::Feasible || rule_.secure_weighs_cost);
  const double factor = weighs ? map_->cost_factor(*cell) : 1;
  price.straight = rounded(kStraightUnits * factor);
  price.diagonal = rounded(kDiagonalUnits * factor);
  if (!known) {
    price_unexplored(index, price);
  } else if (query_ == Query::Feasible) {
    price.risk = price.side = risk_units(cell->risk, rule_.risk_weight);
  }
  return price;
}

bool Pricing::may_step(CellIndex from, int direction) const noexcept {
  if (!may_enter(neighbour(from, direction))) return false;
  return !is_diagonal(direction) ||
         ((*this)(from).lets_leave(direction) && may_enter(neighbour(from, turned(direction, -1))) &&
          may_enter(neighbour(from, turned(direction, 1))));
}

}  // namespace ganglion::grid
