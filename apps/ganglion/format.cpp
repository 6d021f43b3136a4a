#include <cstdio>

#include "commands.h"
#include "ganglion/base/file.h"
#include "ganglion/config/format.h"
#include "say.h"

namespace ganglion {
namespace {

int format_file(const std::string& file, bool check) {
  const auto text = read_file(file);
  if (!text) return complain(text.error());
  const auto formatted = config::format(*text, file);
  if (!formatted) return complain(formatted.error());
  if (*formatted == *text) return kDone;
  if (check) {
    tell({"{}: not in the common layout; run ganglion format {}",
          "{}: no tiene la presentación común; ejecute ganglion format {}"},
         file, file);
    return kRobotFailed;
  }
  if (const auto written = write_file(file, *formatted); !written) {
    complain(written.error());
    return kOutputFailed;
  }
  tell({"{}: laid out anew", "{}: presentado de nuevo"}, file);
  return kDone;
}

}  // namespace

void add_format(CLI::App& program, int& code) {
  struct FormatArguments {
    std::vector<std::string> files;
    bool check = false;
  };
  auto arguments = std::make_shared<FormatArguments>();
  CLI::App* command = program.add_subcommand("format", "Bring files into the common layout; comments are kept");
  command->add_option("files", arguments->files, "TOML files")->required();
  command->add_flag("--check", arguments->check, "Change nothing; exit 1 where something would change");
  command->footer(
      "Examples:\n"
      "  ganglion format experiments/nimrod/controller.toml\n"
      "  ganglion format --check experiments/nimrod/*.toml\n"
      "Exit codes: 0 done, 1 with --check: a file would change, 2 bad input, 4 a file cannot be written.");
  command->callback([arguments, &code] {
    for (const std::string& file : arguments->files) code = std::max(code, format_file(file, arguments->check));
  });
}

}  // namespace ganglion
