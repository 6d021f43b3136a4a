#pragma once

#include <string_view>

namespace ganglion {

inline constexpr std::string_view kVersion = "0.1.0";

}  // namespace ganglion
