#pragma once

#include "ganglion/geometry/vector2.h"

namespace ganglion {

/// What ground an application stands on, as far as measures and tasks ask for it.
class Terrain {
 public:
  virtual ~Terrain() = default;
  /// Way from a point along a unit vector to the first structural wall; +inf where there is none.
  virtual double far_wall_m(Vector2 from, Vector2 towards) const noexcept = 0;
  /// Whether any of it slopes.
  virtual bool slopes() const noexcept = 0;
};

}  // namespace ganglion
