#pragma once

#include <cstdint>

namespace ganglion::testing {

/// Allocations from the heap by this program so far. Whoever links this gets operator new replaced by one that counts,
/// so a test can hold that a stretch of code allocates nothing: equal before and after.
std::uint64_t allocations() noexcept;

}  // namespace ganglion::testing
