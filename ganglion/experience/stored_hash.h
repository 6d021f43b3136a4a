#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ganglion/base/hash.h"

namespace ganglion {

/// The checksum of a part's bytes, as SQLite has numbers.
inline std::int64_t stored_hash(std::span<const std::byte> bytes) noexcept {
  return std::bit_cast<std::int64_t>(hash_bytes(bytes));
}

}  // namespace ganglion
