#include "ganglion/sim/world/ground_terrain.h"

#include <algorithm>

namespace ganglion::sim {

bool GroundTerrain::slopes() const noexcept {
  const auto& zones = ground_->plan().floor.zones;
  return std::any_of(zones.begin(), zones.end(), [](const FloorZone& zone) { return zone.grade > 0; });
}

bool GroundTerrain::way_free(Vector2 from, Vector2 way, double radius_m) const noexcept {
  Contact first;
  ground_->sweep(from, way, radius_m, first);
  return !first.happened();
}

}  // namespace ganglion::sim
