#pragma once

#include <memory>

#include "ganglion/application/model.h"
#include "ganglion/graph/model.h"
#include "ganglion/measure/measure.h"
#include "ganglion/run/experiment.h"

namespace ganglion {

/// An experiment with all its files read and checked: immutable, shared by any number of runs and threads.
struct Prepared {
  Experiment experiment;
  ControllerModel controller;
  std::shared_ptr<const ApplicationModel> application;
  double step_s = 0.1;
  std::vector<MeasuredSignal> signals;  ///< Of the controller.
  std::vector<Figure> figures;          ///< What the run will be measured by.
  std::string controller_hash;          ///< Of the controller's text, the files it names, and what --set changed in it.
  std::vector<OpenedFile> files;        ///< All that was read: texts of at most 256 MiB, shared by copies.
  /// What can be measured.
  MeasureScope scope() const;
};

/// Reads and checks everything; none if there were problems.
std::optional<Prepared> prepare(FileReader& files, const std::filesystem::path& experiment,
                                const std::vector<config::Override>& overrides, Problems& problems,
                                const ExperimentFiles& instead = {});
/// The same with files of the disk.
std::optional<Prepared> prepare(const std::filesystem::path& experiment, const std::vector<config::Override>& overrides,
                                Problems& problems, const ExperimentFiles& instead = {});

/// Reads and checks a controller against the robot its file names, or against `robot`.
std::optional<ControllerModel> load_controller(FileReader& files, int controller,
                                               const std::vector<config::Override>& overrides, const Description* robot,
                                               Problems& problems);

}  // namespace ganglion
