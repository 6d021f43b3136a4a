#pragma once

#include "ganglion/base/result.h"

namespace ganglion {

/// What the exception that is being handled means for a person: memory, threads or descriptors that the system denies
/// (TooLarge), or a fault of the program (Unsupported). Only within a catch block.
Error denied();

}  // namespace ganglion
