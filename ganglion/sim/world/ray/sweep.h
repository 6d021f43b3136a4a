#pragma once

#include "ganglion/sim/world/shape/shape.h"

namespace ganglion::sim {

/// The first touch of a disc that is carried along a displacement.
struct Contact {
  double fraction = 2;  ///< Of the displacement, in [0, 1]; more than 1: none.
  Vector2 normal;       ///< Unit, from the surface to the disc's centre.
  double depth_m = 0;   ///< How far the disc overlapped the surface to begin with.
  bool happened() const noexcept { return fraction <= 1; }
};

/// Where a disc of `radius_m` at `from`, carried along `displacement`, first touches the segment a-b: kept in `first`
/// if earlier than what stands there. A disc that overlaps already touches at once if it approaches, else not at all.
void sweep_segment(Vector2 from, Vector2 displacement, double radius_m, Vector2 a, Vector2 b, Contact& first) noexcept;

/// The same for another disc, at rest.
void sweep_disc(Vector2 from, Vector2 displacement, double radius_m, const Disc& obstacle, Contact& first) noexcept;

}  // namespace ganglion::sim
