#include "ganglion/grid/way/steered_way.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "ganglion/base/expects.h"

namespace ganglion {
namespace {

constexpr double kNoSteeredWay_m = std::numeric_limits<double>::infinity();

constexpr std::size_t kMostSteeredCells = 1 << 20;
constexpr std::uint32_t kHeadings = 8;

std::size_t count_of(const CellGrid& grid) noexcept { return static_cast<std::size_t>(grid.columns()) * grid.rows(); }

/// Number of the state "in `cell`, heading along the x axis"; the other headings follow it.
std::uint32_t first_state(const CellGrid& grid, CellGrid::Cell cell) noexcept {
  const std::int32_t index = (cell.row - grid.first().row) * grid.columns() + (cell.column - grid.first().column);
  return static_cast<std::uint32_t>(index) * kHeadings;
}

CellGrid::Cell cell_of(const CellGrid& grid, std::uint32_t state) noexcept {
  const auto index = static_cast<std::int32_t>(state / kHeadings);
  return {grid.first().column + index % grid.columns(), grid.first().row + index / grid.columns()};
}

}  // namespace

double SteeredWay::Length::cells() const noexcept { return straight + std::numbers::sqrt2 * diagonal; }

Result<SteeredWay> SteeredWay::make(const CellGrid& grid, int max_turn) {
  if (max_turn != 1 && max_turn != 2 && max_turn != 4) {
    return fail(ErrorCode::BadParameter,
                {"max_turn is {} eighths, must be 1, 2 or 4", "max_turn es {} octavos, debe ser 1, 2 o 4"}, max_turn);
  }
  if (count_of(grid) > kMostSteeredCells) {
    return fail(ErrorCode::TooLarge,
                {"the grid has {} cells; ways with a limited turn are sought among {} at most",
                 "la cuadrícula tiene {} celdas; los caminos de giro limitado se buscan entre {} como máximo"},
                count_of(grid), kMostSteeredCells);
  }
  return SteeredWay(count_of(grid), max_turn);
}

SteeredWay::SteeredWay(std::size_t cells, int max_turn)
    : max_turn_(max_turn), length_(cells * kHeadings), mark_(cells * kHeadings) {
  straight_.states.resize(cells * kHeadings);
  diagonal_.states.resize(cells * kHeadings);
}

void SteeredWay::clear() noexcept {
  std::fill(mark_.begin(), mark_.end(), Mark::Unseen);
  straight_.head = straight_.tail = 0;
  diagonal_.head = diagonal_.tail = 0;
}

double SteeredWay::shortest_m(const CellGrid& grid, Cell from, int heading, Cell to) noexcept {
  expects(mark_.size() == count_of(grid) * kHeadings);
  expects(heading >= 0 && heading < static_cast<int>(kHeadings));
  if (!grid.free(from) || !grid.free(to)) return kNoSteeredWay_m;
  clear();
  const std::uint32_t start = first_state(grid, from) + static_cast<std::uint32_t>(heading);
  length_[start] = {};
  mark_[start] = Mark::Open;
  straight_.push(start);
  while (!straight_.empty() || !diagonal_.empty()) {
    const std::uint32_t state = pop();
    if (mark_[state] == Mark::Closed) continue;  // it came by both queues
    mark_[state] = Mark::Closed;
    const Cell cell = cell_of(grid, state);
    if (cell == to) return length_[state].cells() * grid.cell_m();
    expand(grid, state, cell);
  }
  return kNoSteeredWay_m;
}

std::uint32_t SteeredWay::pop() noexcept {
  // A front whose way was shortened since by the other queue stands for the shorter way: it is no later than it says.
  const bool straight = diagonal_.empty() || (!straight_.empty() &&
                                              length_[straight_.front()].cells() <= length_[diagonal_.front()].cells());
  Queue& queue = straight ? straight_ : diagonal_;
  return queue.states[queue.head++];
}

void SteeredWay::expand(const CellGrid& grid, std::uint32_t state, Cell cell) noexcept {
  for (int turn = -max_turn_; turn <= max_turn_; ++turn) {
    const std::uint32_t heading = (state + kHeadings + static_cast<std::uint32_t>(turn)) % kHeadings;
    for (const std::uint32_t way : {heading, (heading + kHeadings / 2) % kHeadings}) {  // forwards, backwards
      const Cell next = CellGrid::beside(cell, static_cast<int>(way));
      if (grid.step_free(cell, next)) open(first_state(grid, next) + heading, length_[state], way % 2 == 1);
    }
  }
}

void SteeredWay::open(std::uint32_t state, const Length& before, bool diagonal) noexcept {
  if (mark_[state] == Mark::Closed) return;
  Length length = before;
  ++(diagonal ? length.diagonal : length.straight);
  if (mark_[state] == Mark::Open && !(length.cells() < length_[state].cells())) return;
  mark_[state] = Mark::Open;
  length_[state] = length;
  (diagonal ? diagonal_ : straight_).push(state);
}

}  // namespace ganglion
