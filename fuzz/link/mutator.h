#pragma once

#include <cstddef>
#include <cstdint>

#include "fuzz/link/script.h"

namespace ganglion::fuzz {

/// Changes a script in place, most of the time so that every frame in it stays whole: what was changed in a message is
/// framed anew, with its length, stuffing and checksum. Returns the new size, at most `most`.
std::size_t mutate_script(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed,
                          const Dialect& dialect);

}  // namespace ganglion::fuzz
