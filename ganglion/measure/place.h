#pragma once

#include "ganglion/geometry/pose2.h"
#include "ganglion/measure/measure.h"

namespace ganglion {

/// Where in a row of truth the pose of a robot's centre stands.
struct PlaceColumns {
  std::size_t x = 0, y = 0, yaw = 0;

  /// None where the truth has no pose.
  static std::optional<PlaceColumns> in(const MeasureScope& scope);
  Vector2 position(std::span<const double> truth) const noexcept { return {truth[x], truth[y]}; }
};

}  // namespace ganglion
