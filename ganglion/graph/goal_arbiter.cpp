#include "ganglion/graph/goal_arbiter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ganglion {
namespace {

constexpr double kChallenge = 0.1;
constexpr int kMostDoublings = 8;

bool same(std::span<const double> a, std::span<const double> b) noexcept {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// A goal whose drive or request is not a number has lost its reading: it asks for nothing.
bool is_number(const Bid& bid) noexcept {
  return std::isfinite(bid.intensity) &&
         std::all_of(bid.values.begin(), bid.values.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

GoalArbiter::GoalArbiter(std::vector<GlobalGoal*> goals, bool preemption) : preemption_(preemption) {
  for (GlobalGoal* goal : goals) members_.push_back({goal});
}

void GoalArbiter::conclude(const Tick& tick, const RequestSlot& slot) noexcept {
  const bool ended = slot.status == RequestStatus::Satisfied || slot.status == RequestStatus::Withdrawn;
  if (!open_ || !ended) return;
  Member& member = members_[static_cast<std::size_t>(holder_)];
  open_ = false;
  member.satisfied = slot.status == RequestStatus::Satisfied;
  std::copy_n(slot.values.begin(), slot.size, member.asked.begin());
  member.asked_size = slot.size;
  if (member.satisfied) {
    member.withdrawals = 0;
  } else {
    member.withdrawals = std::min(member.withdrawals + 1, kMostDoublings);
    member.rests_until = tick.number + (1u << member.withdrawals);
  }
  member.goal->concluded(slot.status, slot.reason);
}

bool GoalArbiter::wants(const Member& member, const Tick& tick) const noexcept {
  if (member.bid.values.empty()) return false;
  const std::span<const double> asked(member.asked.data(), static_cast<std::size_t>(member.asked_size));
  const bool again = same(member.bid.values, asked);
  if (member.bid.once && member.satisfied && again && !lost_) return false;
  return tick.number >= member.rests_until || (member.bid.replaces && !again);
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
    const bool higher = class_of(i) > class_of(best);
    const bool stronger = class_of(i) == class_of(best) && strength(i) > strength(best);
    if (higher || stronger) best = i;
  }
  return best;
}

int GoalArbiter::successor(const Tick& tick, const RequestSlot& slot) noexcept {
  const Bid& own = members_[static_cast<std::size_t>(holder_)].bid;
  const int best = strongest(tick);
  const bool higher = best >= 0 && class_of(best) > class_of(holder_);
  if (preemption_ && higher && best != holder_) return best;
  return own.replaces && !own.values.empty() && !same(own.values, slot.span()) ? holder_ : -1;
}

void GoalArbiter::decide(const Tick& tick, RequestSlot& slot) noexcept {
  lost_ = slot.lost;
  for (Member& member : members_) {
    member.bid = is_number(member.goal->wanted()) ? member.goal->wanted() : Bid{};
    if (member.bid.values.empty()) member.satisfied = false;  // a wish that comes back is a wish
  }
  if (slot.standing) return decide_standing(tick, slot);
  const int next = open_ ? successor(tick, slot) : strongest(tick);
  if (next < 0) return;
  hand_over(next);
  slot.ask(members_[static_cast<std::size_t>(next)].bid.values);
}

void GoalArbiter::decide_standing(const Tick& tick, RequestSlot& slot) noexcept {
  const int next = strongest(tick);
  if (next >= 0) {
    hand_over(next);
    slot.keep_asking(members_[static_cast<std::size_t>(next)].bid.values, std::numeric_limits<double>::infinity());
  } else if (open_) {
    open_ = false;
    slot.clear();
  }
}

void GoalArbiter::hand_over(int next) noexcept {
  if (open_ && next != holder_) {
    const Reason reason{ReasonCode::Preempted, static_cast<double>(holder_), static_cast<double>(next)};
    members_[static_cast<std::size_t>(holder_)].goal->concluded(RequestStatus::Withdrawn, reason);
  }
  if (next != holder_ && holder_ >= 0) members_[static_cast<std::size_t>(holder_)].satisfied = false;
  holder_ = next;
  open_ = true;
}

}  // namespace ganglion
