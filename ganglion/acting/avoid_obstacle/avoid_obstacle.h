#pragma once

#include <memory>

#include "ganglion/acting/subsumption/subsumption.h"
#include "ganglion/module/acting_module.h"

namespace ganglion {

struct AvoidObstacleConfig {
  subsumption::Preset preset = subsumption::Preset::Recommended;
  double trigger_range_m = 0.40;
  double max_range_m = 3.0;
  double gain_per_m = 0.25;
  double straight_m = 0.10;
  double straight_hysteresis_m = 0.04;
  double forward_duty = 1.0 / 3;
  double fade_m = 1.0;
  double stop_range_m = 0.12;
  double commit_range_m = 0.25;
  double commit_s = 2.0;
  double min_turn_duty = 0.3;
  int commit_reversals = 3;
  double side_memory_s = 30;
  double undecided_m = 0.14;
  double one_sonar_share = 0.5;
};

/// Turns towards the side with more room while something is near. A behaviour: inactive where both sides are clear.
///
/// Feedback  left, right: ranges of the front sonars [m]; escaping: optional, 1 keeps this behaviour inactive.
/// Command   tracks {left, right}, duty. The turn is proportional to x = right - left; where both sides are about equal
///           it goes straight on.
/// Output    difference x [m]; side it has committed itself to: -1 left, 0 none, 1 right.
/// Missing   too close (-inf) counts as 0 m, nothing in range (+inf) as max_range_m. Of a dead sonar (NaN) the other is
///           compared with trigger_range_m, so that the robot turns away from what it still sees, at one_sonar_share of
///           the speed ahead; both dead: inactive.
/// Source    Alonso, "Desarrollo de un robot con arquitectura de subsuncion (robot Nimrod)", section 3 and subroutines
///           EVITAR, AJUSTE, AVANCE of section 5. Gain: 3 servo counts of 1200 for each centimetre.
/// Differs   recommended is continuous: the speed ahead falls with |x| and with the nearest range instead of stopping
///           between the bands; within commit_range_m, or when the freer side has changed commit_reversals times, it
///           commits to one side until it is clear and commit_s have passed, since the comparison alone swings to and
///           fro in a corner and before a post. Where both sides are about equal it commits to the side of last time:
///           in a pocket it then looks all round instead of shuttling between the two ends (all ours). listing is the
///           printed program, a dead sonar reading 0 m included. Its motor names are taken as swapped, or it would turn
///           towards obstacles.
class AvoidObstacle final : public ActingModule {
 public:
  explicit AvoidObstacle(const AvoidObstacleConfig& config) noexcept : config_(config) {}
  /// Fails with BadParameter where the ranges are not in order, or the listing preset meets a parameter that it fixes.
  static Result<void> judge(const AvoidObstacleConfig& config, const Parameters& parameters);

 private:
  void internal_adaptation(const Feedback&, Cost) noexcept override {}  // a reflex: nothing is learned
  Command internal_propagation(const Request& request, const Feedback& feedback) noexcept override;

  Command listing(const Feedback& feedback) const noexcept;
  Command recommended(const Feedback& feedback) noexcept;
  void commit(bool near, bool too_near, double difference_m, double now_s) noexcept;
  void count_reversal(double difference_m) noexcept;
  double side_to_take(double difference_m, double now_s) const noexcept;
  Command turn_and_go(double nearest_m, double difference_m, double share) noexcept;

  AvoidObstacleConfig config_;
  bool straight_ = false;
  double side_ = 0;
  double committed_until_s_ = 0;
  double leaning_ = 0;  ///< Side that was clearly freer last, in this encounter.
  int reversals_ = 0;   ///< How often that changed.
  double last_side_ = 0;
  double remembered_until_s_ = 0;
};

extern const ActingModuleKind avoid_obstacle_kind;

}  // namespace ganglion
