#pragma once

#include <filesystem>
#include <string>

#include "ganglion/base/result.h"

namespace ganglion {

/// Finds out what a file is by what stands in it and reports every problem; an experiment is checked with all the files
/// it names. Returns what it was taken for: "experiment", "controller", "robot", "plant", "world",
/// "map".
std::string check_file(const std::filesystem::path& file, Problems& problems);

}  // namespace ganglion
