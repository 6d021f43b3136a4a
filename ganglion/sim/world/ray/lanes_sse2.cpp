// Two values side by side: the baseline of x86-64.
#if defined(__x86_64__)
#include <immintrin.h>

#include "ganglion/sim/world/ray/lanes_kernels.h"

namespace ganglion::sim {
namespace {

using Two = double __attribute__((vector_size(16)));
Two root(Two values) noexcept { return _mm_sqrt_pd(values); }
template <class Mask>
unsigned signs(Mask mask) noexcept {
  return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask)));
}

}  // namespace
}  // namespace ganglion::sim

#include "ganglion/sim/world/ray/lanes_kernel.h"

namespace ganglion::sim {

extern constinit const Lanes sse2_lanes = lanes_of<Two>("sse2");

}  // namespace ganglion::sim
#endif
