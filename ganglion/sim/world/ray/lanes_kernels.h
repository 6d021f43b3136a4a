#pragma once

#include "ganglion/sim/world/ray/lanes.h"

namespace ganglion::sim {

// One of each source file lanes_*.cpp.
extern const Lanes scalar_lanes;
#if defined(__x86_64__)
extern const Lanes sse2_lanes;  // every x86-64 has it
extern const Lanes avx2_lanes;  // to be asked for
#endif

}  // namespace ganglion::sim
