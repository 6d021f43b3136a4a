#include "watched_run.h"

#include <chrono>
#include <thread>

#include "ganglion/studio/api/programs.h"
#include "ganglion/studio/live/run_session.h"
#include "interrupt.h"
#include "say.h"
#include "studio/studio.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr double kTellEvery_s = 0.5;  // of wall time

fs::path folder_of(const fs::path& experiment) {
  return fs::is_directory(experiment) ? experiment : fs::absolute(experiment).parent_path();
}

class ServedRun final : public WatchedRun {
 public:
  ServedRun(std::unique_ptr<studio::Server> server, studio::Json state)
      : server_(std::move(server)), state_(std::move(state)) {}

  /// Has the hooks tell the server of the run.
  void follow(lab::Hooks& hooks);
  void serve_until_interrupted() const override;

 private:
  void tell(std::string_view phase, double share);
  void conclude(const RunResult& result);

  std::unique_ptr<studio::Server> server_;
  std::shared_ptr<studio::LiveFeed> feed_ = std::make_shared<studio::LiveFeed>();
  studio::Json state_;
  double told_s_ = 0;
};

void ServedRun::follow(lab::Hooks& hooks) {
  RunOptions& options = hooks.run;
  options.watcher = feed_.get();
  options.armed = [this] {
    feed_->arm();
    tell("running", 0);
    return true;
  };
  options.progress = [this, before = options.progress](double share) {
    if (wall_s() - told_s_ > kTellEvery_s) tell("running", share);
    return !before || before(share);
  };
  hooks.ended = [this](const Result<RunResult>& result) {
    if (result) conclude(*result);
  };
  server_->attach(feed_, state_);
  tell("preparing", 0);
  announce_studio(*server_, true);
}

void ServedRun::tell(std::string_view phase, double share) {
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

void ServedRun::conclude(const RunResult& result) {
  while (!feed_->flush()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  state_["outcome"] = studio::outcome_json(lab::outcome_of({}, result), "");
  tell("done", state_.value("share", 1.0));
}

void ServedRun::serve_until_interrupted() const {
  note(say({"The run is over; the studio goes on showing it until ctrl-C: {}",
            "La ejecución terminó; el estudio la sigue mostrando hasta ctrl-C: {}"},
           server_->url()));
  while (!interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

}  // namespace

Result<std::unique_ptr<WatchedRun>> WatchedRun::open(const Prepared& prepared, const lab::Job& job, lab::Hooks& hooks) {
  const fs::path folder = folder_of(job.experiment);
  auto server = studio::Server::start({.folder = folder, .programs = studio::programs_file()});
  if (!server) return tl::unexpected<Error>(server.error());
  std::error_code error;
  const studio::Json state = {
      {"run", "1"},
      {"experiment", prepared.experiment.files.experiment.filename().string()},
      {"controller", fs::relative(prepared.experiment.files.controller, folder, error).generic_string()},
      {"name", prepared.experiment.name},
      {"seed", job.seed},
      {"pace", hooks.run.pace},
      {"duration_s", prepared.experiment.duration_s},
      {"outcome", nullptr}};
  auto served = std::make_unique<ServedRun>(std::move(*server), state);
  served->follow(hooks);
  return served;
}

}  // namespace ganglion
