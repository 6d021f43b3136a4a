#pragma once

#include <array>
#include <cstdint>

namespace ganglion::grid {

/// A place on the map: columns grow along x, rows along y.
struct CellIndex {
  std::int32_t column = 0;
  std::int32_t row = 0;
  friend constexpr bool operator==(CellIndex, CellIndex) noexcept = default;
};

/// Cells lie within this distance of (0, 0), so that sums of a few of them cannot overflow.
inline constexpr std::int32_t kFarthestCell = 1 << 28;

/// The eight directions: k * 45 deg in the map's frame, counter-clockwise from +x.
inline constexpr int kDirections = 8;
inline constexpr std::array<CellIndex, kDirections> kOffsets = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

constexpr bool is_diagonal(int direction) noexcept { return (direction & 1) != 0; }
/// The direction `by` eighths of a turn to the left.
constexpr int turned(int direction, int by) noexcept { return (direction + by) & 7; }
/// The turn from one direction to another, in eighths, -3..4.
constexpr int turn_between(int from, int to) noexcept { return ((to - from + 11) & 7) - 3; }
constexpr CellIndex neighbour(CellIndex cell, int direction) noexcept {
  const CellIndex offset = kOffsets[static_cast<std::size_t>(direction)];
  return {cell.column + offset.column, cell.row + offset.row};
}
/// Steps between two cells where diagonals count as one.
constexpr std::int32_t steps_between(CellIndex a, CellIndex b) noexcept {
  const std::int32_t columns = a.column > b.column ? a.column - b.column : b.column - a.column;
  const std::int32_t rows = a.row > b.row ? a.row - b.row : b.row - a.row;
  return columns > rows ? columns : rows;
}

enum class Label : std::uint8_t { Unexplored, Empty, Occupied };
/// Static: never crossed so far. Dynamic: what blocks it comes and goes.
enum class Nature : std::uint8_t { Static, Dynamic };

/// What is known of one cell.
struct Cell {
  double risk = 0;           ///< r in [0, 1): belief that crossing fails; P(cross) = 1 - r. Unexplored: mere suspicion.
  double cost_j = 0;         ///< Running mean of what entering it took, for the length of one straight step [J].
  std::uint32_t costed = 0;  ///< Crossings in that mean.
  std::uint32_t inhibited_until = 0;  ///< No attempt before this tick.
  std::uint32_t round = 0;            ///< The round to which `strain` and `closed_diagonals` belong.
  Label label = Label::Unexplored;
  Nature nature = Nature::Static;
  std::uint8_t strain = 0;            ///< Failed attempts of that round, each counted as its FailureCause.
  std::uint8_t closed_diagonals = 0;  ///< Bit k / 2: the step from here in direction k failed, and why is unclear.
};
static_assert(sizeof(Cell) <= 32);

}  // namespace ganglion::grid
