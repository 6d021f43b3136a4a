#include "ganglion/sim/world/ray/lanes.h"

#include <array>
#include <cstdlib>
#include <string_view>

#include "ganglion/sim/world/ray/lanes_kernels.h"

namespace ganglion::sim {
namespace {

const Lanes& chosen_lanes() noexcept {
  const char* wanted = std::getenv("GANGLION_LANES");
  for (const Lanes* form : available_lanes()) {
    if (wanted != nullptr && std::string_view(wanted) == form->name) return *form;
  }
  return *available_lanes().front();
}

}  // namespace

std::span<const Lanes* const> available_lanes() noexcept {
#if defined(__x86_64__)
  static constexpr std::array<const Lanes*, 3> kAll = {&avx2_lanes, &sse2_lanes, &scalar_lanes};
  return std::span(kAll).subspan(__builtin_cpu_supports("avx2") ? 0 : 1);
#else
  static constexpr std::array<const Lanes*, 1> kAll = {&scalar_lanes};
  return kAll;
#endif
}

const Lanes& lanes() noexcept {
  static const Lanes& chosen = chosen_lanes();
  return chosen;
}

}  // namespace ganglion::sim
