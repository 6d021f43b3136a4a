#pragma once

#include <cmath>

namespace ganglion {

/// A point or displacement in the plane [m].
struct Vector2 {
  double x = 0;
  double y = 0;

  constexpr double dot(Vector2 other) const noexcept { return x * other.x + y * other.y; }
  /// The z component of the cross product: positive when `other` lies to the left.
  constexpr double cross(Vector2 other) const noexcept { return x * other.y - y * other.x; }
  constexpr double squared() const noexcept { return dot(*this); }
  double length() const noexcept { return std::sqrt(squared()); }
  /// A quarter turn to the left.
  constexpr Vector2 left() const noexcept { return {-y, x}; }

  friend constexpr Vector2 operator+(Vector2 a, Vector2 b) noexcept { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vector2 operator-(Vector2 a, Vector2 b) noexcept { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vector2 operator-(Vector2 a) noexcept { return {-a.x, -a.y}; }
  friend constexpr Vector2 operator*(Vector2 a, double factor) noexcept { return {a.x * factor, a.y * factor}; }
  friend constexpr Vector2 operator*(double factor, Vector2 a) noexcept { return a * factor; }
  friend constexpr bool operator==(Vector2, Vector2) noexcept = default;
  constexpr Vector2& operator+=(Vector2 other) noexcept { return *this = *this + other; }
};

/// The unit vector of a direction.
Vector2 direction(double yaw_rad) noexcept;

/// The point of a segment nearest to `point`.
Vector2 nearest_on_segment(Vector2 point, Vector2 from, Vector2 to) noexcept;

}  // namespace ganglion
