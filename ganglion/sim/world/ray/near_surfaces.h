#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ganglion/sim/world/ray/surface_grid.h"

namespace ganglion::sim {

/// For each square cell of a ground the straight and round surfaces that a ray from within can meet: worked out once,
/// so that a robot need not look for them at every step. Where a cell would see too many there is no list, and a walk
/// through the surface grid is faster.
class NearSurfaces {
 public:
  static constexpr std::size_t kMaxListed = 128;

  /// Lists for robots whose centres lie in a cell, whose rays begin at most `spread_m` off and are at most `reach_m`
  /// long. Both finite.
  NearSurfaces(const SurfaceGrid& surfaces, double reach_m, double spread_m);

  /// Numbers as in SurfaceSet: segments, then rounds, each in rising order.
  struct List {
    std::span<const std::uint32_t> facing;   ///< Segments.
    std::span<const std::uint32_t> averted;  ///< Segments that only a ray reflected elsewhere can be first to meet.
    std::span<const std::uint32_t> rounds;
    bool listed = false;  ///< False: there is no list for the place.
  };
  List at(Vector2 point) const noexcept;

 private:
  struct Cell {
    std::uint32_t start = 0;  ///< In items_: facing, averted, rounds.
    std::uint8_t facing = 0;
    std::uint8_t averted = 0;
    std::uint8_t rounds = 0;
    bool listed = false;
  };
  void lay_out(const SurfaceGrid& surfaces);
  /// Calls on_cell(number) for every cell from which the item may be within reach.
  template <class OnCell>
  void each_near_cell(const SurfaceSet& set, std::size_t item, OnCell on_cell) const;
  bool averts(const SurfaceSet& set, std::uint32_t segment, const Box2& outline, std::size_t cell) const noexcept;
  Vector2 centre(std::size_t cell) const noexcept;

  double reach_m_, spread_m_;
  Vector2 lower_;
  double cell_m_ = 0.5;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> items_;
};

}  // namespace ganglion::sim
