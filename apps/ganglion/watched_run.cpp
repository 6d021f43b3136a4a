#include "watched_run.h"

#include <thread>

#include "ganglion/studio/live/run_session.h"
#include "ganglion/studio/api/programs.h"
#include "interrupt.h"
#include "say.h"
#include "studio.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr double kTellEvery_s = 0.5;  // of wall time

fs::path folder_of(const fs::path& experiment) {
  return fs::is_directory(experiment) ? experiment : fs::absolute(experiment).parent_path();
}

}  // namespace

Result<std::unique_ptr<WatchedRun>> WatchedRun::open(const fs::path& experiment, const Prepared& prepared,
                                                     RunOptions& options) {
  auto server = studio::Server::start({.folder = folder_of(experiment), .programs = studio::programs_file()});
  if (!server) return tl::unexpected<Error>(server.error());
  std::error_code error;
  const studio::Json state = {
      {"run", "1"},
      {"experiment", prepared.experiment.files.experiment.filename().string()},
      {"controller", fs::relative(prepared.experiment.files.controller, folder_of(experiment), error).generic_string()},
      {"name", prepared.experiment.name},
      {"seed", options.seed},
      {"pace", options.pace},
      {"duration_s", prepared.experiment.duration_s},
      {"outcome", nullptr}};
  std::unique_ptr<WatchedRun> watched(new WatchedRun(std::move(*server), state));
  options.watcher = watched->feed_.get();
  options.armed = [run = watched.get()] {
    run->feed_->arm();
    run->tell("running", 0);
    return true;
  };
  options.progress = [run = watched.get(), before = options.progress](double share) {
    if (wall_s() - run->told_s_ > kTellEvery_s) run->tell("running", share);
    return !before || before(share);
  };
  watched->server_->attach(watched->feed_, watched->state_);
  watched->tell("preparing", 0);
  announce_studio(*watched->server_, true);
  return watched;
}

void WatchedRun::tell(std::string_view phase, double share) {
  const double now_s = wall_s();
  const double duration_s = state_["duration_s"];
  const double before_s = state_.value("time_s", 0.0);
  state_["state"] = phase;
  state_["speed"] = now_s > told_s_ && share > 0 ? (share * duration_s - before_s) / (now_s - told_s_) : 0.0;
  state_["time_s"] = share * duration_s;
  state_["share"] = share;
  told_s_ = now_s;
  server_->tell_attached(state_);
}

void WatchedRun::conclude(const RunResult& result) {
  while (!feed_->flush()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  state_["outcome"] = studio::outcome_json(result, "");
  tell("done", state_.value("share", 1.0));
}

void WatchedRun::serve_until_interrupted() const {
  fmt::print(stderr, "The run is over; the studio goes on showing it until ctrl-C: {}\n", server_->url());
  while (!interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

}  // namespace ganglion
