#include "ganglion/grid/way/cell_grid.h"

#include <algorithm>
#include <array>

namespace ganglion {
namespace {

constexpr double kMaxCells = 4 << 20;
constexpr double kMaxNumber = 1e9;     ///< Of a column or row, either way; differences still fit 32 bits.
constexpr double kTolerance_m = 1e-9;  ///< A robot as wide as its cell may stand between walls on the cell's borders.

struct Offset {
  int column;
  int row;
};
constexpr std::array<Offset, 8> kNeighbours = {{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
constexpr bool is_diagonal(int k) noexcept { return k % 2 == 1; }

}  // namespace

Result<CellGrid> CellGrid::make(const Terrain& terrain, double cell_m, double radius_m) {
  if (!(cell_m > 0))
    return fail(ErrorCode::BadParameter, {"cell_m is {}, must be > 0", "cell_m es {}, debe ser > 0"}, cell_m);
  if (!(radius_m >= 0))
    return fail(ErrorCode::BadParameter, {"radius_m is {}, must be >= 0", "radius_m es {}, debe ser >= 0"}, radius_m);
  const Box2 box = terrain.bounds();
  const double count = (box.width_m() / cell_m + 2) * (box.height_m() / cell_m + 2);
  const double farthest_m = std::max({-box.lower.x, -box.lower.y, box.upper.x, box.upper.y});
  if (!(count <= kMaxCells && farthest_m / cell_m < kMaxNumber)) {
    return fail(ErrorCode::TooLarge,
                {"cells of {} m make {:.0f} of them here; the limit is {:.0f}",
                 "con celdas de {} m hay aquí {:.0f}; el límite es {:.0f}"},
                cell_m, count, kMaxCells);
  }
  CellGrid grid;
  grid.cell_m_ = cell_m;
  grid.radius_m_ = radius_m;
  const Vector2 inset{cell_m * 1e-9, cell_m * 1e-9};
  grid.first_ = grid.cell_at(box.lower + inset);
  const Cell last = grid.cell_at(box.upper - inset);
  grid.columns_ = std::max(last.column - grid.first_.column + 1, 1);
  grid.rows_ = std::max(last.row - grid.first_.row + 1, 1);
  grid.find_free(terrain);
  grid.find_steps(terrain);
  return grid;
}

void CellGrid::find_free(const Terrain& terrain) {
  free_.assign(static_cast<std::size_t>(columns_) * rows_, 0);
  const double needed_m = radius_m_ - kTolerance_m;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const Vector2 middle = centre(cell_of(i));
    free_[i] = terrain.bounds().contains(middle) && terrain.clearance_m(middle, radius_m_ + cell_m_) >= needed_m;
  }
}

void CellGrid::find_steps(const Terrain& terrain) {
  steps_.assign(free_.size(), 0);
  const double radius_m = std::max(radius_m_ - kTolerance_m, 0.0);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (free_[i] == 0) continue;
    const Cell cell = cell_of(i);
    for (int k = 0; k < 8; ++k) {
      const Offset offset = kNeighbours[k];
      if (!free({cell.column + offset.column, cell.row + offset.row})) continue;
      if (!free({cell.column + offset.column, cell.row}) || !free({cell.column, cell.row + offset.row})) continue;
      const Vector2 way{offset.column * cell_m_, offset.row * cell_m_};
      if (terrain.way_free(centre(cell), way, radius_m)) steps_[i] = static_cast<std::uint8_t>(steps_[i] | (1 << k));
    }
  }
}

CellGrid::Cell CellGrid::cell_at(Vector2 position) const noexcept {
  auto along = [&](double x) {
    const double number = std::floor(x / cell_m_);
    if (!(number > -kMaxNumber)) return static_cast<std::int32_t>(-kMaxNumber);  // NaN as well
    return static_cast<std::int32_t>(std::min(number, kMaxNumber));
  };
  return {along(position.x), along(position.y)};
}

Vector2 CellGrid::centre(Cell cell) const noexcept {
  return {(cell.column + 0.5) * cell_m_, (cell.row + 0.5) * cell_m_};
}

bool CellGrid::contains(Cell cell) const noexcept {
  return cell.column >= first_.column && cell.row >= first_.row && cell.column - first_.column < columns_ &&
         cell.row - first_.row < rows_;
}

bool CellGrid::free(Cell cell) const noexcept { return contains(cell) && free_[index(cell)] != 0; }

CellGrid::Cell CellGrid::beside(Cell cell, int eighth) noexcept {
  const Offset offset = kNeighbours[static_cast<std::size_t>(eighth)];
  return {cell.column + offset.column, cell.row + offset.row};
}

bool CellGrid::step_free(Cell from, Cell to) const noexcept {
  if (!contains(from)) return false;
  for (int k = 0; k < 8; ++k) {
    if (to == beside(from, k)) return (steps_[index(from)] >> k & 1) != 0;
  }
  return false;
}

std::vector<CellGrid::Cell> CellGrid::free_cells() const {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (free_[i] != 0) cells.push_back(cell_of(i));
  }
  return cells;
}

