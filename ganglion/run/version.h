#pragma once

#include <string_view>

namespace ganglion {

/// Of the program, "major.minor.patch": what the project() of the top CMakeLists.txt says.
extern const std::string_view kVersion;

}  // namespace ganglion
