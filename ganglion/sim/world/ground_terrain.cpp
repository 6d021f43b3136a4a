#include "ganglion/sim/world/ground_terrain.h"

#include <algorithm>

namespace ganglion::sim {

bool GroundTerrain::slopes() const noexcept {
  const auto& zones = ground_->plan().floor.zones;
  return std::any_of(zones.begin(), zones.end(), [](const FloorZone& zone) { return zone.grade > 0; });
}

}  // namespace ganglion::sim
