#pragma once

#include "ganglion/geometry/vector2.h"
#include "ganglion/units/angle.h"

namespace ganglion {

/// A place and a direction on the ground: x forward, y left, yaw counter-clockwise from x (REP-103).
struct Pose2 {
  Vector2 position{};  ///< [m]
  Angle yaw{};

  /// A point given in this pose's frame, in the frame this pose is given in.
  Vector2 to_outer(Vector2 local) const noexcept;
  /// The inverse of to_outer().
  Vector2 to_local(Vector2 outer) const noexcept;
  /// This pose followed by another one given in its frame; the yaw is wrapped.
  Pose2 then(const Pose2& local) const noexcept;
  friend bool operator==(const Pose2&, const Pose2&) = default;
};

}  // namespace ganglion
