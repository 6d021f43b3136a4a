#include "commands.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/run/check_file.h"
#include "say.h"

namespace ganglion {

void add_check(CLI::App& program, int& code) {
  auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      program.add_subcommand("check", "Find every mistake in experiment, controller, robot, world files");
  command->add_option("files", *files, "TOML or map files; a folder stands for its experiment.toml")->required();
  command->footer("Example:\n  ganglion check experiments/nimrod experiments/nimrod/controller.listing.toml");
  command->callback([files, &code] {
    Problems problems;
    for (const std::string& file : *files) {
      const auto before = problems.size();
      const std::string what = check_file(file, problems);
      if (problems.size() == before) fmt::print("{}: {}, no problems\n", file, what);
    }
    if (!problems.empty()) code = complain(problems);
  });
}

}  // namespace ganglion
