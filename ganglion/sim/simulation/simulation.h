#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ganglion/application/application.h"
#include "ganglion/application/step_clock.h"
#include "ganglion/sim/robot/robot_model.h"
#include "ganglion/sim/robot/truth_channels.h"
#include "ganglion/sim/simulation/body.h"
#include "ganglion/sim/simulation/crowd.h"
#include "ganglion/sim/simulation/device.h"
#include "ganglion/sim/simulation/lookout.h"
#include "ganglion/sim/simulation/spawn.h"
#include "ganglion/sim/world/ground_terrain.h"

namespace ganglion::sim {

struct SimulationConfig {
  std::shared_ptr<const Ground> ground;
  std::shared_ptr<const RobotModel> model;
  int robots = 1;
  SpawnRule spawn = SpawnRandom{};
};

/// Robots of one model in a world, as an Application; tasks are set to them by a
/// TaskedApplication. Robots are solid to each other and seen by each other's sensors;
/// a robot that nobody comes near has the same bits whether it is alone or among others.
///
/// A step is cut into sub-steps of at most model.substep_s. In each the movers go first, then the robots, those who
/// meet as Crowd says, then their sensors. A sensor fires at the end of the sub-step in which it is due, for a step's
/// frame only its last firing counts. Where there are no movers, the floor is plain and no sensor wants to know what
/// happens within a step, robots that drive steadily and can meet nothing on their way go all of it at once, before the
/// others. Commands lapse to their safe values exactly after their time to live. The cost of a frame is the energy the
/// step before it took; the first frame of an episode has none. reset() takes memory; sense() and step() take none.
class Simulation final : public Application, public Witness {
 public:
  /// Fails with BadParameter without ground, robots or a simulated model, or where the spawn rule cannot hold.
  static Result<std::unique_ptr<Simulation>> make(SimulationConfig config);

  const Description& description() const noexcept override { return config_.model->description; }
  int robots() const noexcept override { return config_.robots; }
  /// Fails with BadParameter where a robot finds no place, or a sensor no sense in the scene.
  Result<void> reset(std::uint64_t seed, std::uint32_t episode) override;
  void sense(std::span<SenseFrame> frames) noexcept override;
  void step(std::span<const ActFrame> frames, double step_s) noexcept override;

  const ganglion::Witness* witness() const noexcept override { return this; }
  const Terrain* terrain() const noexcept override { return &terrain_; }
  std::span<const InterventionDescriptor> interventions() const noexcept override;
  /// "obstacle": a mover stands with its centre at a point at once, and stays (see World::put_mover()); sensors see it at
  /// their next firing.
  Result<Intervened> intervene(const Intervention& what) override;

  std::span<const TruthChannel> truth_channels() const noexcept override { return sim::truth_channels(); }
  std::span<const double> truth_of(int robot) const noexcept override;
  double time_s() const noexcept override { return time_s_; }
  std::span<const PlacedMover> movers() const noexcept override;

  std::uint32_t tick() const noexcept { return tick_; }
  const Truth& truth(int robot) const noexcept { return bodies_[static_cast<std::size_t>(robot)].truth(); }
  const World& world() const noexcept { return world_; }
  const RobotModel& model() const noexcept { return *config_.model; }

 private:
  explicit Simulation(SimulationConfig config, Spawner spawner);
  Result<void> add_bodies();
  Result<void> add_devices();
  void prepare();
  /// Of all sensations of a robot, in the order of frames.
  std::span<double> values_of(std::size_t robot) noexcept {
    return std::span(values_).subspan(robot * stride_, stride_);
  }
  /// Whether no device wants to know what happens before the step's last sub-step, which begins at last_s.
  bool devices_wait(double last_s, double end_s) const noexcept;
  /// Moves those that can meet nothing through the whole step; busy_ holds the others.
  void move_free_robots(double step_s) noexcept;
  /// Whether that robot runs into nothing on its way through the whole step, whatever the others do; none of them goes
  /// farther than longest_m.
  bool goes_freely(std::size_t robot, double longest_m, double step_s) noexcept;
  /// Robots that stand, or turn on the spot, go by sub-steps as well where others might push them, one through another.
  void wake_standing_robots(double longest_m) noexcept;
  void move_busy_robots(double elapsed_s, double step_s) noexcept;
  /// Moves a robot that meets no other.
  void move_alone(std::size_t robot, double time_s, double step_s) noexcept;
  /// Ends a standing robot's touch with one that has gone.
  void part(std::size_t robot) noexcept;
  void move_crowd(double time_s, double step_s) noexcept;
  void run_devices(double begin_s, double now_s, double end_s) noexcept;
  void run_devices(std::size_t robot, std::span<const Lookout::Call> calls, double substep_s) noexcept;
  /// Fills draws_ for the calls of a robot's devices.
  void draw(std::size_t robot, std::span<const Lookout::Call> calls) noexcept;

  SimulationConfig config_;
  Spawner spawner_;
  World world_;
  GroundTerrain terrain_;  // with the movers of world_
  std::vector<Body> bodies_;
  std::vector<Device> devices_;
  std::size_t stride_ = 0;      // values of one robot
  std::vector<double> values_;  // of all robots
  std::vector<double> ages_s_;  // of all channels, the same for all robots
  Neighbours neighbours_;
  std::vector<double> way_m_;  // of each robot in this step
  std::vector<char> is_busy_;
  std::vector<double> alone_m_;      // how near at least the others were to each after the last step; 0 = unknown
  std::vector<std::size_t> busy_;    // robots that go by sub-steps in this step
  std::vector<Crowd::Wish> wishes_;  // of each robot in this sub-step
  std::unique_ptr<Crowd> crowd_;
  std::unique_ptr<Lookout> lookout_;
  std::vector<Draws> draws_;                 // of the devices of one robot that draw a normal first
  mutable std::vector<double> truths_;       // of all robots, as far as somebody asked
  mutable std::vector<PlacedMover> placed_;  // the same
  std::uint32_t tick_ = 0;
  std::uint32_t substeps_ = 0;
  StepClock clock_;
  double time_s_ = 0;  // of clock_
};

}  // namespace ganglion::sim
