#include "ganglion/grid/goal_distance.h"

#include <algorithm>
#include <cstdlib>

#include "ganglion/base/expects.h"

namespace ganglion::grid {

std::uint32_t octile_units(CellIndex a, CellIndex b) noexcept {
  const auto columns = static_cast<std::uint32_t>(std::abs(a.column - b.column));
  const auto rows = static_cast<std::uint32_t>(std::abs(a.row - b.row));
  const std::uint32_t diagonals = std::min(columns, rows);
  return kDiagonalUnits * diagonals + kStraightUnits * (std::max(columns, rows) - diagonals);
}

GoalDistance::GoalDistance(int side)
    : side_(side), nodes_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)), open_(nodes_.size()) {
  expects(side >= 8);
  for (std::size_t k = 0; k < offsets_.size(); ++k) offsets_[k] = kOffsets[k].row * side + kOffsets[k].column;
}

bool GoalDistance::inside(CellIndex cell) const noexcept {
  return cell.column > corner_.column && cell.column < corner_.column + side_ - 1 && cell.row > corner_.row &&
         cell.row < corner_.row + side_ - 1;
}

std::uint32_t GoalDistance::number(CellIndex cell) const noexcept {
  return static_cast<std::uint32_t>((cell.row - corner_.row) * side_ + cell.column - corner_.column);
}

CellIndex GoalDistance::index(std::uint32_t number) const noexcept {
  const auto n = static_cast<std::int32_t>(number);
  return {corner_.column + n % side_, corner_.row + n / side_};
}

bool GoalDistance::on_rim(std::uint32_t cell) const noexcept { return !inside(index(cell)); }

bool GoalDistance::aim(const Pricing& pricing, CellIndex start, CellIndex goal) noexcept {
  pricing_ = pricing;
  start_ = start;
  const auto middle = [](std::int32_t a, std::int32_t b) { return (a + b) / 2; };
  corner_ = {middle(start.column, goal.column) - side_ / 2, middle(start.row, goal.row) - side_ / 2};
  if (!inside(start) || !inside(goal)) return false;
  if (++search_ == 0) {
    for (Node& each : nodes_) each.met = 0;
    search_ = 1;
  }
  open_.clear();
  if (node(number(goal)).price.straight != 0) reach(number(goal), 0);
  return true;
}

GoalDistance::Node& GoalDistance::node(std::uint32_t cell) noexcept {
  Node& found = nodes_[cell];
  if (found.met != search_) {
    found.met = search_;
    found.cost = kNever;
    found.price = on_rim(cell) ? Price{} : (*pricing_)(index(cell));
    open_.meet(cell);
  }
  return found;
}

std::uint32_t GoalDistance::length(std::uint32_t entered, int direction) noexcept {
  const Price& price = node(entered).price;
  return is_diagonal(direction) ? price.diagonal : price.straight;
}

std::uint32_t GoalDistance::step(std::uint32_t cell, int direction) noexcept {
  const Price& entered = node(next(cell, direction)).price;
  if (entered.straight == 0) return kNever;
  if (!is_diagonal(direction)) return entered.straight + entered.risk;
  if (!node(cell).price.lets_leave(direction)) return kNever;
  const Price& right = node(next(cell, turned(direction, -1))).price;
  const Price& left = node(next(cell, turned(direction, 1))).price;
  if (right.straight == 0 || left.straight == 0) return kNever;
  return entered.diagonal + entered.risk + right.side + left.side;
}

std::uint32_t GoalDistance::operator()(std::uint32_t cell) noexcept {
  node(cell);
  while (!open_.closed(cell) && !open_.empty()) expand(open_.pop());
  return open_.closed(cell) ? nodes_[cell].cost : kNever;
}

void GoalDistance::expand(std::uint32_t cell) noexcept {
  const std::uint32_t cost = nodes_[cell].cost;
  if (on_rim(cell)) return;
  for (int direction = 0; direction < kDirections; ++direction) {
    const std::uint32_t from = next(cell, turned(direction, 4));
    const bool enters = node(from).price.straight != 0 || index(from) == start_;
    if (!enters || open_.closed(from)) continue;
    const std::uint32_t edge = step(from, direction);
    if (edge != kNever && cost < kNever - edge) reach(from, cost + edge);
  }
}

void GoalDistance::reach(std::uint32_t cell, std::uint32_t cost) noexcept {
  Node& reached = node(cell);
  if (cost >= reached.cost) return;
  reached.cost = cost;
  open_.push(cell, std::uint64_t{cost} + octile_units(index(cell), start_));
}

}  // namespace ganglion::grid
