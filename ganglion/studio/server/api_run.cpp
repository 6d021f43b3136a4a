#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>

#include "ganglion/base/file.h"
#include "ganglion/base/text.h"
#include "ganglion/studio/document/source_map.h"
#include "ganglion/studio/document/wording.h"
#include "ganglion/studio/server/api.h"

namespace ganglion::studio {
namespace {

namespace fs = std::filesystem;

/// Keys by which --set could name files or programs: these have fields of their own, which are checked.
constexpr std::array<std::string_view, 5> kNotSet = {"controller", "application.robot", "application.world",
                                                     "application.program", "application.address"};

Json problems_json(const Problems& problems, Language language) {
  Json list = Json::array();
  for (const Error& error : problems.sorted()) {
    list.push_back({{"code", name_of(error.code)},
                    {"message", worded(error.message, language)},
                    {"file", fs::path(error.place.file).filename().string()},
                    {"line", error.place.line},
                    {"column", error.place.column}});
  }
  return list;
}

Reply problems_reply(const Problems& problems, Language language) {
  const auto sorted = problems.sorted();
  return failure("BadParameter", sorted.empty() ? "" : worded(sorted.front().message, language), 400,
                 {{"problems", problems_json(problems, language)}});
}

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

std::optional<Reply> Api::refuse_command() const {
  if (attached_.is_null()) return std::nullopt;
  return failure("Forbidden", "this run belongs to the command line; it can only be watched", 403);
}

std::optional<Reply> Api::check_programs(const Experiment& experiment) const {
  const LinkChoice& link = experiment.link;
  const bool listed = link.program.empty() || std::any_of(programs_.begin(), programs_.end(),
                                                          [&](const auto& one) { return one.command == link.program; });
  if (!listed) {
    return failure("ProgramNotListed", "the studio starts only programs that are listed in your own studio.toml", 403,
                   {{"program", link.program.front()}});
  }
  if (link.address.starts_with("serial:") && !link.address.starts_with("serial:///dev/tty")) {
    return failure("Forbidden", "a serial address must lead to /dev/tty...", 403);
  }
  return std::nullopt;
}

Reply Api::start_run(const Ask& ask) {
  if (auto refused = refuse_command()) return *refused;
  if (session_ && !session_->over()) return failure("Running", "a run is on; stop it first", 409);
  const auto experiment = folder_.resolve(ask.text("experiment"));
  if (!experiment) return failure(experiment.error(), ask.language);
  ExperimentFiles instead;
  for (const auto& [key, file] : {std::pair{"world", &instead.world}, {"robot", &instead.robot}}) {
    if (!ask.has(key)) continue;
    const auto path = folder_.resolve(ask.text(key));
    if (!path) return failure(path.error(), ask.language);
    *file = *path;
  }
  std::vector<config::Override> overrides;
  const auto override = [&](const std::string& key, const std::string& toml) { overrides.push_back({key, toml}); };
  for (const Json& one : ask.body.value("set", Json::array())) {
    const auto set = config::parse_override(one.is_string() ? one.get<std::string>() : std::string());
    if (!set) return failure(set.error(), ask.language);
    if (std::find(kNotSet.begin(), kNotSet.end(), set->path) != kNotSet.end()) {
      return failure("Forbidden", fmt::format("{} cannot be set so", set->path), 403);
    }
    overrides.push_back(*set);
  }
  if (ask.has("duration_s")) override("run.duration_s", shortest(ask.number("duration_s", 60)));
  if (ask.has("address")) override("application.address", toml_text(ask.text("address")));
  if (ask.has("program")) {
    const auto program = std::find_if(programs_.begin(), programs_.end(),
                                      [&](const AllowedProgram& one) { return one.name == ask.text("program"); });
    if (program == programs_.end()) {
      return failure("ProgramNotListed", "the studio starts only programs that are listed in your own studio.toml", 403,
                     {{"program", ask.text("program")}});
    }
    std::string command;
    for (const std::string& word : program->command) command += (command.empty() ? "" : ", ") + toml_text(word);
    override("application.program", "[" + command + "]");
  }
  fs::path drawn;  // what is drawn, run without being saved: beside its file, for its paths
  if (ask.has("controller")) {
    const Json& controller = ask.body["controller"];
    const auto path = folder_.resolve(controller.is_object() ? controller.value("path", "") : "");
    if (!path) return failure(path.error(), ask.language);
    instead.controller = *path;
    if (controller.contains("text") && controller["text"].is_string()) {
      drawn = path->parent_path() / ("." + path->filename().string() + ".running");
      const auto written = write_file(drawn, controller["text"].get<std::string>());
      if (!written) return failure(written.error(), ask.language);
      instead.controller = drawn;
    }
  }
  Problems problems;
  const Experiment named = read_experiment(*experiment, overrides, problems, instead);
  if (auto refused = check_programs(named)) return *refused;
  for (const fs::path& file : {named.files.controller, named.files.robot, named.files.world}) {
    if (!file.empty() && !folder_.holds(file)) {
      return failure("Outside", "the experiment names a file outside of the studio's folder", 403,
                     {{"file", file.filename().string()}});
    }
  }
  Problems found;
  auto prepared = prepare(*experiment, overrides, found, instead);
  if (!prepared) return problems_reply(found, ask.language);
  for (const fs::path& file : input_files(prepared->experiment.files)) {
    if (folder_.holds(file)) continue;
    return failure("Outside", "the experiment names a file outside of the studio's folder", 403,
                   {{"file", file.filename().string()}});
  }
  auto plan = plan_of(ask, *prepared);
  if (!plan) return failure(plan.error(), ask.language);
  begin(std::make_shared<const Prepared>(std::move(*prepared)), std::move(*plan));
  return json_reply({{"run", std::to_string(runs_)}, {"state", state()}});
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

Reply Api::answer(bool done) {
  if (!done) return failure("NotRunning", "no run is on", 409);
  return json_reply({{"state", state()}});
}

Reply Api::pause_run(const Ask&) {
  if (auto refused = refuse_command()) return *refused;
  return answer(session_ && session_->pause());
}

Reply Api::resume_run(const Ask&) {
  if (auto refused = refuse_command()) return *refused;
  return answer(session_ && session_->resume());
}

Reply Api::step_run(const Ask& ask) {
  if (auto refused = refuse_command()) return *refused;
  const double ticks = std::clamp(ask.number("ticks", 1), 1.0, 1e6);
  return answer(session_ && session_->step(static_cast<std::uint32_t>(ticks)));
}

Reply Api::stop_run(const Ask&) {
  if (auto refused = refuse_command()) return *refused;
  return answer(session_ && session_->stop());
}

Reply Api::pace_run(const Ask& ask) {
  if (auto refused = refuse_command()) return *refused;
  const double pace = ask.number("pace", -1);
  if (!(pace >= 0 && pace <= 1e6))
    return failure("BadParameter", "pace must be a number >= 0; 0 = as fast as can be", 400);
  if (session_) session_->set_pace(pace);
  return answer(session_ != nullptr);
}

/// The same run from the start, in a new file.
Reply Api::reset_run(const Ask&) {
  if (auto refused = refuse_command()) return *refused;
  if (!session_) return answer(false);
  RunPlan plan = session_->plan();
  session_.reset();  // stops it and waits for its end
  if (!plan.run_file.empty()) {
    const std::string stem = fmt::format("{}_seed_{:04}_{}", stamp(), plan.seed, runs_ + 1);
    plan.run_file.replace_filename(stem + ".mcap");
    plan.run_name = folder_.name_of(plan.run_file);
  }
  begin(prepared_, std::move(plan));
  return json_reply({{"run", std::to_string(runs_)}, {"state", state()}});
}

}  // namespace ganglion::studio
