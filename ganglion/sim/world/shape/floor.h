#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ganglion/sim/world/shape/shape.h"

namespace ganglion::sim {

/// What something looks like to a camera; each part in [0, 1].
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// The floor where no zone lies: middle grey (ours).
inline constexpr Colour kPlainFloor{0.5, 0.5, 0.5};

/// A patch of floor unlike the rest. Neither robots nor rays run into it. Numbers are ours throughout.
struct FloorZone {
  std::string id;
  std::string label;
  std::vector<Vector2> outline;  ///< Counter-clockwise; empty for a disc.
  Disc disc;
  Box2 box;                ///< Round it.
  double slip = 0;         ///< Share of the wheels' way that is lost, in [0, 1].
  double slip_spread = 0;  ///< Standard deviation of that share, of each side apart and from step to step.
  Colour colour = kPlainFloor;
  double grade = 0;      ///< Tangent of the slope: metres up for each metre along `uphill`.
  Vector2 uphill{1, 0};  ///< Unit.
  double lowest_m = 0;   ///< Where along `uphill` the zone begins: its lowest edge.
  double height_m = 0;   ///< Height of that edge above the floor.
  double warmer_C = 0;   ///< Than the air elsewhere.

  bool contains(Vector2 point) const noexcept;
  /// Height of the floor at a point of the zone.
  double height_at(Vector2 point) const noexcept { return height_m + grade * (uphill.dot(point) - lowest_m); }
};

/// A ridge too low for sonar to see: a cable, a sill. A robot whose centre crosses it is turned.
struct FloorBump {
  std::string id;
  Vector2 from;
  Vector2 to;
  double turn_rad = 0;  ///< Standard deviation of that turn.
};

/// The floor of a ground.
struct Floor {
  std::vector<FloorZone> zones;
  std::vector<FloorBump> bumps;

  /// Nothing on it differs from a plain floor.
  bool plain() const noexcept { return zones.empty() && bumps.empty(); }
  /// The zone at a point, the one latest in the file where several overlap; null on plain floor.
  const FloorZone* zone_at(Vector2 point) const noexcept;
  Colour colour_at(Vector2 point) const noexcept;
  /// Rise per metre along x and y.
  Vector2 gradient_at(Vector2 point) const noexcept;
  double height_at(Vector2 point) const noexcept;
  double warmer_C_at(Vector2 point) const noexcept;
};

/// Whether the way from `before` to `after` crosses the bump. A way that ends on it has not crossed yet; the next one,
/// which begins there, has if it leaves to the other side.
bool crosses(const FloorBump& bump, Vector2 before, Vector2 after) noexcept;

}  // namespace ganglion::sim
