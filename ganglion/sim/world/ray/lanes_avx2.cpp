// Four values side by side: AVX2.
#if defined(__x86_64__)
#include <immintrin.h>

#include "ganglion/sim/world/ray/lanes_kernels.h"

namespace ganglion::sim {
namespace {

using Four = double __attribute__((vector_size(32)));
Four root(Four values) noexcept { return _mm256_sqrt_pd(values); }
template <class Mask>
unsigned signs(Mask mask) noexcept {
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask)));
}

}  // namespace
}  // namespace ganglion::sim

#include "ganglion/sim/world/ray/lanes_kernel.h"

namespace ganglion::sim {

extern constinit const Lanes avx2_lanes = lanes_of<Four>("avx2");

}  // namespace ganglion::sim
#endif
