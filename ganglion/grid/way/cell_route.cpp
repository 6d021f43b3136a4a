// Shortest routes on a CellGrid: A* with the octile estimate.
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "ganglion/base/expects.h"
#include "ganglion/grid/way/cell_grid.h"

namespace ganglion {
namespace {

constexpr double kNoWay_m = std::numeric_limits<double>::infinity();

double octile(CellGrid::Cell a, CellGrid::Cell b) noexcept {
  const int across = std::abs(a.column - b.column), up = std::abs(a.row - b.row);
  return std::abs(across - up) + std::numbers::sqrt2 * std::min(across, up);
}

}  // namespace

double CellGrid::Workspace::Way::cells() const noexcept { return straight + std::numbers::sqrt2 * diagonal; }

CellGrid::Workspace::Workspace(std::size_t cells)
    : way_(cells), estimate_(cells), heap_(cells), place_(cells), state_(cells), blocked_(cells) {}

void CellGrid::Workspace::clear() noexcept {
  heap_size_ = 0;
  std::fill(state_.begin(), state_.end(), State::Unseen);
  std::fill(blocked_.begin(), blocked_.end(), std::uint8_t{0});
}

bool CellGrid::Workspace::before(std::uint32_t a, std::uint32_t b) const noexcept {
  return estimate_[a] != estimate_[b] ? estimate_[a] < estimate_[b] : a < b;
}

void CellGrid::Workspace::open(std::uint32_t cell, const Way& way, double estimate) noexcept {
  way_[cell] = way;
  estimate_[cell] = estimate;
  if (state_[cell] != State::Open) {
    state_[cell] = State::Open;
    place_[cell] = static_cast<std::uint32_t>(heap_size_);
    heap_[heap_size_++] = cell;
  }
  raise(place_[cell]);
}

void CellGrid::Workspace::raise(std::size_t place) noexcept {
  const std::uint32_t cell = heap_[place];
  for (; place > 0 && before(cell, heap_[(place - 1) / 2]); place = (place - 1) / 2) {
    heap_[place] = heap_[(place - 1) / 2];
    place_[heap_[place]] = static_cast<std::uint32_t>(place);
  }
  heap_[place] = cell;
  place_[cell] = static_cast<std::uint32_t>(place);
}

std::uint32_t CellGrid::Workspace::pop() noexcept {
  const std::uint32_t top = heap_[0];
  state_[top] = State::Closed;
  const std::uint32_t moved = heap_[--heap_size_];
  std::size_t place = 0;
  for (std::size_t child = 1; child < heap_size_; child = 2 * place + 1) {
    if (child + 1 < heap_size_ && before(heap_[child + 1], heap_[child])) ++child;
    if (!before(heap_[child], moved)) break;
    heap_[place] = heap_[child];
    place_[heap_[place]] = static_cast<std::uint32_t>(place);
    place = child;
  }
  heap_[place] = moved;
  place_[moved] = static_cast<std::uint32_t>(place);
  return top;
}

double CellGrid::shortest_m(Cell from, Cell to, std::span<const Cell> blocked) const {
  Workspace work = make_workspace();
  return shortest_m(from, to, blocked, work);
}

double CellGrid::shortest_m(Cell from, Cell to, std::span<const Cell> blocked, Workspace& work) const noexcept {
  expects(work.state_.size() == free_.size());
  if (!free(from) || !free(to)) return kNoWay_m;
  work.clear();
  mark_blocked(blocked, work);
  const std::size_t goal = index(to);
  work.open(static_cast<std::uint32_t>(index(from)), {}, octile(from, to));
  while (work.heap_size_ > 0) {
    const std::uint32_t cell = work.pop();
    if (cell == goal) return work.way_[cell].cells() * cell_m_;
    for (int k = 0; k < 8; ++k) {
      if (!passable(cell, k, work)) continue;
      const auto next = static_cast<std::uint32_t>(neighbour(cell, k));
      Workspace::Way way = work.way_[cell];
      ++(k % 2 == 1 ? way.diagonal : way.straight);
      // A closed cell is opened again if rounding of the estimates closed it too early.
      if (work.state_[next] != Workspace::State::Unseen && !(way.cells() < work.way_[next].cells())) continue;
      work.open(next, way, way.cells() + octile(cell_of(next), to));
    }
  }
  return kNoWay_m;
}

}  // namespace ganglion
