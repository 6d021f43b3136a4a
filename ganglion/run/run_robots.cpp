#include "ganglion/run/run_robots.h"

#include "ganglion/link/net/lines.h"
#include "ganglion/run/version.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr double kStart_s = 10;  // for a program to listen

std::filesystem::path output_of(std::filesystem::path run_file) { return run_file.replace_extension(".program.log"); }

link::RemoteConfig config_of(const Prepared& prepared, const RunOptions& options) {
  const LinkChoice& choice = prepared.experiment.link;
  const ApplicationModel& model = *prepared.application;
  link::RemoteConfig config;
  config.truth = {{model.truth().begin(), model.truth().end()}, {model.ledgers().begin(), model.ledgers().end()}};
  config.end.name = fmt::format("ganglion {}", kVersion);
  config.end.encoding = choice.json ? link::Encoding::Json : link::Encoding::Binary;
  config.end.pace = choice.free_running ? link::wire::FREE_RUNNING : link::wire::LOCK_STEP;
  config.stop = options.stop;
  return config;
}

}  // namespace

Result<RunRobots> RunRobots::make(const Prepared& prepared, const RunOptions& options) {
  if (prepared.experiment.link.remote() && !options.in_process) return reach(prepared, options);
  auto application = prepared.application->make();
  if (!application) return tl::unexpected<Error>(application.error());
  return make_here(std::move(*application));
}

void RunRobots::name_output(const std::filesystem::path& run_file) {
  if (program_ != nullptr) program_->name_output(output_of(run_file));
}

Result<RunRobots> RunRobots::make_here(std::unique_ptr<Application> application) {
  RunRobots robots;
  robots.application_ = std::move(application);
  return robots;
}

Result<RunRobots> RunRobots::reach(const Prepared& prepared, const RunOptions& options) {
  const LinkChoice& choice = prepared.experiment.link;
  RunRobots robots;
  link::RemoteConfig config = config_of(prepared, options);
  std::string address = choice.address;
  if (!choice.program.empty()) {
    const auto port = link::free_port();
    if (!port) return tl::unexpected<Error>(port.error());
    auto program = link::Program::start(
        choice.program, prepared.experiment.files.experiment.parent_path(), *port,
        output_of(options.run_file.empty() ? fs::temp_directory_path() / "ganglion" : options.run_file));
    if (!program) return tl::unexpected<Error>(program.error());
    robots.program_ = std::make_unique<link::Program>(std::move(*program));
    config.reach_s = kStart_s;
    config.stop = [stop = options.stop, started = robots.program_.get()] {
      return (stop && stop()) || started->ended();
    };
    address = fmt::format("tcp://127.0.0.1:{}", *port);
  }
  const auto parsed = link::parse_address(address);
  if (!parsed) return tl::unexpected<Error>(parsed.error());
  auto remote = link::RemoteApplication::connect(link::make_line(*parsed), prepared.application->description(),
                                                 prepared.experiment.robots, config);
  if (!remote && robots.program_ != nullptr) {
    const Text state = robots.program_->ended() ? Text{"ended", "terminó"} : Text{"runs", "sigue"};
    return fail(
        ErrorCode::LinkLost,
        {"{} {} and last said: {} (all of it is in {}); {}", "{} {} y lo último que dijo es: {} (todo está en {}); {}"},
        choice.program.front(), state, robots.program_->last_words(), robots.program_->output().string(),
        remote.error().what);
  }
  if (!remote) return tl::unexpected<Error>(remote.error());
  robots.remote_ = remote->get();
  robots.application_ = std::move(*remote);
  robots.free_running_ = choice.free_running;
  return robots;
}

}  // namespace ganglion
