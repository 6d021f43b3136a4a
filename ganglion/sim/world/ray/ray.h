#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "ganglion/sim/world/shape/shape.h"

namespace ganglion::sim {

inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// A ray; `direction` is a unit vector.
struct Ray {
  Vector2 from;
  Vector2 direction;
};

/// Range to a segment, ends included; +inf if the ray misses it or runs parallel to it.
/// Two segments that share an end leave no gap: both judge the shared end by the very same number.
inline double range_to_segment(const Ray& ray, Vector2 a, Vector2 b) noexcept {
  const Vector2 to_a = a - ray.from, to_b = b - ray.from;
  const double side_a = ray.direction.cross(to_a), side_b = ray.direction.cross(to_b);
  const double along_a = ray.direction.dot(to_a), along_b = ray.direction.dot(to_b);
  const double share = side_a / (side_a - side_b);  // of the segment, from a; infinite or NaN if parallel
  const double range = along_a + (along_b - along_a) * share;
  return share >= 0 && share <= 1 && range >= 0 ? range : kNoHit;
}

/// Range to the surface of a disc, from without or from within; +inf if the ray misses it.
inline double range_to_circle(const Ray& ray, const Disc& disc) noexcept {
  const Vector2 to_centre = disc.position - ray.from;
  const double along = ray.direction.dot(to_centre);
  const double aside = ray.direction.cross(to_centre);
  const double half_chord_squared = (disc.radius_m - aside) * (disc.radius_m + aside);
  if (half_chord_squared < 0) return kNoHit;
  const double half_chord = std::sqrt(half_chord_squared);
  if (along - half_chord >= 0) return along - half_chord;
  return along + half_chord >= 0 ? along + half_chord : kNoHit;
}

/// The same for a disc that is not seen from within.
inline double range_to_disc(const Ray& ray, const Disc& disc) noexcept {
  const Vector2 to_centre = disc.position - ray.from;
  const double along = ray.direction.dot(to_centre);
  const double aside = ray.direction.cross(to_centre);
  const double half_chord_squared = (disc.radius_m - aside) * (disc.radius_m + aside);
  if (!(half_chord_squared >= 0)) return kNoHit;
  const double range = along - std::sqrt(half_chord_squared);
  return range >= 0 ? range : kNoHit;
}

/// The next double above a range > 0: what lies at the limit itself is nearer than that.
inline double next_above(double range) noexcept {
  return range < kNoHit ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(range) + 1) : range;
}

/// The unit normal of a segment, on its left.
inline Vector2 left_normal(Vector2 a, Vector2 b) noexcept { return (b - a).left() * (1 / (b - a).length()); }

/// The unit normal of a segment on the side of the ray's origin.
inline Vector2 normal_towards(const Ray& ray, Vector2 left_normal) noexcept {
  return left_normal.dot(ray.direction) > 0 ? -left_normal : left_normal;
}
inline Vector2 normal_towards(const Ray& ray, Vector2 a, Vector2 b) noexcept {
  return normal_towards(ray, left_normal(a, b));
}

/// The unit normal of a circle where the ray meets it, towards the ray's origin.
inline Vector2 normal_towards(const Ray& ray, const Disc& disc, double range_m) noexcept {
  const Vector2 out = (ray.from + ray.direction * range_m - disc.position) * (1 / disc.radius_m);
  return out.dot(ray.direction) > 0 ? -out : out;
}

}  // namespace ganglion::sim
