#include "commands.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/run/check_file.h"
#include "say.h"

namespace ganglion {
namespace {

/// What check_file() took a file for, in words.
Text type_in_words(std::string_view type) noexcept {
  if (type == "experiment") return {"experiment", "experimento"};
  if (type == "controller") return {"controller", "controlador"};
  if (type == "robot") return {"robot", "robot"};
  if (type == "plant") return {"plant", "planta"};
  if (type == "world") return {"world", "mundo"};
  return {"map", "mapa"};
}

}  // namespace

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
      if (problems.size() == before) tell({"{}: {}, no problems", "{}: {}, sin problemas"}, file, type_in_words(what));
    }
    for (const Problems::Note& one : problems.notes()) note(one.text());
    if (!problems.empty()) code = complain(problems);
  });
}

}  // namespace ganglion
