#include "ganglion/run/recording.h"

#include <algorithm>

#include "ganglion/record/place_run.h"
#include "ganglion/run/inputs.h"
#include "ganglion/run/version.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr double kWatchedMaps_s = 0.25;  // who watches sees a map grow

RunInfo info_of(const Prepared& prepared, const RunOptions& options) {
  RunInfo info;
  info.name = prepared.experiment.name;
  info.seed = options.seed;
  info.episode = options.episode;
  info.tick_s = prepared.step_s;
  info.controller_hash = prepared.controller_hash;
  info.robots.assign(static_cast<std::size_t>(prepared.experiment.robots), prepared.application->description().name);
  info.versions = {{"ganglion", std::string(kVersion)}};
  return info;
}

}  // namespace

Result<void> Recording::open(const Prepared& prepared, const RunOptions& options) {
  file_ = options.run_file;
  McapWriterOptions written;
  written.placing = mcap::Placing::UnderOwnName;
  auto recorder = RunRecorder::create(options.run_file, info_of(prepared, options), std::move(written));
  if (!recorder) return tl::unexpected<Error>(recorder.error());
  recorder_ = std::make_unique<RunRecorder>(std::move(*recorder));
  attach_inputs(*recorder_, prepared.experiment, prepared.files);
  recorder_->attach(kExperienceAttachment, export_parts(to_parts(options.experience)));
  criterion_ = text_of(prepared.experiment.success);
  return {};
}

Result<Recording> Recording::start(const Prepared& prepared, const RunOptions& options, const RunRobots& robots,
                                   const std::vector<std::unique_ptr<Controller>>& controllers) {
  Recording recording;
  const auto writer_to = [&](RunSink& sink, const Experiment& experiment) {
    auto writer =
        std::make_unique<RunWriter>(sink, experiment, prepared.controller, *prepared.application, robots, controllers);
    writer->write_scene(prepared.application->scene(options.seed, options.episode), prepared.application->description(),
                        prepared.controller);
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
  const fs::path recorded = recorder_->path();
  result.files.push_back(recorded.string());
  const auto finished = recorder_->finish({result.digest, result.verdict, result.reason, criterion_, result.measures,
                                           result.component_digests, result.interventions});
  if (!finished) return finished;
  const auto placed = place_run(recorded, file_);
  if (!placed) return tl::unexpected<Error>(placed.error());
  result.files.back() = placed->string();
  return {};
}

Result<std::vector<ModuleExperience>> recorded_experience(const RunFile& run) {
  const mcap::Attachment* experience = run.attachment(kExperienceAttachment);
  if (experience == nullptr) return std::vector<ModuleExperience>{};
  auto parts = import_parts(experience->bytes, "experience of the run");
  if (!parts) return tl::unexpected<Error>(parts.error());
  return from_parts(*parts);
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
