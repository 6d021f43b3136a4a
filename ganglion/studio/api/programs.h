#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion::studio {

/// A robot's program that the user allows the studio to start.
struct AllowedProgram {
  std::string name;
  std::string help;
  std::vector<std::string> command;  ///< "{port}" becomes the port to listen on.
};

/// $XDG_CONFIG_HOME/ganglion/studio.toml, or ~/.config/...
std::filesystem::path programs_file();

/// [[program]] name, help, command = ["..."]. None where there is no such file; problems are reported.
std::vector<AllowedProgram> read_programs(const std::filesystem::path& file, Problems& problems);

}  // namespace ganglion::studio
