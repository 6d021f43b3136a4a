#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ganglion/base/files.h"
#include "ganglion/config/value.h"
#include "ganglion/graph/model.h"
#include "ganglion/record/run_file.h"
#include "ganglion/record/run_recorder.h"
#include "ganglion/run/experiment.h"

namespace ganglion {

/// Attaches every file that was read, under "input/" and its name from the deepest folder that all lie below, texts of
/// the program under "builtin/", and before them "inputs.json": which of them is what, who names it, and what --set
/// changed. Of a file that is cut, what is missing is known by it.
void attach_inputs(RunRecorder& recorder, const Experiment& experiment, const std::vector<OpenedFile>& files);

/// The files of a recorded run, found by who names them and how; nothing is read from the disk. Of files whose list says
/// only what is the experiment, the controller, the robot and the world, the rest is found by its name.
class AttachedFiles final : public FileReader {
 public:
  /// Fails with Corrupt where the run file holds no list of its files. It must outlive this.
  static Result<std::unique_ptr<AttachedFiles>> of(const RunFile& run);

  /// What to open as the experiment.
  std::string experiment() const;
  /// What --set changed.
  const std::vector<config::Override>& overrides() const noexcept { return overrides_; }
  /// What is listed, and not there, by the names under which it was attached.
  std::vector<std::string> missing() const;

 private:
  struct Listed {
    std::string role, named, attached;
    int by = -1;
  };
  explicit AttachedFiles(const RunFile& run) : run_(&run) {}
  const Listed* find(std::string_view role, std::string_view named, int by) const noexcept;
  std::filesystem::path resolve(std::string_view role, std::string_view named, int by) const override;
  Result<std::string> read(const std::filesystem::path& resolved, std::size_t most_bytes) override;
  const std::string* recorded_builtin(std::string_view role, std::string_view named) const override;
  const std::string* bytes_of(const std::string& attached) const noexcept;

  const RunFile* run_;
  std::vector<Listed> listed_;
  std::vector<config::Override> overrides_;
};

}  // namespace ganglion