std::vector<CellGrid::Cell> CellGrid::taken_by_movers(const Terrain& terrain) const {
  std::vector<Cell> taken;
  taken_by_movers(terrain, taken);
  return taken;
}

void CellGrid::taken_by_movers(const Terrain& terrain, std::vector<Cell>& taken) const {
  taken.clear();
  for (std::size_t i = 0; i < terrain.movers(); ++i) {
    const auto [at, mover_radius_m] = terrain.mover(i);
    const double reach_m = mover_radius_m + radius_m_;
    const Vector2 reach{reach_m, reach_m};
    const Cell low = cell_at(at - reach), high = cell_at(at + reach);
    const std::int32_t last_row = std::min(high.row, first_.row + rows_ - 1);
    const std::int32_t last_column = std::min(high.column, first_.column + columns_ - 1);
    for (std::int32_t row = std::max(low.row, first_.row); row <= last_row; ++row) {
      for (std::int32_t column = std::max(low.column, first_.column); column <= last_column; ++column) {
        if (terrain.mover_clearance_m(i, centre({column, row})) < radius_m_ - kTolerance_m)
          taken.push_back({column, row});
      }
    }
  }
  std::sort(taken.begin(), taken.end(),
            [](Cell a, Cell b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
  taken.erase(std::unique(taken.begin(), taken.end()), taken.end());
}

std::vector<CellGrid::Cell> CellGrid::reachable_from(Cell from, std::span<const Cell> blocked) const {
  std::vector<Cell> reached;
  if (!free(from)) return reached;
  Workspace work(free_.size());
  mark_blocked(blocked, work);
  std::vector<std::size_t> queue{index(from)};
  work.state_[queue.front()] = Workspace::State::Closed;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (int k = 0; k < 8; ++k) {
      if (!passable(queue[next], k, work)) continue;
      const std::size_t to = neighbour(queue[next], k);
      if (work.state_[to] == Workspace::State::Closed) continue;
      work.state_[to] = Workspace::State::Closed;
      queue.push_back(to);
    }
  }
  std::sort(queue.begin(), queue.end());
  for (const std::size_t i : queue) reached.push_back(cell_of(i));
  return reached;
}

std::size_t CellGrid::neighbour(std::size_t from, int k) const noexcept {
  return from +
         static_cast<std::size_t>(static_cast<std::ptrdiff_t>(kNeighbours[k].row) * columns_ + kNeighbours[k].column);
}

bool CellGrid::passable(std::size_t from, int k, const Workspace& work) const noexcept {
  if ((steps_[from] >> k & 1) == 0 || work.blocked_[neighbour(from, k)] != 0) return false;
  if (!is_diagonal(k)) return true;
  return work.blocked_[neighbour(from, (k + 1) % 8)] == 0 && work.blocked_[neighbour(from, (k + 7) % 8)] == 0;
}

void CellGrid::mark_blocked(std::span<const Cell> blocked, Workspace& work) const noexcept {
  for (const Cell cell : blocked) {
    if (contains(cell)) work.blocked_[index(cell)] = 1;
  }
}

}  // namespace ganglion
