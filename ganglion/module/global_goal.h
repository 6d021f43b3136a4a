#pragma once

#include <span>

#include "ganglion/module/component.h"
#include "ganglion/module/tick/request.h"

namespace ganglion {

/// What a goal wants of its acting module at this tick.
struct Bid {
  std::span<const double> values{};  ///< The request; empty = nothing wanted.
  int priority_class = 0;            ///< A higher class may pre-empt a lower one.
  double intensity = 1;              ///< Within a class the strongest wins; a challenger needs 0.1 more. In [0, 1].
  bool replaces = false;             ///< May replace its own pending request by other values (a trainer).
};

/// An intrinsic motivation of the controller (red in the GFM papers): asks, and is told what became of it.
class GlobalGoal : public Component {
 public:
  /// Makes up its mind, once a tick.
  void decide(const Tick& tick) noexcept { wanted_ = bid(Feedback{tick, links().inputs}); }
  /// What it wants since then.
  const Bid& wanted() const noexcept { return wanted_; }
  /// Its request was satisfied or withdrawn.
  virtual void concluded(RequestStatus, const Reason&) noexcept {}

 protected:
  virtual Bid bid(const Feedback& feedback) noexcept = 0;

 private:
  Bid wanted_{};
};

using GlobalGoalKind = Kind<GlobalGoal>;

}  // namespace ganglion
