#pragma once

#include <memory>

#include "ganglion/graph/model.h"
#include "ganglion/measure/measure.h"
#include "ganglion/run/experiment.h"
#include "ganglion/sim/robot/robot_model.h"
#include "ganglion/sim/simulation/simulation.h"
#include "ganglion/sim/world/ground.h"

namespace ganglion {

/// An experiment with all its files read and checked: immutable, shared by any number of runs and threads.
struct Prepared {
  Experiment experiment;
  ControllerModel controller;
  std::shared_ptr<const sim::RobotModel> robot;
  std::shared_ptr<const sim::Ground> ground;
  std::shared_ptr<const sim::Ground> open_ground;  ///< For the yardstick of progress, where asked for.
  double step_s = 0.1;
  std::shared_ptr<const Terrain> terrain;
  std::vector<MeasuredSignal> signals;  ///< Of the controller.
  std::vector<Figure> figures;          ///< What the run will be measured by.
  std::string controller_hash;          ///< Of the controller's text, the files it names, and what --set changed in it.
  std::vector<OpenedFile> files;        ///< All that was read: texts of at most 256 MiB, shared by copies.
  /// What can be measured.
  MeasureScope scope() const;
  /// On that ground, started as the experiment says, or at the given poses where there are any.
  sim::SimulationConfig simulation(std::shared_ptr<const sim::Ground> on, const std::vector<Pose2>& starts) const;
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
                                               const std::vector<config::Override>& overrides,
                                               const RobotDescription* robot, Problems& problems);

}  // namespace ganglion
