#pragma once

#include <source_location>

namespace ganglion {

/// Stops the program with file and line: a promise between our own functions was broken. Never for input from outside.
[[noreturn]] void broken_promise(std::source_location where) noexcept;

/// Precondition of one of our own functions.
constexpr void expects(bool promise, std::source_location where = std::source_location::current()) noexcept {
  if (!promise) [[unlikely]]
    broken_promise(where);
}

}  // namespace ganglion
