#pragma once

#include <array>
#include <string_view>

namespace ganglion::studio {

/// The lists in which a controller's file holds its components, named after their classes, in the order in which they
/// stand there.
inline constexpr std::array<std::string_view, 5> kComponentLists = {"sensation", "sensing", "goal", "acting",
                                                                    "coordinator"};

}  // namespace ganglion::studio
