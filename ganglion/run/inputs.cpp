#include "ganglion/run/inputs.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "ganglion/base/file.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kManifest = "inputs.json", kInput = "input/", kProgram = "builtin/";
/// Read once in an experiment, whoever names them.
constexpr std::array<std::string_view, 4> kSingle = {"experiment", "controller", "robot", "world"};

bool single(std::string_view role) { return std::find(kSingle.begin(), kSingle.end(), role) != kSingle.end(); }

/// The deepest folder that all the files lie below.
fs::path common_folder(const std::vector<fs::path>& files) {
  fs::path common = files.front().parent_path();
  const auto below = [](const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
  };
  for (const fs::path& file : files) {
    while (!below(file, common)) common = common.parent_path();
  }
  return common;
}

/// The names under which files are attached, one for each.
std::vector<std::string> names_of(const std::vector<OpenedFile>& files) {
  std::vector<fs::path> real, found;
  for (const OpenedFile& file : files) {
    std::error_code error;
    fs::path path = fs::weakly_canonical(file.resolved, error);
    real.push_back(error ? file.resolved : std::move(path));
    if (!file.resolved.empty()) found.push_back(real.back());
  }
  const fs::path common = found.empty() ? fs::path() : common_folder(found);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].resolved.empty()) {
      names.push_back(std::string(kProgram) + files[i].named);
    } else {
      names.push_back(std::string(kInput) + real[i].lexically_relative(common).generic_string());
    }
  }
  return names;
}

std::string text_of(const Json& object, std::string_view key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

void attach_inputs(RunRecorder& recorder, const Experiment& experiment, const std::vector<OpenedFile>& files) {
  const std::vector<std::string> names = names_of(files);
  std::map<std::string, std::size_t> sorted;  // each text once, in the order of names
  for (std::size_t i = 0; i < files.size(); ++i) sorted.emplace(names[i], i);
  const auto name_of = [&](int index) {
    return index < 0 ? std::string() : names[static_cast<std::size_t>(index)].substr(kInput.size());
  };
  const OpenedInputs& opened = experiment.opened;
  Json manifest = {{"experiment", name_of(opened.experiment)},
                   {"controller", name_of(opened.controller)},
                   {"robot", name_of(opened.robot)},
                   {"world", name_of(opened.world)},
                   {"overrides", Json::array()},
                   {"files", Json::array()}};
  for (const config::Override& one : experiment.overrides) manifest["overrides"].push_back({one.path, one.value});
  for (std::size_t i = 0; i < files.size(); ++i) {
    manifest["files"].push_back(
        {{"role", files[i].role}, {"named", files[i].named}, {"attached", names[i]}, {"by", files[i].by}});
  }
  recorder.attach(kManifest, manifest.dump(-1, ' ', false, Json::error_handler_t::replace));
  for (const auto& [name, index] : sorted) recorder.attach(name, *files[index].text);
}

Result<std::unique_ptr<AttachedFiles>> AttachedFiles::of(const RunFile& run) {
  const mcap::Attachment* attached = run.attachment(kManifest);
  const Json manifest = attached != nullptr ? Json::parse(attached->bytes, nullptr, false) : Json();
  if (!manifest.is_object())
    return fail(ErrorCode::Corrupt, {"the run file holds no list of its input files",
                                     "el archivo de la ejecución no contiene la lista de sus archivos de entrada"});
  std::unique_ptr<AttachedFiles> files(new AttachedFiles(run));
  const Json list = manifest.value("files", Json::array());
  for (const Json& one : list.is_array() ? list : Json::array()) {
    if (!one.is_object() || !one.contains("by") || !one["by"].is_number_integer()) continue;
    files->listed_.push_back(
        {text_of(one, "role"), text_of(one, "named"), text_of(one, "attached"), one["by"].get<int>()});
  }
  for (const std::string_view role : kSingle) {  // of older run files all that is listed
    const std::string name = text_of(manifest, role);
    const bool known = std::any_of(files->listed_.begin(), files->listed_.end(),
                                   [&](const Listed& listed) { return listed.role == role; });
    if (!known && !name.empty()) files->listed_.push_back({std::string(role), name, std::string(kInput) + name});
  }
  const Json overrides = manifest.value("overrides", Json::array());
  for (const Json& pair : overrides.is_array() ? overrides : Json::array()) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string()) continue;
    files->overrides_.push_back({pair[0].get<std::string>(), pair[1].get<std::string>()});
  }
  return files;
}

std::string AttachedFiles::experiment() const {
  for (const Listed& listed : listed_) {
    if (listed.role == "experiment") return listed.named;
  }
  return "";
}

std::vector<std::string> AttachedFiles::missing() const {
  std::vector<std::string> names;
  for (const Listed& listed : listed_) {
    const bool told = std::find(names.begin(), names.end(), listed.attached) != names.end();
    if (!told && run_->attachment(listed.attached) == nullptr) names.push_back(listed.attached);
  }
  return names;
}

/// Who names a file is compared by where that one is attached: here files may be opened in another order.
const AttachedFiles::Listed* AttachedFiles::find(std::string_view role, std::string_view named, int by) const noexcept {
  const auto same_by = [&](int listed_by) {
    const bool known = listed_by >= 0 && listed_by < static_cast<int>(listed_.size());
    if (by < 0 || !known) return by < 0 && listed_by < 0;
    return at(by).resolved == fs::path(listed_[static_cast<std::size_t>(listed_by)].attached);
  };
  for (const Listed& listed : listed_) {
    if (listed.role != role) continue;
    if (single(role) || (listed.named == named && same_by(listed.by))) return &listed;
  }
  return nullptr;
}

fs::path AttachedFiles::resolve(std::string_view role, std::string_view named, int by) const {
  if (const Listed* listed = find(role, named, by)) return listed->attached;
  if (by < 0) return named;
  return (at(by).resolved.parent_path() / named).lexically_normal();
}

const std::string* AttachedFiles::bytes_of(const std::string& attached) const noexcept {
  const mcap::Attachment* found = run_->attachment(attached);
  return found != nullptr ? &found->bytes : nullptr;
}

Result<std::string> AttachedFiles::read(const fs::path& resolved, std::size_t most_bytes) {
  const std::string* bytes = bytes_of(resolved.generic_string());
  if (bytes == nullptr) {
    return fail_at({resolved.string()}, ErrorCode::NotFound,
                   {"the run file holds no such file", "el archivo de la ejecución no contiene ese archivo"});
  }
  if (bytes->size() > most_bytes) return too_large(resolved, bytes->size(), most_bytes);
  return *bytes;
}

const std::string* AttachedFiles::recorded_builtin(std::string_view role, std::string_view named) const {
  for (const Listed& listed : listed_) {
    if (listed.role == role && listed.named == named && listed.attached.starts_with(kProgram))
      return bytes_of(listed.attached);
  }
  return nullptr;
}

}  // namespace ganglion
