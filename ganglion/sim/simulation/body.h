#pragma once

#include <memory>
#include <vector>

#include "ganglion/application/application.h"
#include "ganglion/sim/robot/robot_model.h"
#include "ganglion/sim/simulation/contact_memory.h"
#include "ganglion/sim/simulation/crowd.h"
#include "ganglion/sim/simulation/floor_ride.h"

namespace ganglion::sim {

/// One simulated robot on the ground: its drive under commands that lapse, what it runs into, what that costs.
class Body {
 public:
  Body(const RobotModel& model, std::unique_ptr<Drive> drive);

  /// `chance` is the source of what the floor does to it.
  void reset(const Pose2& pose, const StreamId& chance) noexcept;
  /// A step begins: takes the commands, made finite and put within their limits.
  void begin(const ActFrame& frame, double step_s) noexcept;
  /// The way its centre goes in the step just begun if nothing stops it; +inf where that is not known, or where it does
  /// not drive steadily through the whole step.
  double steady_way_m(double step_s) const noexcept;
  /// Whether it touches no surface of the ground in the whole step, driving steadily a way of that length.
  bool off_ground(const Ground& ground, double way_m, double step_s) noexcept;
  /// Where it goes in the whole step, driving steadily: how near at least its centre comes to a point.
  double nearest_m(Vector2 point, double way_m, double step_s) const noexcept;
  /// The whole step at once, for a robot that drives steadily and meets nothing.
  void advance_freely(double step_s) noexcept;
  /// Takes from the drive what it wants to do in the sub-step [elapsed_s, elapsed_s + step_s) of that step. Where the
  /// time to live ends within it, what is wanted before and after is put together.
  void intend(const Floor& floor, double elapsed_s, double step_s) noexcept;
  /// The way its centre would then go, and the room that is known to be round it.
  Crowd::Wish wish() const noexcept { return {intent_.displacement, room_m_}; }
  /// That sub-step ends with the body at `to`, pressed against something or not.
  void settle(const Floor& floor, Vector2 to, bool pressed, double step_s) noexcept;
  /// It presses against something at time_s; `normal` points away from that. speed_mps is how fast they came together.
  void note_contact(Vector2 normal, double speed_mps, double time_s) noexcept;
  /// Another robot presses against this one. Touching ends when that goes away, unlike a wall.
  void lean() noexcept { truth_.touching = truth_.touched = leaning_ = true; }
  bool leaning() const noexcept { return leaning_; }
  /// No other robot touches it any more.
  void stand_alone() noexcept;

  /// See Drive::yields().
  bool yields() const noexcept { return drive_->yields(); }
  const Truth& truth() const noexcept { return truth_; }
  /// The unit vector of its yaw.
  Vector2 ahead() const noexcept { return ahead_; }
  Disc disc() const noexcept { return {truth_.pose.position, model_->radius_m}; }

 private:
  /// The way of a whole step, driving steadily: an arc lies between its chord and bulge_m beside it.
  struct Way {
    Vector2 chord{};
    double bulge_m = 0;
  };
  Way way(double way_m, double step_s) const noexcept;
  void lapse(double step_s) noexcept;
  void go(const Movement& movement, Vector2 to, double path_m, double step_s) noexcept;
  void spend(double energy_J) noexcept;
  /// The battery after a sub-step under that power, for the next one.
  void sag(double power_W) noexcept;

  const RobotModel* model_;
  std::unique_ptr<Drive> drive_;
  std::vector<double> command_, safe_;
  Movement intent_;       // of the present sub-step
  bool leaning_ = false;  // against a robot, when it was last pressed
  double ttl_s_ = 0;
  bool lapsed_ = false;
  double room_m_ = 0;  // no surface of the ground is nearer to the body than this
  ContactMemory contacts_;
  FloorRide ride_;
  Truth truth_;
  Vector2 ahead_{1, 0};
};

}  // namespace ganglion::sim
