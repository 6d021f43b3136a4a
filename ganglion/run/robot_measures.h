#pragma once

#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "ganglion/graph/controller.h"
#include "ganglion/run/criterion.h"
#include "ganglion/run/dwell.h"
#include "ganglion/sim/robot/trainer_log.h"
#include "ganglion/sim/robot/truth.h"
#include "ganglion/sim/world/ground.h"

namespace ganglion {

/// How far free ground would have taken the robot along its course, tick by tick: the yardstick of progress_ratio.
using FreeGround = std::vector<double>;

/// What is measured of one robot during a run, from the truth and not from its sensors. Where nobody knows the truth,
/// all but duration and shares are NaN.
///
///   duration_s            time simulated
///   travelled_m           way of the body's centre
///   energy_J              energy taken
///   contacts              contacts begun; pushing on is none
///   fastest_contact_mps   speed along the normal at which the hardest began
///   progress_m            farthest way along the heading of the start
///   off_course_m          distance at the end from the line along which it started
///   far_wall_m            way along it up to the first structural wall
///   progress_ratio        until the far wall: progress made / progress that free ground would have given in that time
///   dwell_s               longest time within some disc of 0.5 m; not while it stands still, `stuck` or `blind`
///   explored_m2           area of the 0.25 m squares the centre has been in
///   stalled_s, tipped_s   where the floor has slopes: time on ground too steep to climb, time fallen over
///   <id>_share            for each candidate of a coordinator the share of ticks it drove
class RobotMeasures {
 public:
  RobotMeasures(const sim::Ground& ground, const sim::Truth* start, double radius_m, const Controller& controller,
                const FreeGround* free_ground);
  /// After each step: the time now, the truth, and what the controller's signals were.
  void update(double time_s, double step_s, const sim::Truth* truth, std::span<const double> values);
  void report(Measures& into) const;
  bool at_far_wall() const noexcept { return at_far_wall_; }
  double progress_m() const noexcept { return progress_m_; }

 private:
  struct Share {
    std::string name;
    std::size_t signal;
    double ticks = 0;
  };
  void find_signals(const Controller& controller);
  void witness(double step_s, const sim::Truth& truth, std::span<const double> values);
  void follow_course(const sim::Truth& truth);

  bool known_;  ///< The truth.
  Vector2 start_{};
  Vector2 course_{};
  double far_wall_m_ = 0;
  double reach_m_ = 0;  ///< Progress at which the far wall counts as reached.
  const FreeGround* free_ground_;
  std::vector<Share> shares_;
  std::vector<std::size_t> excuses_;  ///< Signals that allow standing still.
  sim::Truth last_{};
  double time_s_ = 0;
  std::size_t ticks_ = 0;
  double progress_m_ = 0;
  double progress_ratio_ = 1;
  bool at_far_wall_ = false;
  bool slopes_ = false;
  double step_s_ = 0;
  double stalled_ticks_ = 0;
  double tipped_ticks_ = 0;
  Dwell dwell_{0.5, 1};
  std::unordered_set<std::uint64_t> visited_;  ///< Only counted, never walked through.
};

/// Measures of a trainer's goals: goals_set, goals_reached, goals_withdrawn, goals_timed_out, goals_unreachable,
/// goals_missed (reachable when set, yet not reached or replaced), unreachable_withdrawn, where there are any
/// goals_replaced, and travelled over shortest way of the first five and of the last five goals reached
/// (travel_ratio_first, travel_ratio_last) and of the second half (travel_ratio_late): over the shortest way of a robot
/// that turns on the spot, and, with `_steered` appended, over that of one that turns no more than the trainer's
/// max_turn_deg in a step. Movers aside, both.
void report_goals(std::span<const sim::GoalRecord> goals, Measures& into);

}  // namespace ganglion
