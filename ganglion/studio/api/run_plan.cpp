#include "ganglion/studio/api/run_plan.h"

#include <cerrno>
#include <cmath>
#include <ctime>
#include <system_error>

#include "ganglion/base/beneath.h"

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

Result<RunPlan> plan_of(const Ask& ask, const Prepared& prepared, const Folder& folder) {
  RunPlan plan;
  plan.experiment = ask.text("experiment");
  plan.language = ask.language;
  const Json controller = ask.body.value("controller", Json());
  plan.controller =
      controller.is_object() ? controller.value("path", "") : folder.name_of(prepared.experiment.files.controller);
  const double seed = ask.number("seed", static_cast<double>(prepared.experiment.seed));
  if (!(seed >= 0 && seed <= 9e15 && seed == std::floor(seed))) {
    return fail(ErrorCode::BadParameter,
                {"seed is {}, must be a whole number from 0 on", "seed es {}, debe ser un número entero desde 0"},
                seed);
  }
  plan.seed = static_cast<std::uint64_t>(seed);
  plan.pace = ask.number("pace", 1);
  if (!(plan.pace >= 0 && plan.pace <= 1e6))
    return fail(ErrorCode::BadParameter, {"pace is {}, must be >= 0", "pace es {}, debe ser >= 0"}, plan.pace);
  if (prepared.experiment.link.free_running) plan.pace = 0;  // the robot keeps the time
  plan.paused = ask.has("paused") && ask.body["paused"] == Json(true);
  if (ask.has("record") && ask.body["record"] == Json(false)) return plan;
  const std::string stem = fmt::format("{}_seed_{:04}", stamp(), plan.seed);
  const fs::path runs = fs::path("runs") / plain(prepared.experiment.name);
  fs::path name = runs / (stem + ".mcap");
  std::error_code error;
  for (int i = 2; fs::exists(folder.root() / name, error); ++i) name = runs / fmt::format("{}_{}.mcap", stem, i);
  if (!folder.holds(folder.root() / name))
    return fail(ErrorCode::NotFound, {"the folder runs leads elsewhere", "la carpeta runs lleva a otro sitio"});
  plan.run_folder =
      std::make_shared<const FileHandle>(folder_beneath(folder.root(), folder.name_of(folder.root() / name), true));
  if (!plan.run_folder->open())
    return fail(ErrorCode::Unwritable, {"the folder {} cannot be opened: {}", "no se puede abrir la carpeta {}: {}"},
                name.parent_path().generic_string(), std::generic_category().message(errno));
  plan.run_file = fs::path("/proc/self/fd") / std::to_string(plan.run_folder->number()) / name.filename();
  plan.run_name = name.generic_string();
  return plan;
}

void renew_file(RunPlan& plan, std::uint64_t number) {
  if (plan.run_file.empty()) return;
  const std::string stem = fmt::format("{}_seed_{:04}_{}", stamp(), plan.seed, number);
  plan.run_file.replace_filename(stem + ".mcap");
  plan.run_name = fs::path(plan.run_name).replace_filename(stem + ".mcap").generic_string();
}

}  // namespace ganglion::studio
