#include "commands.h"
#include "ganglion/plot/draw_all.h"
#include "ganglion/plot/from_run_file.h"
#include "ganglion/plot/pictures/pictures.h"
#include "ganglion/record/run_file.h"
#include "language.h"
#include "say.h"

namespace ganglion {

void add_plot(CLI::App& program, int& code) {
  struct PlotArguments {
    std::string file, out;
    std::vector<std::string> pictures;
  };
  auto arguments = std::make_shared<PlotArguments>();
  CLI::App* command = program.add_subcommand("plot", "Draw the pictures of a recorded run, as SVG, PNG and PDF");
  command->add_option("file", arguments->file, "Run file (.mcap)")->required();
  command->add_option("--out", arguments->out, "Folder to write to")->required();
  std::vector<std::string> names;
  for (const plot::PictureKind* kind : plot::picture_kinds()) names.emplace_back(kind->descriptor.name);
  command->add_option("--picture", arguments->pictures, "Only the pictures of that kind; may be given several times")
      ->check(CLI::IsMember(names));
  command->footer("Example:\n  ganglion plot runs/nimrod/seed_0001.mcap --out pictures");
  command->callback([arguments, &code] {
    const auto run = RunFile::read(arguments->file, Recover::Yes);
    if (!run) {
      code = complain(run.error());
      return;
    }
    const plot::RunView view = plot::from_run_file(*run);
    const auto files = plot::draw_all(view, arguments->out, language(), arguments->pictures);
    if (!files) {
      complain(files.error());
      code = kOutputFailed;
      return;
    }
    for (const auto& file : *files) tell({"wrote {}", "escrito {}"}, file.string());
  });
}

}  // namespace ganglion
