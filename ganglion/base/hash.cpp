#include "ganglion/base/hash.h"

#include <algorithm>

namespace ganglion {

std::uint64_t hash_bytes(std::span<const std::byte> bytes) noexcept {
  std::uint64_t hash = mix(bytes.size());
  for (std::size_t start = 0; start < bytes.size(); start += 8) {
    std::uint64_t word = 0;
    const std::size_t count = std::min<std::size_t>(8, bytes.size() - start);
    for (std::size_t i = 0; i < count; ++i) word |= std::to_integer<std::uint64_t>(bytes[start + i]) << (8 * i);
    hash = combine(hash, word);
  }
  return hash;
}

}  // namespace ganglion
