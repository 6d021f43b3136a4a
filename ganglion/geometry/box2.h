#pragma once

#include "ganglion/geometry/vector2.h"

namespace ganglion {

/// A rectangle along the axes [m].
struct Box2 {
  Vector2 lower;
  Vector2 upper;
  /// Grown just enough to hold the point.
  void include(Vector2 point) noexcept;
  bool contains(Vector2 point) const noexcept {
    return point.x >= lower.x && point.x <= upper.x && point.y >= lower.y && point.y <= upper.y;
  }
  double width_m() const noexcept { return upper.x - lower.x; }
  double height_m() const noexcept { return upper.y - lower.y; }
  friend bool operator==(const Box2&, const Box2&) = default;
};
/// Holds nothing until something is included.
Box2 empty_box() noexcept;

}  // namespace ganglion
