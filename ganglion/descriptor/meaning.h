#pragma once

#include <cstdint>

namespace ganglion {

/// What an output means to whoever judges a run: declared, never guessed from its name.
enum class Meaning : std::uint8_t {
  None,
  StandsOnPurpose,  ///< While it is 1 the robot stands because its module wants it to.
  Share,            ///< Of a coordinator: the part of a candidate in what is done.
};

}  // namespace ganglion
