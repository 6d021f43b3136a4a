#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ganglion/graph/controller.h"
#include "ganglion/record/run_sink.h"
#include "ganglion/run/experiment.h"
#include "ganglion/run/interference.h"
#include "ganglion/run/run_robots.h"

namespace ganglion {

/// Writes a run as it goes: signals of every robot at every tick, the scene once, movers, maps and routes when they
/// change, goals and withdrawals as they happen (docs/manual/run_file.md lists the topics).
class RunWriter {
 public:
  /// `truth`: the channels that rows begin with, whether anybody knows them or not.
  RunWriter(RunSink& recorder, const Experiment& experiment, const ControllerModel& model,
            std::span<const TruthChannel> truth, const RunRobots& robots,
            const std::vector<std::unique_ptr<Controller>>& controllers);
  /// Once, before the first tick: the world as the run begins.
  void write_scene(const sim::World& world, const sim::RobotModel& robot, const ControllerModel& model);
  /// The tick just decided: truth as it was sensed, and what the controllers made of it. Allocates only for what
  /// changed.
  void write(std::uint32_t tick, double time_s);
  /// What somebody did to the world before the tick of that time, and how it stands now.
  void write_intervention(const TimedIntervention& one, double time_s);

 private:
  struct Robot {
    int table = -1;
    std::vector<double> row;
    std::map<std::string, std::uint64_t> shown;  ///< Hash of what each topic showed last.
    std::vector<std::uint8_t> statuses;          ///< Of each component's request.
    std::vector<sim::GoalOutcome> outcomes;
  };
  void write_truth(std::size_t robot);
  void write_link(std::uint32_t tick, double time_s);
  void write_movers(double time_s);
  void write_requests(int robot, double time_s);
  void write_goals(int robot, double time_s);
  void write_exhibits(int robot, double time_s);
  void log(double time_s, int level, const std::string& name, const Sentence& message);

  RunSink& recorder_;
  const sim::Witness* witness_;  ///< Null where nobody knows the truth.
  std::span<const TruthChannel> truth_;
  link::RemoteApplication* remote_;  ///< Null where the robots are simulated here.
  int link_table_ = -1;
  const std::vector<std::unique_ptr<Controller>>& controllers_;
  double maps_every_s_;
  double next_maps_s_ = 0;
  double cell_m_ = 0;
  double goal_cell_m_ = 0;  ///< Of the trainer; else that of the map.
  std::uint64_t movers_shown_ = 0;
  std::vector<Robot> robots_;
};

}  // namespace ganglion
