#include "ganglion/studio/api/programs.h"

#include <cstdlib>

#include "ganglion/config/table.h"

namespace ganglion::studio {

std::filesystem::path programs_file() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  if (config != nullptr && *config == '/') return std::filesystem::path(config) / "ganglion/studio.toml";
  return home != nullptr && *home == '/' ? std::filesystem::path(home) / ".config/ganglion/studio.toml"
                                         : std::filesystem::path();
}

std::vector<AllowedProgram> read_programs(const std::filesystem::path& file, Problems& problems) {
  std::vector<AllowedProgram> programs;
  std::error_code error;
  if (file.empty() || !std::filesystem::exists(file, error)) return programs;
  const auto value = config::load(file);
  if (!value) {
    problems.add(value.error());
    return programs;
  }
  config::Table root(*value, "", problems);
  config::check_format(root);
  for (config::Table& table : root.tables("program")) {
    AllowedProgram program{table.text("name"), table.text("help", ""), table.texts("command")};
    if (program.command.empty()) {
      table.problem("command", ErrorCode::MissingKey,
                    {"command is missing: a list of the program and its arguments",
                     "falta command: una lista con el programa y sus argumentos"});
    } else {
      programs.push_back(std::move(program));
    }
  }
  return programs;
}

}  // namespace ganglion::studio
