#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

std::optional<Hit> cast(const Scene& scene, Vector2 from, Vector2 unit_direction, double max_range_m) noexcept {
  const Ray ray{from, unit_direction};
  if (scene.sight != nullptr && scene.sight->covers(from, max_range_m)) {
    const Hit hit = scene.sight->cast(ray, max_range_m);
    return hit.range_m < kNoHit ? std::optional(hit) : std::nullopt;
  }
  std::optional<Hit> nearest = scene.world.cast(from, unit_direction, max_range_m);
  for (const Disc& other : scene.others) {
    const double range_m = range_to_disc(ray, other);
    if (!(nearest ? range_m < nearest->range_m : range_m <= max_range_m && range_m < kNoHit)) continue;
    const Vector2 outwards = from + unit_direction * range_m - other.position;
    nearest = Hit{range_m, outwards * (1 / other.radius_m), Material::Rough};
  }
  return nearest;
}

Hit cast_own(const Scene& scene, Vector2 ray, double reach_m) noexcept {
  const Vector2 along = scene.ahead() * ray.x + scene.ahead().left() * ray.y;
  return cast(scene, scene.mount().position, along, reach_m).value_or(Hit{kNoHit, {}, Material::Rough});
}

}  // namespace ganglion::sim
