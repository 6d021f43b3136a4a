#pragma once

#include "ganglion/sim/robot/drive.h"

namespace ganglion::sim {

struct StepperConfig {
  double cell_m = 0.5;
  Angle max_turn = Angle::from_deg(45);  ///< In one step.
};

/// Carries a robot from the centre of one cell of the world's grid to the centre of a neighbouring one, a whole move in
/// each step: the application the pathfinder of the GFM papers drives. Cells: floor(position / cell_m).
///
/// Command  `step`: motion -1 back, 0 stay, 1 forward; direction_rad, the direction of travel in the world's frame,
///          taken to the nearest multiple of 45 deg. Safe: stay.
/// Heading  after a forward move the direction, after a backward one the opposite; a command that would change it by
///          more than max_turn is not carried out.
/// Contact  stops the move; the body goes back to the centre and the heading it came from, so that a failed step
///          changes nothing but the contact. A move takes half of the step, so that there is time for the way back.
/// Source   "A growing functional modules locomotion subsystem", section 5 (basic skill); the paper tells no more of
///          its simulation than cells, contact and direction of the goal: the rest is ours.
class Stepper final : public Drive {
 public:
  explicit Stepper(const StepperConfig& config) noexcept : config_(config) {}

  CommandElement element(std::size_t n) const override;
  void reset() noexcept override { leg_ = Leg::None; }
  void command(std::span<const double> values, const Pose2& pose, double step_s, bool fresh) noexcept override;
  Movement move(const Pose2& pose, double step_s) noexcept override;
  bool yields() const noexcept override { return false; }
  void feel(bool touched) noexcept override;

 private:
  enum class Leg { None, Out, Back };  // a leg ends when the body arrives, or, outwards, on contact
  Vector2 centre_of(Vector2 position) const noexcept;

  StepperConfig config_;
  Leg leg_ = Leg::None;
  Pose2 origin_{};
  Pose2 target_{};
  double speed_mps_ = 0;
  bool arrives_ = false;  // with the present sub-step
};

extern const DriveKind stepper_kind;

}  // namespace ganglion::sim
