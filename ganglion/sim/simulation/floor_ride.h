#pragma once

#include "ganglion/random/draws.h"
#include "ganglion/sim/robot/robot_model.h"

namespace ganglion::sim {

/// What the floor makes of a robot's movements. Ours:
///   slip    each side loses the share of its way that the zone states, give or take what was drawn for the step; the
///           wheels, and so the encoders, turn as if nothing were lost. Unequal losses turn the body about its width.
///   slope   uphill the drive has the weight's share along the way to pull. In parts of what it can pull at all, on a
///           slope of climb_rad, that load is sin(slope along the way) / sin(climb_rad). The wheels turn slower and the
///           drive takes more power by the load; downhill it takes less, and gears keep it from going faster. Turning
///           on the spot is as on level ground. Steeper than climb_rad: no way uphill, turning goes on; steeper than
///           tip_rad: the robot tips over for good.
///   bump    turns the robot by a draw whenever its centre crosses.
class FloorRide {
 public:
  explicit FloorRide(const RobotModel& model) noexcept;
  /// An episode begins.
  void reset(const StreamId& stream) noexcept;
  /// A step begins.
  void begin() noexcept;
  /// What is left of a movement that begins where the robot is. Sets truth.stalled and truth.tipped.
  Movement over(const Floor& floor, const Movement& wanted, Truth& truth) noexcept;
  /// By how much the bumps on that way turn the robot.
  double jolt_rad(const Floor& floor, Vector2 before, Vector2 after) noexcept;

 private:
  Movement laden(Movement movement, double rise) const noexcept;

  const RobotModel* model_;
  double climb_grade_;
  double climb_sine_;
  double tip_grade_;
  StreamId stream_{};
  std::uint32_t steps_ = 0;  // begun so far
  std::uint32_t jolts_ = 0;  // so far
};

}  // namespace ganglion::sim
