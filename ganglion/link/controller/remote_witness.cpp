#include "ganglion/link/controller/remote_witness.h"

namespace ganglion::link {
namespace {

constexpr std::size_t kMaxGoals = 100'000;
constexpr auto kLastOutcome = static_cast<std::uint32_t>(sim::GoalOutcome::Replaced);

sim::GoalRecord read_goal(const wire::Goal& message) {
  sim::GoalRecord goal;
  goal.tick = message.tick();
  goal.start = {message.start_column(), message.start_row()};
  goal.goal = {message.goal_column(), message.goal_row()};
  goal.reachable = message.reachable();
  goal.shortest_m = message.shortest_m();
  goal.static_shortest_m = message.static_shortest_m();
  goal.steered_shortest_m = message.steered_shortest_m();
  goal.travelled_m = message.travelled_m();
  goal.ticks = message.ticks();
  goal.outcome = static_cast<sim::GoalOutcome>(message.outcome());
  goal.reason = static_cast<ReasonCode>(message.reason());
  return goal;
}

}  // namespace

RemoteWitness::RemoteWitness(const wire::Describe& describe)
    : truths_(describe.robots()),
      logs_(describe.robots()),
      mover_ids_(describe.movers().begin(), describe.movers().end()) {
  for (const std::string& id : mover_ids_) movers_.push_back({.id = id});
}

Result<void> RemoteWitness::take(const wire::Sense& sense, bool first) {
  if (sense.truths_size() != static_cast<int>(truths_.size()) ||
      sense.movers_size() != static_cast<int>(3 * movers_.size())) {
    return fail(ErrorCode::BadParameter,
                {"the truth of {} robots and {} numbers of movers, described were {} and {} movers",
                 "la verdad de {} robots y {} números de obstáculos móviles; se describieron {} robots y {} obstáculos "
                 "móviles"},
                sense.truths_size(), sense.movers_size(), truths_.size(), movers_.size());
  }
  for (std::size_t n = 0; n < truths_.size(); ++n) {
    const wire::Truth& message = sense.truths(static_cast<int>(n));
    sim::Truth& truth = truths_[n];
    truth.pose = {{message.x_m(), message.y_m()}, Angle::from_rad(message.yaw_rad())};
    if (first) truth.start = truth.pose;
    truth.travelled_m = message.travelled_m();
    truth.energy_J = message.energy_j();
    truth.contacts = static_cast<int>(message.contacts());
    truth.fastest_contact_mps = message.fastest_contact_mps();
    truth.touched = message.touched();
    truth.stalled = message.stalled();
    truth.tipped = message.tipped();
    if (first) logs_[n].goals.clear();
    if (auto taken = take_goals(message, logs_[n]); !taken) return taken;
  }
  for (std::size_t n = 0; n < movers_.size(); ++n) {
    const int at = static_cast<int>(3 * n);
    movers_[n].pose = {{sense.movers(at), sense.movers(at + 1)}, Angle::from_rad(sense.movers(at + 2))};
  }
  return {};
}

Result<void> RemoteWitness::take_goals(const wire::Truth& message, Log& log) {
  log.trained = message.trained();
  log.all_done = message.goals_done();
  for (const wire::Goal& goal : message.goals()) {
    if (goal.index() > log.goals.size() || goal.index() >= kMaxGoals || goal.outcome() > kLastOutcome ||
        goal.reason() > 0xFF) {
      return fail(ErrorCode::BadParameter,
                  {"goal {} with outcome {}, after {} goals", "objetivo {} con resultado {}, tras {} objetivos"},
                  goal.index(), goal.outcome(), log.goals.size());
    }
    if (goal.index() == log.goals.size()) log.goals.emplace_back();
    log.goals[goal.index()] = read_goal(goal);
  }
  return {};
}

const sim::TrainerLog* RemoteWitness::trainer_log(int robot) const noexcept {
  const Log& log = logs_[static_cast<std::size_t>(robot)];
  return log.trained ? &log : nullptr;
}

}  // namespace ganglion::link
