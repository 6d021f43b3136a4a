#pragma once

#include "ganglion/sim/world/plan/item_ids.h"
#include "ganglion/sim/world/plan/plan.h"

namespace ganglion::sim {

/// Reads what lies on the ground and what shines or chirps above it: [[floor]], [[bump]], [[beacon]].
void read_floor(config::Table& root, ItemIds& ids, GroundPlan& plan);
void read_beacons(config::Table& root, ItemIds& ids, GroundPlan& plan);

}  // namespace ganglion::sim
