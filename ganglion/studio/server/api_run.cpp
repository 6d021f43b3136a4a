#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "ganglion/studio/server/api.h"

namespace ganglion::studio {
namespace {

namespace fs = std::filesystem;

std::string stamp() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  return fmt::format("{:04}{:02}{:02}_{:02}{:02}{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday,
                     parts.tm_hour, parts.tm_min, parts.tm_sec);
}

/// Letters and digits of a name, for a folder.
std::string plain(const std::string& name) {
  std::string result;
  for (const char c : name.substr(0, 60)) {
    const bool good = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    result += good ? c : '_';
  }
  return result.empty() ? "run" : result;
}

}  // namespace

Json Api::state() const {
  if (!attached_.is_null()) return attached_;
  return session_ ? session_->state() : Json{{"state", "idle"}};
}

Reply Api::run_state(const Ask&) { return json_reply(state()); }

void Api::tell_state() {
  hooks_.on_hub([state = state()](Hub& hub) mutable { hub.set_state(std::move(state)); });
}

std::optional<Reply> Api::refuse_command(const Ask& ask) const {
  if (attached_.is_null()) return std::nullopt;
  return ask.refuse("Forbidden", "this run belongs to the command line; it can only be watched", 403);
}

Result<RunPlan> Api::plan_of(const Ask& ask, const Prepared& prepared) {
  RunPlan plan;
  plan.experiment = ask.text("experiment");
  const Json controller = ask.body.value("controller", Json());
  plan.controller =
      controller.is_object() ? controller.value("path", "") : folder_.name_of(prepared.experiment.files.controller);
  const double seed = ask.number("seed", static_cast<double>(prepared.experiment.seed));
  if (!(seed >= 0 && seed <= 9e15 && seed == std::floor(seed))) {
    return fail(ErrorCode::BadParameter, "seed is {}, must be a whole number from 0 on", seed);
  }
  plan.seed = static_cast<std::uint64_t>(seed);
  plan.pace = ask.number("pace", 1);
  if (!(plan.pace >= 0 && plan.pace <= 1e6))
    return fail(ErrorCode::BadParameter, "pace is {}, must be >= 0", plan.pace);
  if (prepared.experiment.link.free_running) plan.pace = 0;  // the robot keeps the time
  plan.paused = ask.has("paused") && ask.body["paused"] == Json(true);
  if (ask.has("record") && ask.body["record"] == Json(false)) return plan;
  const std::string stem = fmt::format("{}_seed_{:04}", stamp(), plan.seed);
  const fs::path folder = fs::path("runs") / plain(prepared.experiment.name);
  fs::path name = folder / (stem + ".mcap");
  std::error_code error;
  for (int i = 2; fs::exists(folder_.root() / name, error); ++i) name = folder / fmt::format("{}_{}.mcap", stem, i);
  if (!folder_.holds(folder_.root() / name)) return fail(ErrorCode::NotFound, "the folder runs leads elsewhere");
  plan.run_file = folder_.root() / name;
  plan.run_name = name.generic_string();
  return plan;
}

void Api::begin(std::shared_ptr<const Prepared> prepared, RunPlan plan) {
  prepared_ = std::move(prepared);
  session_.reset();
  const auto changed = [later = hooks_.later] { later([](Api& api) { api.tell_state(); }); };
  session_ = std::make_unique<RunSession>(std::to_string(++runs_), prepared_, std::move(plan), changed);
  hooks_.on_hub([feed = session_->feed()](Hub& hub) { hub.watch(feed); });
  tell_state();
}

Reply Api::answer(const Ask& ask, bool done) {
  if (!done) return ask.refuse("NotRunning", "no run is on", 409);
  return json_reply({{"state", state()}});
}

Reply Api::pause_run(const Ask& ask) {
  if (auto refused = refuse_command(ask)) return *refused;
  return answer(ask, session_ && session_->pause());
}

Reply Api::resume_run(const Ask& ask) {
  if (auto refused = refuse_command(ask)) return *refused;
  return answer(ask, session_ && session_->resume());
}

Reply Api::step_run(const Ask& ask) {
  if (auto refused = refuse_command(ask)) return *refused;
  const double ticks = std::clamp(ask.number("ticks", 1), 1.0, 1e6);
  return answer(ask, session_ && session_->step(static_cast<std::uint32_t>(ticks)));
}

Reply Api::stop_run(const Ask& ask) {
  if (auto refused = refuse_command(ask)) return *refused;
  return answer(ask, session_ && session_->stop());
}

Reply Api::pace_run(const Ask& ask) {
  if (auto refused = refuse_command(ask)) return *refused;
  const double pace = ask.number("pace", -1);
  if (!(pace >= 0 && pace <= 1e6))
    return ask.refuse("BadParameter", "pace must be a number >= 0; 0 = as fast as can be", 400);
  if (session_) session_->set_pace(pace);
  return answer(ask, session_ != nullptr);
}

/// The same run from the start, in a new file.
Reply Api::reset_run(const Ask& ask) {
  if (auto refused = refuse_command(ask)) return *refused;
  if (!session_) return answer(ask, false);
  RunPlan plan = session_->plan();
  session_.reset();  // stops it and waits for its end
  if (!plan.run_file.empty()) {
    const std::string stem = fmt::format("{}_seed_{:04}_{}", stamp(), plan.seed, runs_ + 1);
    plan.run_file.replace_filename(stem + ".mcap");
    plan.run_name = folder_.name_of(plan.run_file);
  }
  if (plan.drawn) {
    if (const auto written = plan.drawn->write(); !written) return failure(written.error(), ask.language);
  }
  begin(prepared_, std::move(plan));
  return json_reply({{"run", std::to_string(runs_)}, {"state", state()}});
}

}  // namespace ganglion::studio
