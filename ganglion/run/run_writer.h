#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ganglion/graph/controller.h"
#include "ganglion/record/exhibit_recorder.h"
#include "ganglion/record/run_sink.h"
#include "ganglion/run/experiment.h"
#include "ganglion/run/interference.h"
#include "ganglion/run/run_robots.h"

namespace ganglion {

/// Writes a run as it goes: signals of every robot at every tick, the scene once, movers, maps and routes when they
/// change, goals and withdrawals as they happen (docs/manual/run_file.md lists the topics).
class RunWriter {
 public:
  /// Rows begin with the truth that the application has where it runs here, whether anybody knows it now or not.
  RunWriter(RunSink& recorder, const Experiment& experiment, const ControllerModel& model,
            const ApplicationModel& application, const RunRobots& robots,
            const std::vector<std::unique_ptr<Controller>>& controllers);
  /// Once, before the first tick: what stands round the application as the run begins, and what it looks like.
  void write_scene(const std::string& scene, const Description& description, const ControllerModel& model);
  /// The tick just decided: truth as it was sensed, and what the controllers made of it. Allocates only for what
  /// changed.
  void write(std::uint32_t tick, double time_s);
  /// What somebody did to the world before the tick of that time, and how it stands now.
  void write_intervention(const InterventionDescriptor& descriptor, const TimedIntervention& one, double time_s);

 private:
  /// How far a ledger was told: its rows and their outcomes.
  struct LedgerWritten {
    std::uint64_t changes = ~std::uint64_t{0};
    std::vector<double> outcomes;
  };
  struct Robot {
    int table = -1;
    std::vector<double> row;
    std::vector<std::uint8_t> statuses;  ///< Of each component's request.
    std::vector<LedgerWritten> ledgers;  ///< What was told of each.
  };
  void write_truth(std::size_t robot);
  void write_link(std::uint32_t tick, double time_s);
  void write_movers(double time_s);
  void write_requests(int robot, double time_s);
  void write_ledgers(int robot, double time_s);
  void write_row(int robot, const LedgerForm& form, const Ledger& ledger, std::size_t row, double time_s);
  void write_exhibits(int robot, double time_s);
  void log(double time_s, int level, const std::string& name, const Sentence& message);

  RunSink& recorder_;
  const Application& application_;
  const Witness* witness_;  ///< Null where nobody knows the truth.
  std::span<const TruthChannel> truth_;
  std::span<const LedgerForm> ledgers_;
  link::RemoteApplication* remote_;  ///< Null where the robots are simulated here.
  int link_table_ = -1;
  const std::vector<std::unique_ptr<Controller>>& controllers_;
  double maps_every_s_;
  double next_maps_s_ = 0;
  double cell_m_ = 0;
  std::uint64_t movers_shown_ = 0;
  ExhibitRecorder exhibits_;
  std::vector<Robot> robots_;
};

}  // namespace ganglion
