#pragma once

#include <memory>
#include <vector>

#include "ganglion/application/application.h"
#include "ganglion/sim/robot/robot_model.h"
#include "ganglion/sim/simulation/contact_memory.h"
#include "ganglion/sim/simulation/floor_ride.h"
#include "ganglion/sim/simulation/neighbours.h"

namespace ganglion::sim {

/// One simulated robot on the ground: its drive under commands that lapse, what it runs into, what that costs.
class Body {
 public:
  Body(const RobotModel& model, std::unique_ptr<Drive> drive);

  /// Takes the memory that a step among so many robots needs.
  void make_room(std::size_t robots);
  /// `chance` is the source of what the floor does to it.
  void reset(const Pose2& pose, const StreamId& chance) noexcept;
  /// A step begins: takes the commands, made finite and put within their limits.
  void begin(const ActFrame& frame, double step_s) noexcept;
  /// The way its centre goes in the step just begun if nothing stops it; +inf where that is not known, or where it does
  /// not drive steadily through the whole step.
  double steady_way_m(double step_s) const noexcept;
  /// Whether no surface of the ground can be touched within a way of that length.
  bool off_ground(const Ground& ground, double way_m) noexcept;
  /// The whole step at once, for a robot that drives steadily and meets nothing.
  void advance_freely(double step_s) noexcept;
  /// The sub-step [elapsed_s, elapsed_s + step_s) of that step, begun at time_s. Where the time to live ends within it,
  /// it is cut there. `all` holds this robot at index `self`.
  void advance(const World& world, Neighbours& all, std::size_t self, double elapsed_s, double time_s,
               double step_s) noexcept;
  /// The robots it ran into in the last sub-step, as indices, and how fast.
  struct Bump {
    std::size_t robot = 0;
    Vector2 normal{};  ///< Away from the other.
    double speed_mps = 0;
  };
  std::span<const Bump> bumps() const noexcept { return bumps_; }
  /// Another robot ran into this one. `normal` points away from it.
  void bumped(Vector2 normal, double speed_mps, double time_s) noexcept;

  const Truth& truth() const noexcept { return truth_; }
  /// The unit vector of its yaw.
  Vector2 ahead() const noexcept { return ahead_; }
  Disc disc() const noexcept { return {truth_.pose.position, model_->radius_m}; }

 private:
  void lapse(double step_s) noexcept;
  void move(const World& world, Neighbours& all, std::size_t self, double time_s, double step_s) noexcept;
  World::Slide slide(const World& world, Neighbours& all, std::size_t self, Vector2 displacement) noexcept;
  void go(const Movement& movement, Vector2 to, double path_m, double step_s) noexcept;
  void note_contact(Vector2 normal, double speed_mps, double time_s) noexcept;
  void note_bumps(Neighbours& all, std::size_t self, Vector2 normal, double speed_mps) noexcept;
  void spend(double energy_J) noexcept;
  /// The battery after a sub-step under that power, for the next one.
  void sag(double power_W) noexcept;

  const RobotModel* model_;
  std::unique_ptr<Drive> drive_;
  std::vector<double> command_, safe_;
  std::vector<Disc> near_;  // in the way, room for all other robots
  std::vector<Bump> bumps_;
  double ttl_s_ = 0;
  bool lapsed_ = false;
  double room_m_ = 0;  // no surface of the ground is nearer to the body than this
  ContactMemory contacts_;
  FloorRide ride_;
  Truth truth_;
  Vector2 ahead_{1, 0};
};

}  // namespace ganglion::sim
