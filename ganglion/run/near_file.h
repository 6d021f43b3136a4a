#pragma once

#include <filesystem>

#include "ganglion/base/result.h"

namespace ganglion {

/// Of a file that a person named and that is not there: with the nearest name beside it, or in a folder of experiments
/// there. Other errors stay as they are.
Error with_nearest(Error error, const std::filesystem::path& wanted);

}  // namespace ganglion
