// Stands for studio/ in a program that was built without it: quicker to build, and without Node.
#include "commands.h"
#include "say.h"
#include "watched_run.h"

namespace ganglion {
namespace {

Error missing() {
  return {ErrorCode::Unsupported,
          say({"this program was built without the studio; \"./dev studio\" builds it in and opens it",
               "este programa se compiló sin el estudio; \"./dev studio\" lo incluye y lo abre"})};
}

}  // namespace

void add_studio(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand("studio", "Not in this program: ./dev studio builds it in");
  command->allow_extras();
  command->callback([&code] { code = complain(missing()); });
}

Result<std::unique_ptr<WatchedRun>> WatchedRun::open(const Prepared&, const lab::Job&, lab::Hooks&) {
  return tl::unexpected<Error>(missing());
}

}  // namespace ganglion
