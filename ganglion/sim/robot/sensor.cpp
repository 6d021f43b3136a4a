#include "ganglion/sim/robot/sensor.h"

#include <cmath>

namespace ganglion::sim {
namespace {

/// The nearer crossing of a ray with a disc, seen from outside; from inside nothing is seen.
std::optional<double> disc_range_m(const Disc& disc, Vector2 from, Vector2 unit_direction) noexcept {
  const Vector2 to_centre = disc.position - from;
  const double along_m = to_centre.dot(unit_direction);
  const double outside = to_centre.squared() - disc.radius_m * disc.radius_m;
  if (along_m <= 0 || outside <= 0) return std::nullopt;
  const double inside = along_m * along_m - outside;
  if (inside < 0) return std::nullopt;
  return along_m - std::sqrt(inside);
}

}  // namespace

std::optional<Hit> cast(const Scene& scene, Vector2 from, Vector2 unit_direction, double max_range_m) noexcept {
  std::optional<Hit> nearest = scene.world.cast(from, unit_direction, max_range_m);
  for (const Disc& other : scene.others) {
    const auto range_m = disc_range_m(other, from, unit_direction);
    if (!range_m || *range_m > (nearest ? nearest->range_m : max_range_m)) continue;
    const Vector2 outwards = from + unit_direction * *range_m - other.position;
    nearest = Hit{*range_m, outwards * (1 / other.radius_m), Material::Rough};
  }
  return nearest;
}

}  // namespace ganglion::sim
