#pragma once

#include <filesystem>
#include <string>

#include "ganglion/base/result.h"
#include "ganglion/config/value.h"

namespace ganglion {

/// What the keys of a TOML file tell it to be: "experiment", "controller", "robot", "world", "plant", "" = none of them.
std::string kind_of_file(const config::Value& root);

/// Finds out what a file is by what stands in it and reports every problem; an experiment is checked with all the files
/// it names. Returns what it was taken for: "experiment", "controller", "robot", "plant", "world",
/// "map".
std::string check_file(const std::filesystem::path& file, Problems& problems);

}  // namespace ganglion
