#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ganglion/sim/world/world.h"

namespace ganglion::sim {

/// The ground as squares that a robot steps between, its cells numbered by floor(position / cell_m): the truth against
/// which path finders are measured. A cell is free if a disc of the robot's radius can stand at its centre; a step leads to
/// one of the 8 neighbours if the disc can be carried straight there and, for diagonals, both cells beside it are free.
class CellGrid {
 public:
  struct Cell {
    std::int32_t column = 0;
    std::int32_t row = 0;
    friend bool operator==(Cell, Cell) = default;
  };
  /// Memory of a search, so that one can be made without allocating.
  class Workspace {
   private:
    friend class CellGrid;
    explicit Workspace(std::size_t cells);
    std::vector<double> cost_;
    std::vector<std::uint32_t> heap_;
    std::vector<std::uint32_t> slot_;  ///< Place of a cell in the heap.
    std::vector<std::uint8_t> state_;
  };

  /// Cells that lie, wholly or in part, in the ground's bounds. Fails with BadParameter unless cell_m > 0 and radius_m >= 0,
  /// with TooLarge beyond 4 Mi cells.
  static Result<CellGrid> make(const Ground& ground, double cell_m, double radius_m);

  double cell_m() const noexcept { return cell_m_; }
  Cell cell_at(Vector2 position) const noexcept;
  Vector2 centre(Cell cell) const noexcept;
  /// Lowest cell, and how many there are.
  Cell first() const noexcept { return first_; }
  int columns() const noexcept { return columns_; }
  int rows() const noexcept { return rows_; }
  bool contains(Cell cell) const noexcept;
  bool free(Cell cell) const noexcept;
  /// Whether one step leads from a cell to a neighbour.
  bool step_free(Cell from, Cell to) const noexcept;
  /// Every free cell, row by row.
  std::vector<Cell> free_cells() const;
  /// The free cells to which steps lead from `from`, itself included, row by row.
  std::vector<Cell> reachable_from(Cell from, std::span<const Cell> blocked = {}) const;
  /// Cells whose centre the movers of `world`, as they stand, take from the robot. Steps past a mover are not judged.
  std::vector<Cell> taken_by_movers(const World& world) const;
  /// The same into memory of the caller, cleared first; allocates only beyond its capacity.
  void taken_by_movers(const World& world, std::vector<Cell>& taken) const;

  /// Length of a shortest route [m], octile: straight steps cell_m, diagonal ones sqrt(2) cell_m. `blocked` cells are not
  /// entered, and diagonals do not pass them, but a route may begin on one. +inf if there is none.
  double shortest_m(Cell from, Cell to, std::span<const Cell> blocked = {}) const;
  /// The same without allocating; the workspace must come from this grid.
  double shortest_m(Cell from, Cell to, std::span<const Cell> blocked, Workspace& workspace) const noexcept;
  Workspace make_workspace() const { return Workspace(free_.size()); }

 private:
  CellGrid() = default;
  void find_steps(const Ground& ground);
  std::size_t index(Cell cell) const noexcept;

  double cell_m_ = 1;
  double radius_m_ = 0;
  Cell first_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint8_t> free_;
  std::vector<std::uint8_t> steps_;  ///< Bit k: a step in direction k * 45 deg is free.
};

}  // namespace ganglion::sim
