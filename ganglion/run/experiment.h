#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ganglion/application/fault/fault.h"
#include "ganglion/config/table.h"
#include "ganglion/run/criterion.h"

namespace ganglion {

/// Where the robots are, when they are not simulated in this program.
struct LinkChoice {
  std::string address;               ///< "tcp://HOST:PORT", "serial:///dev/ttyUSB0?baud=115200"; "" = none.
  std::vector<std::string> program;  ///< Started for the run, with the port it shall listen on.
  bool free_running = false;         ///< They keep a clock of their own, else the controller's ticks are theirs.
  bool json = false;                 ///< Frames as JSON lines, for people who watch the bytes.
  bool remote() const noexcept { return !address.empty() || !program.empty(); }
};

/// The files an experiment stands on, as they were found: paths in files are relative to those, in --set to the
/// working directory.
struct ExperimentFiles {
  std::filesystem::path experiment;
  std::filesystem::path controller;
  std::filesystem::path robot;
  std::filesystem::path world;  ///< Empty: open ground.
};

/// The same as indices in what opened them; -1 = not named, or not to be read.
struct OpenedInputs {
  int experiment = -1;
  int controller = -1;
  int robot = -1;
  int world = -1;
};

/// What to run and how to judge it: experiment.toml.
struct Experiment {
  std::string name;
  ExperimentFiles files;
  OpenedInputs opened;
  config::Value setting;  ///< [application] as it stands: what its kind has besides, it reads itself.
  int robots = 1;
  LinkChoice link;
  double duration_s = 60;
  std::uint64_t seed = 1;
  double maps_every_s = 1;   ///< How often maps are recorded while they change.
  bool free_ground = false;  ///< Drive the same run on open ground first, to measure progress_ratio against it.
  struct {
    Place duration, free_ground, robots;
  } places;                        ///< Where these stand, or would.
  std::vector<Fault> faults;       ///< Of every robot, in their order.
  std::vector<Criterion> success;  ///< All must be met.
  std::vector<Criterion> stop;     ///< Any ends the run early.
  std::vector<config::Override> controller_overrides, robot_overrides, world_overrides;  ///< For the named files.
  std::vector<config::Override> overrides;  ///< All of them, for the record.
};

/// Reads an experiment.toml, or the one in a folder, with what --set changes. A path that goes on behind a key that
/// names a file goes on inside that file: controller.acting.escape.trigger_range_m=0.2. `instead` names files that
/// count in place of the named ones. The files it names are opened, not yet understood. Every problem is reported; the result holds what
/// was understood.
Experiment read_experiment(FileReader& files, const std::filesystem::path& path,
                           const std::vector<config::Override>& overrides, Problems& problems,
                           const ExperimentFiles& instead = {});

/// [application] with the keys that every application has marked as known.
config::Table setting_of(const Experiment& experiment, Problems& problems);

/// The same from a text, without --set and without opening what it names. `outline` takes down what was asked.
Experiment parse_experiment(std::string_view text, const std::string& file_name, Problems& problems,
                            config::Outline* outline = nullptr);

}  // namespace ganglion
