#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ganglion/grid/open_list.h"
#include "ganglion/grid/price.h"

namespace ganglion::grid {

/// The square of ground in which one route is sought, and the cost from its cells to the goal for a robot that could
/// turn on the spot: the estimate that guides the search for the real one, and the quick proof that a goal is sealed.
/// Worked out only where asked for. Cells on the rim of the square are closed.
///
/// Source   Silver, "Cooperative pathfinding" (2005), reverse resumable A*.
class GoalDistance {
 public:
  /// side >= 8 cells.
  explicit GoalDistance(int side);

  /// Prepares for a query. False when start and goal do not fit into the square together.
  bool aim(const Pricing& pricing, CellIndex start, CellIndex goal) noexcept;
  /// Cost to the goal in units; kNever when there is no way at all.
  std::uint32_t operator()(std::uint32_t cell) noexcept;
  /// Cost of one step in units; kNever when it is not allowed. `cell` must not lie on the rim.
  std::uint32_t step(std::uint32_t cell, int direction) noexcept;
  /// The length part of that cost.
  std::uint32_t length(std::uint32_t entered, int direction) noexcept;

  std::uint32_t number(CellIndex cell) const noexcept;
  CellIndex index(std::uint32_t number) const noexcept;
  std::uint32_t next(std::uint32_t cell, int direction) const noexcept {
    return cell + static_cast<std::uint32_t>(offsets_[static_cast<std::size_t>(direction)]);
  }
  std::size_t cells() const noexcept { return nodes_.size(); }

 private:
  struct Node {
    std::uint32_t met = 0;  ///< Search in which it was last seen.
    std::uint32_t cost = kNever;
    Price price{};
  };
  Node& node(std::uint32_t cell) noexcept;
  bool inside(CellIndex cell) const noexcept;
  bool on_rim(std::uint32_t cell) const noexcept;
  void expand(std::uint32_t cell) noexcept;
  void reach(std::uint32_t cell, std::uint32_t cost) noexcept;

  int side_;
  std::array<std::int32_t, kDirections> offsets_{};
  std::vector<Node> nodes_;
  OpenList open_;
  std::optional<Pricing> pricing_;
  CellIndex corner_{};
  CellIndex start_{};
  std::uint32_t search_ = 0;
};

/// Length in units of the shortest way between two cells on free ground.
std::uint32_t octile_units(CellIndex a, CellIndex b) noexcept;

}  // namespace ganglion::grid
