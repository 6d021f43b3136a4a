#include "ganglion/studio/folder/listing.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/file.h"
#include "ganglion/config/value.h"
#include "ganglion/kinds/applications.h"
#include "ganglion/record/run_file.h"
#include "ganglion/run/check_file.h"
#include "ganglion/run/experiment.h"
#include "ganglion/studio/folder/folder_files.h"

namespace ganglion::studio {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 20'000;
constexpr std::size_t kMostText = std::size_t{4} << 20;
constexpr int kDeepest = 8;

std::string text_of(const config::Value& root, std::string_view key) {
  const config::Value* value = root.find(key);
  return value != nullptr && value->string() != nullptr ? *value->string() : std::string();
}

/// The list that holds it: one that was only begun is a controller.
std::string list_of(const config::Value& root) {
  const std::string kind = kind_of_file(root);
  if (kind == "plant") return "robots";
  if (!kind.empty()) return kind + "s";
  return root.find("robot") != nullptr ? "controllers" : "";
}

bool is_map_name(const fs::path& file) { return file.extension() == ".yaml" || file.extension() == ".yml"; }

/// Whether a YAML text has the keys by which a map is known.
bool is_map(std::string_view text) {
  const auto has = [&](std::string_view key) {
    for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
      if (at == 0 || text[at - 1] == '\n') return true;
    }
    return false;
  };
  return has("image") && has("resolution");
}

fs::file_time_type changed(const fs::path& file) {
  std::error_code error;
  return fs::last_write_time(file, error);
}

Json run_json(const RunSummary& run) {
  Json measures = Json::object();
  for (const auto& [name, value] : run.measures) measures[name] = std::isfinite(value) ? Json(value) : Json();
  return {{"path", run.file},
          {"name", run.name},
          {"seed", run.seed},
          {"finished", run.finished},
          {"success",
           run.verdict == ganglion::Verdict::NotJudged ? Json() : Json(run.verdict == ganglion::Verdict::Succeeded)},
          {"reason", run.reason.en},
          {"digest", run.digest},
          {"controller_hash", run.controller_hash},
          {"recorded_s", run.recorded_s},
          {"measures", std::move(measures)}};
}

std::int64_t seconds_of(fs::file_time_type time) {
  const auto system = std::chrono::file_clock::to_sys(time);
  return std::chrono::duration_cast<std::chrono::seconds>(system.time_since_epoch()).count();
}

}  // namespace

Json Listing::read(const fs::path& file, const std::string& name, Known& known) const {
  std::string& list = known.list;
  std::error_code error;
  if (file.extension() == ".mcap") {
    const auto bytes = folder_.bytes_of(file, kMostRunBytes);
    const auto run = bytes ? RunFile::parse_summary(*bytes, name, Recover::Yes) : tl::unexpected<Error>(bytes.error());
    if (!run) return {};
    list = "runs";
    return run_json(summary_of(*run, name, seconds_of(fs::last_write_time(file, error))));
  }
  const auto text = folder_.bytes_of(file, kMostText);
  if (is_map_name(file)) {
    list = text && is_map(*text) ? "worlds" : "";
    return {{"path", name}, {"name", file.stem().string()}};
  }
  const auto root = text ? config::parse(*text, file.string()) : tl::unexpected<Error>(text.error());
  if (!root) {  // a broken drawing is listed all the same: that is where it can be mended
    list = file.filename().string().starts_with("controller") ? "controllers" : "";
    return {{"path", name}, {"name", ""}, {"draft", folder_.has_draft(file)}};
  }
  list = list_of(*root);
  Json entry = {{"path", name}, {"name", text_of(*root, "name")}};
  if (list != "experiments") return entry;
  return experiment_json(file, *text, std::move(entry), known);
}

Json Listing::experiment_json(const fs::path& file, const std::string& text, Json entry, Known& known) const {
  Problems problems;
  FolderFiles files(folder_);
  files.hold("experiment", file, text);
  const Experiment experiment = read_experiment(files, file, {}, problems);
  if (experiment.opened.world >= 0) check_world(files, experiment.opened.world, problems);
  for (const OpenedFile& other : files.opened()) {
    if (!other.resolved.empty() && other.resolved != file)
      known.others.push_back({other.resolved, changed(other.resolved)});
  }
  known.again = !problems.empty();
  const auto inside = [&](const fs::path& path) { return path.empty() ? std::string() : folder_.name_of(path); };
  entry["controller"] = inside(experiment.files.controller);
  entry["robot"] = inside(experiment.files.robot);
  entry["world"] = inside(experiment.files.world);
  entry["duration_s"] = experiment.duration_s;
  entry["seed"] = experiment.seed;
  entry["address"] = experiment.link.address;
  entry["program"] = !experiment.link.program.empty();
  entry["problems"] = problems.size();
  return entry;
}

const Listing::Known& Listing::look(const fs::path& file) {
  std::error_code error;
  const auto time = changed(file);
  const auto bytes = fs::file_size(file, error);
  Known& known = known_[file];
  const bool others_stand = std::all_of(known.others.begin(), known.others.end(),
                                        [](const auto& other) { return changed(other.first) == other.second; });
  const bool stands = !known.entry.is_null() && known.changed == time && known.bytes == bytes;
  if (stands && !known.again && others_stand) return known;
  known = {.changed = time, .bytes = bytes};
  known.entry = read(file, folder_.name_of(file), known);
  if (known.entry.is_null()) known.entry = Json::object();
  return known;
}

Json Listing::json() {
  Json json = {{"folder", folder_.root().filename().string()}};
  for (const char* list : {"controllers", "experiments", "worlds", "robots", "runs"}) json[list] = Json::array();
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator walk(folder_.root(), fs::directory_options::skip_permission_denied, error);
  for (; walk != fs::recursive_directory_iterator() && files.size() < kMostFiles; walk.increment(error)) {
    if (error) break;
    const fs::path& path = walk->path();
    const bool hidden = path.filename().string().starts_with('.') || path.filename() == "node_modules";
    if (walk->is_directory(error) && (hidden || walk.depth() >= kDeepest)) walk.disable_recursion_pending();
    if (hidden || !walk->is_regular_file(error)) continue;
    const bool known = path.extension() == ".toml" || path.extension() == ".mcap" || is_map_name(path);
    if (known && folder_.holds(path)) files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const Known& known = look(file);
    if (known.list.empty()) continue;
    Json entry = known.entry;
    if (known.list == "controllers") entry["draft"] = folder_.has_draft(file);
    json[known.list].push_back(std::move(entry));
  }
  return json;
}

Json Listing::run(const fs::path& file) {
  const Known& known = look(file);
  return known.list == "runs" ? known.entry : Json();
}

}  // namespace ganglion::studio
