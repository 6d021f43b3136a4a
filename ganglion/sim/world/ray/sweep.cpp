#include "ganglion/sim/world/ray/sweep.h"

#include <algorithm>
#include <cmath>

#include "ganglion/geometry/vector2.h"

namespace ganglion::sim {
namespace {

void keep_earlier(const Contact& contact, Contact& first) noexcept {
  if (contact.fraction < first.fraction) first = contact;
}

/// A moving point against a circle about `centre`. The callers know it to lie without, up to rounding.
void sweep_circle(Vector2 from, Vector2 displacement, double radius_m, Vector2 centre, Contact& first) noexcept {
  const Vector2 out = from - centre;
  const double a = displacement.squared(), b = out.dot(displacement);
  const double c = std::max(out.squared() - radius_m * radius_m, 0.0);
  const double discriminant = b * b - a * c;
  if (!(b < 0) || discriminant < 0) return;
  const double fraction = c / (std::sqrt(discriminant) - b);
  const Vector2 normal = out + displacement * fraction;
  if (fraction <= 1) keep_earlier({fraction, normal * (1 / normal.length()), 0}, first);
}

/// The disc overlaps the surface from the start: a touch at once if it goes deeper.
void sweep_overlapping(Vector2 displacement, double radius_m, Vector2 out, double distance_m, Contact& first) noexcept {
  const Vector2 normal = distance_m > 0 ? out * (1 / distance_m) : -displacement * (1 / displacement.length());
  if (displacement.dot(normal) < 0) keep_earlier({0, normal, radius_m - distance_m}, first);
}

}  // namespace

void sweep_segment(Vector2 from, Vector2 displacement, double radius_m, Vector2 a, Vector2 b, Contact& first) noexcept {
  const Vector2 out = from - nearest_on_segment(from, a, b);
  const double distance_m = out.length();
  if (distance_m > radius_m + displacement.length()) return;
  if (distance_m < radius_m) return sweep_overlapping(displacement, radius_m, out, distance_m, first);
  const Vector2 along = b - a;
  Vector2 normal = along.left() * (1 / along.length());
  if (normal.dot(from - a) < 0) normal = -normal;
  const double approach = -displacement.dot(normal);
  if (approach > 0) {
    const double height = std::max(normal.dot(from - a) - radius_m, 0.0);  // below 0 by rounding only, or off the ends
    const double fraction = height / approach;
    const double foot = (from + displacement * fraction - a).dot(along);
    if (fraction <= 1 && foot >= 0 && foot <= along.squared()) return keep_earlier({fraction, normal, 0}, first);
  }
  sweep_circle(from, displacement, radius_m, a, first);
  sweep_circle(from, displacement, radius_m, b, first);
}

void sweep_disc(Vector2 from, Vector2 displacement, double radius_m, const Disc& obstacle, Contact& first) noexcept {
  const Vector2 out = from - obstacle.position;
  const double reach_m = radius_m + obstacle.radius_m, distance_m = out.length();
  if (distance_m < reach_m) return sweep_overlapping(displacement, reach_m, out, distance_m, first);
  sweep_circle(from, displacement, reach_m, obstacle.position, first);
}

}  // namespace ganglion::sim
