#pragma once

#include <span>

#include "ganglion/module/component.h"
#include "ganglion/module/tick/command.h"

namespace ganglion {

/// Makes one command of those that compete (ours; purple). Who wanted to drive, who drives and who was suppressed is
/// visible for every candidate.
class Coordinator : public Component {
 public:
  /// shares[i] comes in as 0 and is left as the part that candidate i has in the result, in [0, 1]; 0 = overruled. A
  /// candidate that is inactive or has withdrawn has no part, whatever is left there. From them follow the outputs that
  /// every coordinator has, and what each candidate hears of its command (Feedback::share): only one that was carried
  /// out whole and alone is learned from.
  virtual Command coordinate(const Feedback& feedback, std::span<const Command* const> candidates,
                             std::span<double> shares) noexcept = 0;
};

/// What is commanded where no candidate has a part: nothing, or where all have withdrawn the first one's withdrawal.
inline Command nobody_acts(std::span<const Command* const> candidates) noexcept {
  for (const Command* candidate : candidates) {
    if (candidate->kind != CommandKind::Withdraw) return Command::inactive();
  }
  return candidates.empty() ? Command::inactive() : *candidates.front();
}

using CoordinatorKind = Kind<Coordinator>;

}  // namespace ganglion
