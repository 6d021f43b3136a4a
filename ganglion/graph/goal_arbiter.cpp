#include "ganglion/graph/goal_arbiter.h"

#include <algorithm>

namespace ganglion {
namespace {

constexpr double kChallenge = 0.1;
constexpr int kMostDoublings = 8;

bool same(std::span<const double> a, std::span<const double> b) noexcept {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace

GoalArbiter::GoalArbiter(std::vector<GlobalGoal*> goals, bool preemption) : preemption_(preemption) {
  for (GlobalGoal* goal : goals) members_.push_back({goal});
}

void GoalArbiter::conclude(const Tick& tick, const RequestSlot& slot) noexcept {
  Member& member = members_[static_cast<std::size_t>(holder_)];
  open_ = false;
  if (slot.status == RequestStatus::Withdrawn) {
    member.withdrawals = std::min(member.withdrawals + 1, kMostDoublings);
    member.rests_until = tick.number + (1u << member.withdrawals);
  } else {
    member.withdrawals = 0;
  }
  member.goal->concluded(slot.status, slot.reason);
}

bool GoalArbiter::wants(const Member& member, const Tick& tick) const noexcept {
  return !member.bid.values.empty() && (member.bid.replaces || tick.number >= member.rests_until);
}

int GoalArbiter::strongest(const Tick& tick) const noexcept {
  int best = -1;
  auto strength = [&](int index) {
    return members_[static_cast<std::size_t>(index)].bid.intensity + (index == holder_ ? kChallenge : 0);
  };
  for (int i = 0; i < static_cast<int>(members_.size()); ++i) {
    const Member& member = members_[static_cast<std::size_t>(i)];
    if (!wants(member, tick)) continue;
    if (best < 0) {
      best = i;
      continue;
    }
    const int best_class = members_[static_cast<std::size_t>(best)].bid.priority_class;
    const bool higher = member.bid.priority_class > best_class;
    const bool stronger = member.bid.priority_class == best_class && strength(i) > strength(best);
    if (higher || stronger) best = i;
  }
  return best;
}

void GoalArbiter::decide(const Tick& tick, RequestSlot& slot) noexcept {
  const bool ended = slot.status == RequestStatus::Satisfied || slot.status == RequestStatus::Withdrawn;
  if (open_ && ended) conclude(tick, slot);
  for (Member& member : members_) member.bid = member.goal->bid(tick);
  const int best = strongest(tick);
  if (best < 0) return;
  const Bid& bid = members_[static_cast<std::size_t>(best)].bid;
  if (open_) {
    Member& holder = members_[static_cast<std::size_t>(holder_)];
    const bool replaced = best == holder_ && bid.replaces && !same(bid.values, slot.span());
    const bool preempted = best != holder_ && preemption_ && bid.priority_class > holder.bid.priority_class;
    if (!replaced && !preempted) return;
    if (preempted) {
      const Reason reason{ReasonCode::Preempted, static_cast<double>(holder_), static_cast<double>(best)};
      holder.goal->concluded(RequestStatus::Withdrawn, reason);
    }
  }
  holder_ = best;
  open_ = true;
  slot.ask(bid.values);
}

}  // namespace ganglion
