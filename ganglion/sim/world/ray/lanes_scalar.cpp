// One value at a time: what every processor can do, and what the others are held to.
#include "ganglion/sim/world/ray/lanes_kernels.h"

namespace ganglion::sim {
namespace {

double root(double value) noexcept { return __builtin_sqrt(value); }
unsigned signs(bool mask) noexcept { return mask ? 1 : 0; }

}  // namespace
}  // namespace ganglion::sim

#include "ganglion/sim/world/ray/lanes_kernel.h"

namespace ganglion::sim {

extern constinit const Lanes scalar_lanes = lanes_of<double>("scalar");

}  // namespace ganglion::sim
