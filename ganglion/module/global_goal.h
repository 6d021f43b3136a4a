#pragma once

#include <span>

#include "ganglion/module/component.h"
#include "ganglion/module/tick/request.h"

namespace ganglion {

/// What a goal wants of its acting module at this tick.
struct Bid {
  std::span<const double> values{};  ///< The request; empty = nothing wanted.
  double intensity = 1;              ///< Within a class the strongest wins; a challenger needs 0.1 more. In [0, 1].
  bool replaces = false;             ///< May replace its own pending request by other values (a trainer).
  bool once = false;                 ///< Rests while what it was satisfied by holds; else it is asked again at once.
};

/// An intrinsic motivation of the controller (red in the GFM papers): asks, and is told what became of it.
class GlobalGoal : public Component {
 public:
  /// Its class among goals of the same module: a higher one may pre-empt a lower one. Given once, before the first tick.
  void rank(int priority_class) noexcept { priority_class_ = priority_class; }
  int priority_class() const noexcept { return priority_class_; }
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
  int priority_class_ = 0;
};

using GlobalGoalKind = Kind<GlobalGoal>;

}  // namespace ganglion
