#pragma once

#include <memory>

#include "ganglion/experience/stored_part.h"
#include "ganglion/record/run_file.h"
#include "ganglion/record/run_recorder.h"
#include "ganglion/run/run.h"
#include "ganglion/run/run_robots.h"
#include "ganglion/run/run_writer.h"

namespace ganglion {

/// The run file of one run, with everything needed to repeat it: every input file, what --set changed, and the
/// experience the run started from. Who watches is told the same. Without a file and a watcher all calls do nothing.
/// Until it is whole the file has a name of its own, which ends as the wanted one does: what is left of a run that is
/// killed is found among the others.
class Recording {
 public:
  static Result<Recording> start(const Prepared& prepared, const RunOptions& options, const RunRobots& robots,
                                 const std::vector<std::unique_ptr<Controller>>& controllers);
  void write(std::uint32_t tick, double time_s) {
    if (writer_) writer_->write(tick, time_s);
    if (watched_) watched_->write(tick, time_s);
  }
  /// Something was done to the world before the tick of that time.
  void write_intervention(const InterventionDescriptor& descriptor, const TimedIntervention& one, double time_s) {
    if (writer_) writer_->write_intervention(descriptor, one, time_s);
    if (watched_) watched_->write_intervention(descriptor, one, time_s);
  }
  /// Adds the outcome, closes the file, gives it its name (place_run()) and tells it in the result.
  Result<void> finish(RunResult& result);

 private:
  Result<void> open(const Prepared& prepared, const RunOptions& options);

  std::filesystem::path file_;
  std::unique_ptr<RunRecorder> recorder_;
  std::unique_ptr<RunWriter> writer_;
  std::unique_ptr<RunWriter> watched_;
  std::string criterion_;
};

/// What the run of the file started from. Fails with Corrupt.
Result<std::vector<ModuleExperience>> recorded_experience(const RunFile& run);

/// Between what controllers hand over and what the store keeps.
std::vector<StoredPart> to_parts(const std::vector<ModuleExperience>& experience);
std::vector<ModuleExperience> from_parts(const std::vector<StoredPart>& parts);

}  // namespace ganglion
