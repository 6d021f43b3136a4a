#pragma once

#include <span>

#include "ganglion/module/command.h"
#include "ganglion/module/component.h"

namespace ganglion {

/// Makes one command of those that compete (ours; purple). Who wanted to drive, who drives and who was suppressed is
/// visible for every candidate.
class Coordinator : public Component {
 public:
  /// Fills shares[i] with the part that candidate i has in the result, in [0, 1]; 0 = overruled or inactive.
  /// A candidate that is inactive or has withdrawn has no part.
  virtual Command coordinate(const Feedback& feedback, std::span<const Command* const> candidates,
                             std::span<double> shares) noexcept = 0;
};

using CoordinatorKind = Kind<Coordinator>;

}  // namespace ganglion
