#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ganglion/application/terrain.h"
#include "ganglion/base/result.h"

namespace ganglion {

/// The ground as squares that a robot steps between, its cells numbered by floor(position / cell_m): the truth against
/// which path finders are measured. A cell is free if a disc of the robot's radius can stand at its centre; a step
/// leads to one of the 8 neighbours if the disc can be carried straight there and, for diagonals, both cells beside it
/// are free.
class CellGrid {
 public:
  struct Cell {
    std::int32_t column = 0;
    std::int32_t row = 0;
    friend bool operator==(Cell, Cell) = default;
  };
  /// Memory of a search, so that one can be made without allocating.
  class Workspace;

  /// Cells that lie, wholly or in part, in the ground's bounds. Fails with BadParameter unless cell_m > 0 and radius_m
  /// >= 0, with TooLarge beyond 4 Mi cells. Cells whose centre lies outside the bounds are not free.
  static Result<CellGrid> make(const Terrain& terrain, double cell_m, double radius_m);

  double cell_m() const noexcept { return cell_m_; }
  Cell cell_at(Vector2 position) const noexcept;
  Vector2 centre(Cell cell) const noexcept;
  /// Lowest cell, and how many there are.
  Cell first() const noexcept { return first_; }
  int columns() const noexcept { return columns_; }
  int rows() const noexcept { return rows_; }
  bool contains(Cell cell) const noexcept;
  bool free(Cell cell) const noexcept;
  /// The neighbour of a cell in direction eighth * 45 deg, eighth 0..7 counter-clockwise from x.
  static Cell beside(Cell cell, int eighth) noexcept;
  /// Whether one step leads from a cell to a neighbour.
  bool step_free(Cell from, Cell to) const noexcept;
  /// Every free cell, row by row.
  std::vector<Cell> free_cells() const;
  /// The free cells to which steps lead from `from`, itself included, row by row.
  std::vector<Cell> reachable_from(Cell from, std::span<const Cell> blocked = {}) const;
  /// Cells whose centre what moves on the terrain, as it stands,, take from the robot. Steps past a mover are not judged.
  std::vector<Cell> taken_by_movers(const Terrain& terrain) const;
  /// The same into memory of the caller, cleared first; allocates only beyond its capacity.
  void taken_by_movers(const Terrain& terrain, std::vector<Cell>& taken) const;

  /// Length of a shortest route [m], octile: straight steps cell_m, diagonal ones sqrt(2) cell_m. `blocked` cells are
  /// not entered, and diagonals do not pass them, but a route may begin on one. +inf if there is none.
  double shortest_m(Cell from, Cell to, std::span<const Cell> blocked = {}) const;
  /// The same without allocating; the workspace must come from this grid.
  double shortest_m(Cell from, Cell to, std::span<const Cell> blocked, Workspace& workspace) const noexcept;
  Workspace make_workspace() const;

 private:
  CellGrid() = default;
  void find_free(const Terrain& terrain);
  void find_steps(const Terrain& terrain);
  std::size_t index(Cell cell) const noexcept {
    return static_cast<std::size_t>(cell.row - first_.row) * columns_ + (cell.column - first_.column);
  }
  Cell cell_of(std::size_t index) const noexcept {
    return {first_.column + static_cast<std::int32_t>(index % columns_),
            first_.row + static_cast<std::int32_t>(index / columns_)};
  }
  std::size_t neighbour(std::size_t from, int k) const noexcept;
  /// The way from a cell to its neighbour in direction k, if it can be gone with those cells blocked.
  bool passable(std::size_t from, int k, const Workspace& work) const noexcept;
  void mark_blocked(std::span<const Cell> blocked, Workspace& work) const noexcept;

  double cell_m_ = 1;
  double radius_m_ = 0;
  Cell first_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint8_t> free_;
  std::vector<std::uint8_t> steps_;  ///< Bit k: a step in direction k * 45 deg is free.
};

class CellGrid::Workspace {
 private:
  friend class CellGrid;
  enum class State : std::uint8_t { Unseen, Open, Closed };
  /// A way so far. Counts and not sums, so that the length never depends on the order of the steps.
  struct Way {
    std::uint32_t straight = 0;
    std::uint32_t diagonal = 0;
    double cells() const noexcept;
  };
  explicit Workspace(std::size_t cells);
  void clear() noexcept;
  /// Heap of open cells, the one with the lowest estimate (then the lowest number) first.
  void raise(std::size_t place) noexcept;
  std::uint32_t pop() noexcept;
  void open(std::uint32_t cell, const Way& way, double estimate) noexcept;
  bool before(std::uint32_t a, std::uint32_t b) const noexcept;

  std::vector<Way> way_;
  std::vector<double> estimate_;
  std::vector<std::uint32_t> heap_;
  std::vector<std::uint32_t> place_;  ///< Of an open cell in the heap.
  std::size_t heap_size_ = 0;
  std::vector<State> state_;
  std::vector<std::uint8_t> blocked_;
};

inline CellGrid::Workspace CellGrid::make_workspace() const { return Workspace(free_.size()); }

}  // namespace ganglion
