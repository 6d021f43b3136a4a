#pragma once

#include <cstdint>

namespace ganglion::testing {

/// How often this program has taken memory from the heap so far. Only in test programs that call it: linking this file
/// replaces operator new.
std::uint64_t allocations() noexcept;

}  // namespace ganglion::testing
