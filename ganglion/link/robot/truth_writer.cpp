#include "ganglion/link/robot/truth_writer.h"

#include "ganglion/base/hash.h"

namespace ganglion::link {
namespace {

void write_goal(const sim::GoalRecord& goal, std::size_t index, wire::Goal& out) {
  out.set_index(static_cast<std::uint32_t>(index));
  out.set_tick(goal.tick);
  out.set_start_column(goal.start.column);
  out.set_start_row(goal.start.row);
  out.set_goal_column(goal.goal.column);
  out.set_goal_row(goal.goal.row);
  out.set_reachable(goal.reachable);
  out.set_shortest_m(goal.shortest_m);
  out.set_static_shortest_m(goal.static_shortest_m);
  out.set_steered_shortest_m(goal.steered_shortest_m);
  out.set_travelled_m(goal.travelled_m);
  out.set_ticks(goal.ticks);
  out.set_outcome(static_cast<std::uint32_t>(goal.outcome));
  out.set_reason(static_cast<std::uint32_t>(goal.reason));
}

}  // namespace

void GoalsTold::tell(const sim::TrainerLog& log, wire::Truth& out) {
  const auto goals = log.records();
  if (goals.size() < outcomes_.size()) outcomes_.clear();  // another episode
  for (std::size_t n = 0; n < goals.size(); ++n) {
    if (n < outcomes_.size() && outcomes_[n] == goals[n].outcome && outcomes_[n] != sim::GoalOutcome::Open) continue;
    write_goal(goals[n], n, *out.add_goals());
  }
  outcomes_.resize(goals.size());
  for (std::size_t n = 0; n < goals.size(); ++n) outcomes_[n] = goals[n].outcome;
  out.set_trained(true);
  out.set_goals_done(log.done());
}

void write_truth(const sim::Truth& truth, wire::Truth& out) {
  out.set_x_m(truth.pose.position.x);
  out.set_y_m(truth.pose.position.y);
  out.set_yaw_rad(truth.pose.yaw.rad());
  out.set_travelled_m(truth.travelled_m);
  out.set_energy_j(truth.energy_J);
  out.set_contacts(static_cast<std::uint32_t>(truth.contacts));
  out.set_fastest_contact_mps(truth.fastest_contact_mps);
  out.set_touched(truth.touched);
  out.set_stalled(truth.stalled);
  out.set_tipped(truth.tipped);
}

void write_movers(std::span<const sim::MoverState> movers, wire::Sense& out) {
  out.mutable_movers()->Clear();
  for (const sim::MoverState& mover : movers) {
    out.add_movers(mover.pose.position.x);
    out.add_movers(mover.pose.position.y);
    out.add_movers(mover.pose.yaw.rad());
  }
}

}  // namespace ganglion::link
