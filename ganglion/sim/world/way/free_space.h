#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "ganglion/random/draws.h"
#include "ganglion/sim/world/ground.h"

namespace ganglion::sim {

/// Where on a ground there is room to stand, for starting robots. Movers are not looked at: ask World::clearance().
/// What is found out for a clearance the ground keeps, for all free spaces on it. One object is for one thread.
class FreeSpace {
 public:
  /// The raster's cell is made larger where the ground would need more than 4 Mi of them. cell_m > 0.
  explicit FreeSpace(std::shared_ptr<const Ground> ground, double cell_m = 0.05);

  const Box2& bounds() const noexcept { return ground_->bounds(); }
  /// Area of the largest part of bounds() that a disc of radius clearance_m can move about in without leaving it,
  /// counted in cells whose centre has that clearance, joined by their sides. 0: there is no such place.
  double largest_part_area_m2(double clearance_m = 0);
  /// A point drawn uniformly from that part, its clearance checked exactly. There must be one:
  /// expects(largest_part_area_m2(clearance_m) > 0).
  Vector2 sample(double clearance_m, Draws& draws);

 private:
  using Cells = std::vector<std::uint32_t>;
  const Cells& part(double clearance_m);
  Cells largest_part(double clearance_m) const;
  bool roomy(Vector2 point, double clearance_m) const noexcept;
  /// Whether no wall stands between two points of one cell or of neighbours; clearance alone tells where it is ample.
  bool joined(Vector2 a, Vector2 b, double clearance_m) const noexcept;
  Vector2 centre(std::uint32_t cell) const noexcept;

  std::shared_ptr<const Ground> ground_;
  double cell_m_;
  int columns_ = 1;
  int rows_ = 1;
  std::map<double, std::shared_ptr<const Cells>> parts_;  ///< By clearance: the cells of the largest part.
};

}  // namespace ganglion::sim
