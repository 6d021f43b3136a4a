#include <cstdio>

#include "commands.h"
#include "ganglion/link/net/lines.h"
#include "ganglion/link/net/server.h"
#include "ganglion/run/bounds.h"
#include "ganglion/run/run_robots.h"
#include "ganglion/run/version.h"
#include "ganglion/sim/application/simulated_robots.h"
#include "interrupt.h"
#include "overrides.h"
#include "reachable.h"
#include "say.h"

namespace ganglion {
namespace {

struct SimArguments {
  std::string experiment;
  std::vector<std::string> set;
  std::string listen = "127.0.0.1:7007";
  std::uint64_t seed = 0;
  bool has_seed = false;
  bool once = false;
  bool quiet = false;
};

constexpr int kMostSubsteps = 1000;  // between two looks at everybody else

link::RobotEndConfig config_of(const Prepared& prepared, const SimArguments& arguments) {
  link::RobotEndConfig config;
  config.clock = link::steady_s;
  if (const auto* robots = dynamic_cast<const sim::RobotsModel*>(prepared.application.get())) {
    config.longest_step_s = kMostSubsteps * robots->substep_s();
  }
  config.name = fmt::format("ganglion {}", kVersion);
  config.token = link::random_token;
  if (!arguments.quiet) config.log = note;
  return config;
}

int serve(const Prepared& prepared, const SimArguments& arguments) {
  auto robots = prepared.application->make();
  if (!robots) return complain(robots.error());
  const std::uint64_t seed = arguments.has_seed ? arguments.seed : prepared.experiment.seed;
  if (auto reset = (*robots)->reset(seed, 0); !reset) return complain(reset.error());
  const auto address = link::parse_address(arguments.listen);
  if (!address) return complain(address.error());
  link::RobotEnd end(**robots, config_of(prepared, arguments));
  auto server = link::Server::listen(end, *address);
  if (!server) return complain(server.error());
  catch_interrupts();
  tell({"{} ({} robot{}) listens at {}; end it with ctrl-C", "{} ({} robot{}) escucha en {}; termínelo con ctrl-C"},
       prepared.application->description().name, prepared.experiment.robots, prepared.experiment.robots == 1 ? "" : "s",
       (*server)->address().text);
  note_who_reaches((*server)->address());
  std::fflush(stdout);
  (*server)->serve([&] { return interrupted() || (arguments.once && end.sessions_ended() > 0); },
                   say({"the simulation was ended", "se terminó la simulación"}));
  return kDone;
}

int sim_command(const SimArguments& arguments) {
  Problems problems;
  const auto overrides = overrides_of(arguments.set, problems);
  if (!problems.empty()) return complain(problems);
  const auto prepared = prepare(arguments.experiment, overrides, problems);
  if (!prepared) return complain(problems);
  check_frames(*prepared, problems);
  if (!problems.empty()) return complain(problems);
  return serve(*prepared, arguments);
}

}  // namespace

void add_sim(CLI::App& program, int& code) {
  auto arguments = std::make_shared<SimArguments>();
  CLI::App* command = program.add_subcommand("sim", "Simulate an experiment's robots for a controller elsewhere");
  command->add_option("experiment", arguments->experiment, "Folder or experiment.toml")->required();
  command->add_option("--set", arguments->set, "key=value: changes a key of the files the experiment names")
      ->allow_extra_args(false);
  command
      ->add_option("--listen", arguments->listen,
                   "HOST:PORT, port 0 takes a free one; or serial:///dev/ttyUSB0?baud=115200")
      ->capture_default_str();
  auto* seed = command->add_option("--seed", arguments->seed,
                                   "Seed until a controller resets it; default: the "
                                   "experiment's");
  command->add_flag("--once", arguments->once, "End when the first controller has said goodbye");
  command->add_flag("--quiet", arguments->quiet, "Say nothing of who comes and goes");
  command->footer(
      "Whoever can reach the address can drive the robots: keep to 127.0.0.1 unless you trust the network.\n"
      "Examples:\n"
      "  ganglion sim experiments/nimrod\n"
      "  ganglion run experiments/nimrod --robot tcp://127.0.0.1:7007      (in another terminal)\n"
      "Exit codes: 0 ended, 2 bad input, 3 the address cannot be used.");
  command->callback([arguments, seed, &code] {
    arguments->has_seed = seed->count() > 0;
    code = sim_command(*arguments);
  });
}

}  // namespace ganglion
