#include "ganglion/studio/live/run_session.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/denied.h"

namespace ganglion::studio {
namespace {

constexpr auto kMeasure = std::chrono::milliseconds(500);
constexpr auto kInTouch = std::chrono::milliseconds(500);  // with robots that are elsewhere
constexpr auto kPatience = std::chrono::seconds(5);        // for a tick to end
constexpr std::size_t kMostWishes = 16;

Json numbers(const std::vector<std::pair<std::string, double>>& measures) {
  Json json = Json::object();
  for (const auto& [name, value] : measures) json[name] = std::isfinite(value) ? Json(value) : Json();
  return json;
}

/// {"error": ..., "error_es": ...}
void tell_error(Json& outcome, const Error& error) {
  outcome["error"] = error.text();
  outcome["error_es"] = error.text(Language::Spanish);
}

}  // namespace

Json outcome_json(const lab::Outcome& outcome, const std::string& file) {
  const bool judged = outcome.verdict != ganglion::Verdict::NotJudged;
  Json json = {{"success", judged ? Json(outcome.verdict == ganglion::Verdict::Succeeded) : Json()},
               {"reason", outcome.reason.en},
               {"reason_es", outcome.reason.es},
               {"digest", outcome.digest},
               {"interventions", outcome.interventions},
               {"measures", numbers(outcome.figures)},
               {"file", file},
               {"error", nullptr}};
  if (const Error* error = outcome.trouble(lab::Trouble::Of::Files)) tell_error(json, *error);
  return json;
}

RunSession::RunSession(std::string id, std::shared_ptr<const Prepared> prepared, RunPlan plan,
                       std::function<void()> changed)
    : id_(std::move(id)), prepared_(std::move(prepared)), plan_(std::move(plan)), changed_(std::move(changed)) {
  paused_ = plan_.paused;
  thread_ = std::thread([this] { carry_out(); });
}

RunSession::~RunSession() {
  stop();
  thread_.join();
}

template <class Change>
bool RunSession::change(Change&& what) {
  {
    const std::lock_guard lock(mutex_);
    if (phase_ == "done") return false;
    what();
    due_ = Clock::now();
  }
  wake_.notify_all();
  changed_();
  return true;
}

bool RunSession::pause() {
  return change([this] { paused_ = true, steps_ = 0; });
}
bool RunSession::resume() {
  return change([this] { paused_ = false; });
}
bool RunSession::step(std::uint32_t ticks) {
  return change([&] { paused_ = true, steps_ += ticks; });
}
void RunSession::set_pace(double pace) {
  if (change([&] { plan_.pace = pace; })) return;
  plan_.pace = pace;  // its thread is done with it
  changed_();
}
bool RunSession::stop() {
  return change([this] { stop_ = true; });
}

bool RunSession::over() const {
  const std::lock_guard lock(mutex_);
  return phase_ == "done";
}

std::optional<Result<Intervened>> RunSession::intervene(const Intervention& what) {
  if (prepared_->experiment.link.remote()) {
    return fail(ErrorCode::Unsupported,
                {"the robots are at the other end of a link; goals and obstacles can only be set in a world that is "
                 "simulated here",
                 "los robots están al otro extremo de un enlace; solo se pueden fijar objetivos y obstáculos en un "
                 "mundo simulado aquí"});
  }
  Wish wish{&what, std::nullopt};
  std::unique_lock lock(mutex_);
  if (!reachable_) return std::nullopt;
  if (wishes_.size() >= kMostWishes) {
    return fail(ErrorCode::TooLarge, {"{} others wait to be done", "hay otras {} en espera"}, wishes_.size());
  }
  wishes_.push_back(&wish);
  wake_.notify_all();
  const auto answered = [&] { return wish.answer.has_value() || wish.too_late; };
  if (!answered_.wait_for(lock, kPatience, answered)) {
    if (std::erase(wishes_, &wish) > 0) {
      return fail(ErrorCode::BadParameter, {"the present tick takes too long; nothing was done",
                                            "el ciclo actual tarda demasiado; no se hizo nada"});
    }
    answered_.wait(lock, answered);  // it is being done
  }
  return wish.answer;
}

/// Between ticks: does what others wait for.
void RunSession::grant(std::unique_lock<std::mutex>& lock) {
  while (!wishes_.empty()) {
    Wish& wish = *wishes_.front();
    wishes_.pop_front();
    lock.unlock();
    auto answer = reach_(*wish.what);
    lock.lock();
    wish.answer = std::move(answer);
    answered_.notify_all();
  }
}

void RunSession::refuse_wishes() {
  const std::lock_guard lock(mutex_);
  reachable_ = false;
  for (Wish* wish : wishes_) wish->too_late = true;
  wishes_.clear();
  answered_.notify_all();
}

void RunSession::carry_out() {
  lab::Hooks hooks;
  RunOptions& options = hooks.run;
  options.watcher = feed_.get();
  options.progress = [this](double share) { return between_ticks(share); };
  options.stop = [this] {
    const std::lock_guard lock(mutex_);
    return stop_;
  };
  options.reach = [this](Reach reach) { reach_ = std::move(reach); };
  options.in_touch = [this](std::function<void()> in_touch) { in_touch_ = std::move(in_touch); };
  options.armed = [this] {
    feed_->arm();
    std::unique_lock lock(mutex_);
    phase_ = "armed";
    reachable_ = true;
    changed_();
    due_ = measured_at_ = Clock::now();
    const bool begins = wait(lock);
    phase_ = "running";
    changed_();
    return begins;
  };
  hooks.ended = [this](const Result<RunResult>&) {
    refuse_wishes();
    while (!feed_->flush()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  const lab::Job job{
      .experiment = plan_.experiment, .overrides = prepared_->experiment.overrides, .seed = plan_.seed, .faults = {}};
  lab::Keep keep;
  keep.run_file = plan_.run_file;
  keep.language = plan_.language;
  try {
    conclude(lab::carry_out(*prepared_, job, keep, hooks));
  } catch (...) {  // memory, say: the run is lost, not the server
    refuse_wishes();
    conclude(tl::unexpected(denied()));
  }
}

/// Waits for a command, at most until then. Whoever waits long stays in touch with robots that are elsewhere.
void RunSession::hold(std::unique_lock<std::mutex>& lock, Clock::time_point until) {
  const auto next_touch = touched_ + kInTouch;
  if (Clock::now() < next_touch) {
    wake_.wait_until(lock, std::min(until, next_touch));
    return;
  }
  touched_ = Clock::now();
  if (!in_touch_) return;
  lock.unlock();
  in_touch_();
  lock.lock();
}

/// Holds the run back while it is paused or ahead of its pace. False: it shall end.
bool RunSession::wait(std::unique_lock<std::mutex>& lock) {
  bool told = false;
  while (!stop_) {
    grant(lock);
    if (paused_ && steps_ == 0) {
      if (!told) changed_();  // it stands still now
      told = true;
      if (!stop_ && wishes_.empty()) hold(lock, Clock::now() + kInTouch);
      due_ = Clock::now();
      continue;
    }
    if (paused_ || plan_.pace <= 0 || Clock::now() >= due_) break;
    hold(lock, due_);
  }
  if (paused_ && steps_ > 0) --steps_;
  return !stop_;
}

bool RunSession::between_ticks(double share) {
  std::unique_lock lock(mutex_);
  share_ = share;
  const auto now = Clock::now();
  if (now - measured_at_ > kMeasure) {
    const double wall_s = std::chrono::duration<double>(now - measured_at_).count();
    speed_ = (share_ - measured_share_) * prepared_->experiment.duration_s / wall_s;
    measured_at_ = now;
    measured_share_ = share_;
    changed_();
  }
  if (plan_.pace > 0) {
    const std::chrono::duration<double> step(prepared_->step_s / plan_.pace);
    due_ += std::chrono::duration_cast<Clock::duration>(step);
    due_ = std::max(due_, now - std::chrono::milliseconds(100));  // what was lost to a stall is not run after
  }
  return wait(lock);
}

/// As the folder names the file that was recorded; "" where none was.
std::string RunSession::run_name(const lab::Outcome& outcome) const {
  if (plan_.run_file.empty() || outcome.files.empty()) return "";
  return std::filesystem::path(plan_.run_name)
      .replace_filename(std::filesystem::path(outcome.files.front()).filename())
      .generic_string();
}

/// The file's name in place of the way that leads there.
Error RunSession::named(Error error) const {
  const std::filesystem::path file = error.place.file;
  if (!plan_.run_file.empty() && file.parent_path() == plan_.run_file.parent_path()) {
    error.place.file = std::filesystem::path(plan_.run_name).replace_filename(file.filename()).generic_string();
  }
  return error;
}

void RunSession::conclude(const Result<lab::Outcome>& concluded) {
  Json outcome;
  if (concluded) {
    lab::Outcome told = *concluded;
    for (lab::Trouble& trouble : told.troubles) trouble.error = named(trouble.error);
    outcome = outcome_json(told, run_name(told));
  } else {
    const Error error = named(concluded.error());
    outcome = {{"success", false}, {"reason", error.what.en}, {"reason_es", error.what.es}};
    tell_error(outcome, error);
  }
  {
    const std::lock_guard lock(mutex_);
    outcome_ = std::move(outcome);
    phase_ = "done";
  }
  changed_();
}

Json RunSession::state() const {
  const std::lock_guard lock(mutex_);
  const double duration_s = prepared_->experiment.duration_s;
  const bool held = paused_ && (phase_ == "running" || phase_ == "armed") && steps_ == 0;
  return {{"state", held && phase_ == "running" ? "paused" : phase_},
          {"run", id_},
          {"experiment", plan_.experiment},
          {"controller", plan_.controller},
          {"name", prepared_->experiment.name},
          {"seed", plan_.seed},
          {"pace", plan_.pace},
          {"speed", speed_},
          {"time_s", share_ * duration_s},
          {"duration_s", duration_s},
          {"share", share_},
          {"paused", paused_},
          {"outcome", outcome_},
          {"attached", false}};
}

}  // namespace ganglion::studio
