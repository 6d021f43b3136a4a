#pragma once

#include <cstddef>
#include <cstdint>

namespace ganglion {

inline constexpr std::size_t kNormalLanes = 4;

/// Streams side by side, word by word, and what comes of them.
struct NormalLanes {
  alignas(32) std::uint64_t key[2][kNormalLanes];
  alignas(32) std::uint64_t counter[3][kNormalLanes];  ///< All but the first word, which counts the draws.
  alignas(32) double normal[kNormalLanes];
};

/// The first normal of each stream, to the bit as Draws::normal() gives it. Only for processors with AVX2.
void first_normals_avx2(NormalLanes& lanes) noexcept;

}  // namespace ganglion
