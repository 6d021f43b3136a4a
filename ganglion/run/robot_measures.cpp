#include "ganglion/run/robot_measures.h"

#include <algorithm>
#include <cmath>

namespace ganglion {
namespace {

/// Ahead of a wall a robot cannot be asked to come closer than its behaviours avoid (0.40 m) and a little.
constexpr double kFarWallMargin_m = 0.5;
constexpr double kSquare_m = 0.25;
constexpr double kStill_mps = 0.005;

std::uint64_t square_of(Vector2 position) noexcept {
  const auto column = static_cast<std::int32_t>(std::floor(position.x / kSquare_m));
  const auto row = static_cast<std::int32_t>(std::floor(position.y / kSquare_m));
  return (std::uint64_t{static_cast<std::uint32_t>(column)} << 32) | static_cast<std::uint32_t>(row);
}

using Yardstick = double sim::GoalRecord::*;

double ratio_of(std::span<const sim::GoalRecord> goals, Yardstick yardstick) {
  double travelled_m = 0, shortest_m = 0;
  for (const sim::GoalRecord& goal : goals) {
    if (!std::isfinite(goal.*yardstick)) continue;
    travelled_m += goal.travelled_m;
    shortest_m += goal.*yardstick;
  }
  return shortest_m > 0 ? travelled_m / shortest_m : std::numeric_limits<double>::quiet_NaN();
}

void report_ratios(std::span<const sim::GoalRecord> reached, Yardstick yardstick, const std::string& suffix,
                   Measures& into) {
  const std::size_t few = std::min<std::size_t>(5, reached.size());
  into.emplace_back("travel_ratio_first" + suffix, ratio_of(reached.first(few), yardstick));
  into.emplace_back("travel_ratio_last" + suffix, ratio_of(reached.last(few), yardstick));
  into.emplace_back("travel_ratio_late" + suffix, ratio_of(reached.subspan(reached.size() / 2), yardstick));
}

}  // namespace

RobotMeasures::RobotMeasures(const sim::Ground& ground, const sim::Truth* start, double radius_m,
                             const Controller& controller, const FreeGround* free_ground)
    : known_(start != nullptr), free_ground_(free_ground) {
  find_signals(controller);
  if (!known_) return;
  start_ = start->pose.position;
  course_ = direction(start->pose.yaw.rad());
  far_wall_m_ = ground.far_wall_m(start_, course_);
  reach_m_ = far_wall_m_ - radius_m - kFarWallMargin_m;
  at_far_wall_ = reach_m_ <= 0;
  slopes_ = std::ranges::any_of(ground.plan().floor.zones, [](const sim::FloorZone& zone) { return zone.grade > 0; });
}

void RobotMeasures::find_signals(const Controller& controller) {
  const std::vector<Signal>& signals = controller.signals();
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const std::string& name = signals[i].name;
    if (name.ends_with(".stuck") || name.ends_with(".blind")) excuses_.push_back(i);
    if (const auto share = name.find(".share."); share != std::string::npos) {
      shares_.push_back({name.substr(share + 7) + "_share", i});
    }
  }
}

void RobotMeasures::update(double time_s, double step_s, const sim::Truth* truth, std::span<const double> values) {
  time_s_ = time_s;
  ++ticks_;
  for (Share& share : shares_) share.ticks += values[share.signal];
  if (truth != nullptr) witness(step_s, *truth, values);
}

void RobotMeasures::witness(double step_s, const sim::Truth& truth, std::span<const double> values) {
  const bool excused = std::any_of(excuses_.begin(), excuses_.end(), [&](std::size_t i) { return values[i] == 1; });
  const double way_m = truth.travelled_m - last_.travelled_m;
  if (excused && way_m < kStill_mps * step_s) {
    dwell_.interrupt();
  } else {
    dwell_.add(time_s_, truth.pose.position);
  }
  step_s_ = step_s;
  if (truth.stalled) ++stalled_ticks_;
  if (truth.tipped) ++tipped_ticks_;
  visited_.insert(square_of(truth.pose.position));
  last_ = truth;
  follow_course(truth);
}

