#include "ganglion/sim/world/shape/floor.h"

namespace ganglion::sim {

bool FloorZone::contains(Vector2 point) const noexcept {
  if (!box.contains(point)) return false;
  if (!outline.empty()) return outline_contains(outline, point);
  return (point - disc.position).squared() <= disc.radius_m * disc.radius_m;
}

const FloorZone* Floor::zone_at(Vector2 point) const noexcept {
  for (std::size_t n = zones.size(); n-- > 0;) {
    if (zones[n].contains(point)) return &zones[n];
  }
  return nullptr;
}

Colour Floor::colour_at(Vector2 point) const noexcept {
  const FloorZone* zone = zone_at(point);
  return zone != nullptr ? zone->colour : kPlainFloor;
}

Vector2 Floor::gradient_at(Vector2 point) const noexcept {
  const FloorZone* zone = zone_at(point);
  return zone != nullptr ? zone->uphill * zone->grade : Vector2{};
}

double Floor::height_at(Vector2 point) const noexcept {
  const FloorZone* zone = zone_at(point);
  return zone != nullptr ? zone->height_at(point) : 0;
}

double Floor::warmer_C_at(Vector2 point) const noexcept {
  const FloorZone* zone = zone_at(point);
  return zone != nullptr ? zone->warmer_C : 0;
}

bool crosses(const FloorBump& bump, Vector2 before, Vector2 after) noexcept {
  // Each end of the way lies either strictly left of the bump or not, so that no way counts twice and none is missed.
  const Vector2 along = bump.to - bump.from;
  const double side_before = along.cross(before - bump.from), side_after = along.cross(after - bump.from);
  if ((side_before > 0) == (side_after > 0)) return false;
  const double foot =
      along.dot(before - bump.from) + along.dot(after - before) * (side_before / (side_before - side_after));
  return foot >= 0 && foot <= along.squared();
}

}  // namespace ganglion::sim
