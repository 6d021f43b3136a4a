#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/sim/simulation/simulation.h"

namespace ganglion::bench {

/// Scenario SB12: a closed square of max(8, 2 sqrt N) m, floor(side^2 / 8) boxes of 0.5 m on a jittered grid, N discs
/// of radius 0.15 m with an axle of 0.26 m and at most 0.3 m/s, 12 range sensors on their rims every 30 deg.
struct Sb12Scene {
  struct Box {
    Vector2 centre;
    double yaw_rad = 0;
  };
  double side_m = 0;
  std::vector<Box> boxes;
  std::vector<Pose2> robots;
};

/// The layout is drawn with a generator of its own, so that every simulator can be given the very same one.
Sb12Scene sb12_scene(int robots);
/// As the rivals' programs read it: "arena SIDE", "box X Y LENGTH WIDTH YAW", "robot X Y YAW" [m, rad].
std::string sb12_text(const Sb12Scene& scene);

enum class Eyes { IdealRays, Sonar3m, Sonar6m };

/// Walls and boxes, all smooth: ideal rays do not mind, sonars lose echoes on them.
std::shared_ptr<const sim::Ground> sb12_ground(const Sb12Scene& scene);
std::shared_ptr<const sim::RobotModel> sb12_robot(Eyes eyes);

/// Drives every robot by the latch avoider: ahead at 0.3 m/s until something in front is nearer than 0.5 m, then it
/// turns on the spot at 0.2 m/s a wheel towards the side that is freer at that moment until 0.7 m are free.
class Sb12Run {
 public:
  /// Stops the program where the simulation cannot be made.
  explicit Sb12Run(sim::SimulationConfig config);
  void reset(std::uint64_t seed, std::uint32_t episode);
  void step();
  /// Range that sensor 0..11 of a robot gives now; what is out of reach counts as reach_m.
  double range_m(int robot, int sensor, double reach_m) const;
  const sim::Simulation& simulation() const { return *simulation_; }

 private:
  std::unique_ptr<sim::Simulation> simulation_;
  std::vector<int> turning_;
  std::vector<SenseFrame> senses_;
  std::vector<ActFrame> acts_;
  std::size_t stride_;  // values from one sensor to the next
};

}  // namespace ganglion::bench