void RobotMeasures::follow_course(const sim::Truth& truth) {
  progress_m_ = std::max(progress_m_, (truth.pose.position - start_).dot(course_));
  if (at_far_wall_ || free_ground_ == nullptr || free_ground_->empty()) return;
  const double ideal_m = std::min((*free_ground_)[std::min(ticks_, free_ground_->size()) - 1], reach_m_);
  progress_ratio_ = ideal_m > 0 ? std::min(progress_m_, reach_m_) / ideal_m : 1;
  at_far_wall_ = progress_m_ >= reach_m_;
  if (at_far_wall_) {  // what the way took, against what it would have taken on free ground
    const auto arrival = std::lower_bound(free_ground_->begin(), free_ground_->end(), reach_m_);
    progress_ratio_ = static_cast<double>(arrival - free_ground_->begin() + 1) / static_cast<double>(ticks_);
  }
}

void RobotMeasures::report(Measures& into) const {
  into.emplace_back("duration_s", time_s_);
  const auto put = [&](const char* name, double value) {
    into.emplace_back(name, known_ ? value : std::numeric_limits<double>::quiet_NaN());
  };
  put("travelled_m", last_.travelled_m);
  put("energy_J", last_.energy_J);
  put("contacts", last_.contacts);
  put("fastest_contact_mps", last_.fastest_contact_mps);
  put("progress_m", progress_m_);
  put("far_wall_m", far_wall_m_);
  const Vector2 way = last_.pose.position - start_;
  put("off_course_m", std::fabs(course_.x * way.y - course_.y * way.x));
  if (free_ground_ != nullptr) put("progress_ratio", progress_ratio_);
  put("dwell_s", dwell_.longest_s());
  put("explored_m2", static_cast<double>(visited_.size()) * kSquare_m * kSquare_m);
  if (slopes_) {
    put("stalled_s", stalled_ticks_ * step_s_);
    put("tipped_s", tipped_ticks_ * step_s_);
  }
  for (const Share& share : shares_) {
    into.emplace_back(share.name, ticks_ > 0 ? share.ticks / static_cast<double>(ticks_) : 0);
  }
}

void report_goals(std::span<const sim::GoalRecord> goals, Measures& into) {
  auto count = [&](auto&& which) { return static_cast<double>(std::count_if(goals.begin(), goals.end(), which)); };
  auto outcome = [&](sim::GoalOutcome wanted) {
    return count([=](const sim::GoalRecord& goal) { return goal.outcome == wanted; });
  };
  into.emplace_back("goals_set", static_cast<double>(goals.size()));
  into.emplace_back("goals_reached", outcome(sim::GoalOutcome::Reached));
  into.emplace_back("goals_withdrawn", outcome(sim::GoalOutcome::Withdrawn));
  into.emplace_back("goals_timed_out", outcome(sim::GoalOutcome::TimedOut));
  into.emplace_back("goals_unreachable", count([](const sim::GoalRecord& goal) { return !goal.reachable; }));
  into.emplace_back("goals_missed", count([](const sim::GoalRecord& goal) {
                      return goal.reachable && goal.outcome != sim::GoalOutcome::Reached &&
                             goal.outcome != sim::GoalOutcome::Replaced;
                    }));
  if (const double replaced = outcome(sim::GoalOutcome::Replaced); replaced > 0) {
    into.emplace_back("goals_replaced", replaced);
  }
  into.emplace_back("unreachable_withdrawn", count([](const sim::GoalRecord& goal) {
                      return !goal.reachable && goal.outcome == sim::GoalOutcome::Withdrawn;
                    }));
  std::vector<sim::GoalRecord> reached;
  for (const sim::GoalRecord& goal : goals) {
    if (goal.outcome == sim::GoalOutcome::Reached) reached.push_back(goal);
  }
  report_ratios(reached, &sim::GoalRecord::static_shortest_m, "", into);
  report_ratios(reached, &sim::GoalRecord::steered_shortest_m, "_steered", into);
}

}  // namespace ganglion
