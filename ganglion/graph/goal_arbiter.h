#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ganglion/module/global_goal.h"

namespace ganglion {

/// Decides which of its goals holds the request of one acting module.
///
/// A request is latched until it is satisfied or withdrawn. Free again, the highest class wins, then the strongest; who
/// held it last keeps it unless a challenger is 0.1 stronger. A pending request gives way only to a goal of a higher
/// class (where pre-emption is on) or to its own holder when that may replace it (a trainer). After k withdrawals in a
/// row a goal keeps still for 2^k ticks, k <= 8; a trainer's new request does not wait. One that asks once rests when it
/// was satisfied, until what is read differs from it again, other values are asked, or another goal had the module. A bid
/// that is not a number is no bid. For a standing request, a set-point, they compete at every tick, and where none wants anything it lapses.
///
/// Source    ours; the papers name only the goal "App".
class GoalArbiter {
 public:
  GoalArbiter(std::vector<GlobalGoal*> goals, bool preemption);
  /// First in a tick: tells the holder what became of its request, if anything did.
  void conclude(const Tick& tick, const RequestSlot& slot) noexcept;
  /// Then, once all goals have made up their minds: who asks now.
  void decide(const Tick& tick, RequestSlot& slot) noexcept;
  /// Whether the request under way is that goal's.
  bool holds(std::size_t goal) const noexcept { return open_ && holder_ == static_cast<int>(goal); }
  /// For how many more ticks that goal keeps still.
  std::uint32_t rests(std::size_t goal, const Tick& tick) const noexcept {
    const std::uint32_t until = members_[goal].rests_until;
    return until > tick.number ? until - tick.number : 0;
  }
  /// Index of the goal whose request is under way or was last; -1 = none yet.
  int holder() const noexcept { return holder_; }

 private:
  struct Member {
    GlobalGoal* goal;
    int withdrawals = 0;
    std::uint32_t rests_until = 0;
    std::array<double, kMaxCommandValues> asked{};  ///< What was last withdrawn or satisfied.
    int asked_size = 0;
    bool satisfied = false;  ///< It was, and nobody else had the module since.
    Bid bid{};
  };
  void decide_standing(const Tick& tick, RequestSlot& slot) noexcept;
  void hand_over(int next) noexcept;
  /// Who takes over from a pending request: a higher class, or its holder with other values; -1 = nobody.
  int successor(const Tick& tick, const RequestSlot& slot) noexcept;
  int strongest(const Tick& tick) const noexcept;
  int class_of(int index) const noexcept { return members_[static_cast<std::size_t>(index)].goal->priority_class(); }
  bool wants(const Member& member, const Tick& tick) const noexcept;

  std::vector<Member> members_;
  bool preemption_;
  int holder_ = -1;
  bool lost_ = false;  ///< What was satisfied last holds no more.
  bool open_ = false;  ///< The holder's request has not been concluded yet.
};

}  // namespace ganglion
