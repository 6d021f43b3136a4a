#pragma once

#include <cstddef>

#include "ganglion/geometry/box2.h"

namespace ganglion {

/// What ground an application stands on, as far as measures and tasks ask for it. Allocates nothing.
class Terrain {
 public:
  virtual ~Terrain() = default;
  /// The area there is.
  virtual Box2 bounds() const noexcept = 0;
  /// Way from a point along a unit vector to the first structural wall; +inf where there is none.
  virtual double far_wall_m(Vector2 from, Vector2 towards) const noexcept = 0;
  /// Whether any of it slopes.
  virtual bool slopes() const noexcept = 0;
  /// Distance to the nearest surface of what stands, at most up_to_m; negative inside solids, down to -up_to_m.
  virtual double clearance_m(Vector2 point, double up_to_m) const noexcept = 0;
  /// Whether a disc can be carried straight along `way` and touches nothing that stands.
  virtual bool way_free(Vector2 from, Vector2 way, double radius_m) const noexcept = 0;

  /// What moves about on it.
  struct Mover {
    Vector2 position;
    double radius_m = 0;  ///< Of the circle round it.
  };
  /// How many of them there are; 0 for a ground that nothing runs on.
  virtual std::size_t movers() const noexcept { return 0; }
  /// As it stands now.
  virtual Mover mover(std::size_t n) const noexcept {
    static_cast<void>(n);
    return {};
  }
  /// Distance from its surface; negative inside it.
  virtual double mover_clearance_m(std::size_t n, Vector2 point) const noexcept {
    static_cast<void>(n), static_cast<void>(point);
    return 0;
  }
};

}  // namespace ganglion
