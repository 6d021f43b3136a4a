#include "ganglion/run/recording.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ganglion/base/file.h"
#include "ganglion/run/version.h"
#include "ganglion/sim/robot/truth_channels.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kManifest = "inputs.json";
constexpr double kWatchedMaps_s = 0.25;  // who watches sees a map grow

/// The deepest folder that all the files lie below.
fs::path common_folder(const std::vector<fs::path>& files) {
  fs::path common = files.front().parent_path();
  auto below = [](const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
  };
  for (const fs::path& file : files) {
    while (!below(file, common)) common = common.parent_path();
  }
  return common;
}

Result<void> attach_inputs(RunRecorder& recorder, const Experiment& experiment) {
  std::vector<fs::path> files;
  for (const fs::path& file : input_files(experiment.files)) files.push_back(fs::weakly_canonical(file));
  const fs::path common = common_folder(files);
  auto name_of = [&](const fs::path& file) {
    return file.empty() ? std::string() : fs::weakly_canonical(file).lexically_relative(common).generic_string();
  };
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  for (const fs::path& file : files) {
    const auto content = read_file(file);
    if (!content) return tl::unexpected<Error>(content.error());
    recorder.attach("input/" + name_of(file), *content);
  }
  Json overrides = Json::array();
  for (const config::Override& override : experiment.overrides) overrides.push_back({override.path, override.value});
  const Json manifest = {{"experiment", name_of(experiment.files.experiment)},
                         {"controller", name_of(experiment.files.controller)},
                         {"robot", name_of(experiment.files.robot)},
                         {"world", name_of(experiment.files.world)},
                         {"overrides", overrides}};
  recorder.attach(kManifest, manifest.dump());
  return {};
}

RunInfo info_of(const Prepared& prepared, const RunOptions& options) {
  RunInfo info;
  info.name = prepared.experiment.name;
  info.seed = options.seed;
  info.episode = options.episode;
  info.tick_s = prepared.step_s;
  info.controller_hash = prepared.controller_hash;
  info.robots.assign(static_cast<std::size_t>(prepared.experiment.robots), prepared.robot->description.name);
  info.versions = {{"ganglion", std::string(kVersion)}};
  return info;
}

/// A relative path that stays below the folder it is put in.
bool stays_inside(const fs::path& path) {
  return !path.is_absolute() && std::find(path.begin(), path.end(), "..") == path.end();
}

}  // namespace

Result<void> Recording::open(const Prepared& prepared, const RunOptions& options) {
  file_ = options.run_file;
  std::error_code ignored;
  fs::create_directories(fs::absolute(options.run_file).parent_path(), ignored);
  auto recorder = RunRecorder::create(options.run_file, info_of(prepared, options));
  if (!recorder) return tl::unexpected<Error>(recorder.error());
  recorder_ = std::make_unique<RunRecorder>(std::move(*recorder));
  if (auto attached = attach_inputs(*recorder_, prepared.experiment); !attached) return attached;
  criterion_ = text_of(prepared.experiment.success);
  recorder_->attach(kExperienceAttachment, export_parts(to_parts(options.experience)));
  return {};
}

Result<Recording> Recording::start(const Prepared& prepared, const RunOptions& options, const RunRobots& robots,
                                   const std::vector<std::unique_ptr<Controller>>& controllers) {
  Recording recording;
  const auto writer_to = [&](RunSink& sink, const Experiment& experiment) {
    auto writer =
        std::make_unique<RunWriter>(sink, experiment, prepared.controller, sim::truth_channels(), robots, controllers);
    sim::World world(prepared.ground);
    world.reset(options.seed, options.episode);
    writer->write_scene(world, *prepared.robot, prepared.controller);
    return writer;
  };
  if (!options.run_file.empty()) {
    if (auto opened = recording.open(prepared, options); !opened) return tl::unexpected<Error>(opened.error());
    recording.writer_ = writer_to(*recording.recorder_, prepared.experiment);
  }
  if (options.watcher != nullptr) {
    Experiment watched = prepared.experiment;
    watched.maps_every_s = std::min(watched.maps_every_s, kWatchedMaps_s);
    recording.watched_ = writer_to(*options.watcher, watched);
  }
  return recording;
}

Result<void> Recording::finish(RunResult& result) {
  if (!recorder_) return {};
  result.files.push_back(file_.string());
  return recorder_->finish({result.digest, result.verdict, result.reason, criterion_, result.measures,
                            result.component_digests, result.interventions});
}

Result<RecordedInputs> unpack_inputs(const RunFile& run, const fs::path& folder) {
  const mcap::Attachment* attached = run.attachment(kManifest);
  const Json manifest = attached != nullptr ? Json::parse(attached->bytes, nullptr, false) : Json();
  if (!manifest.is_object())
    return fail(ErrorCode::Corrupt, {"the run file holds no list of its input files",
                                     "el archivo de la ejecución no contiene la lista de sus archivos de entrada"});
  RecordedInputs inputs;
  for (const mcap::Attachment& attachment : run.attachments) {
    if (!attachment.name.starts_with("input/")) continue;
    const fs::path name = attachment.name.substr(6);
    if (!stays_inside(name)) {
      return fail(ErrorCode::Corrupt,
                  {"an input file wants to be written to \"{}\", outside of its folder",
                   "un archivo de entrada quiere escribirse en \"{}\", fuera de su carpeta"},
                  name.string());
    }
    if (auto written = write_file(folder / name, attachment.bytes); !written) {
      return tl::unexpected<Error>(written.error());
    }
  }
  auto path_of = [&](const char* role) -> fs::path {
    const auto found = manifest.find(role);
    if (found == manifest.end() || !found->is_string() || found->get<std::string>().empty()) return {};
    return folder / found->get<std::string>();
  };
  inputs.files = {path_of("experiment"), path_of("controller"), path_of("robot"), path_of("world")};
  for (const Json& pair : manifest.value("overrides", Json::array())) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string()) continue;
    inputs.overrides.push_back({pair[0].get<std::string>(), pair[1].get<std::string>()});
  }
  if (const mcap::Attachment* experience = run.attachment(kExperienceAttachment)) {
    auto parts = import_parts(experience->bytes, "experience of the run");
    if (!parts) return tl::unexpected<Error>(parts.error());
    inputs.experience = from_parts(*parts);
  }
  return inputs;
}

std::vector<StoredPart> to_parts(const std::vector<ModuleExperience>& experience) {
  std::vector<StoredPart> parts;
  for (const ModuleExperience& module : experience) {
    for (const ExperiencePart& part : module.parts) {
      parts.push_back({module.component, module.kind, module.version, part.name, part.bytes});
    }
  }
  return parts;
}

std::vector<ModuleExperience> from_parts(const std::vector<StoredPart>& parts) {
  std::vector<ModuleExperience> experience;
  for (const StoredPart& part : parts) {
    if (experience.empty() || experience.back().component != part.component) {
      experience.push_back({part.component, part.kind, part.version, {}});
    }
    experience.back().parts.push_back({part.name, part.bytes});
  }
  return experience;
}

}  // namespace ganglion
