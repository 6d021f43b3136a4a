#pragma once

#include <memory>

#include "ganglion/module/coordinator.h"

namespace ganglion {

/// Subsumption with fixed priorities: the first candidate that commands drives, the others are suppressed.
///
/// Candidate commands, in falling priority.
/// Command   the winner's, with its time to live; where nobody commands inactive, and where all have withdrawn the
///           first one's withdrawal.
/// Source    Alonso, "Desarrollo de un robot con arquitectura de subsuncion (robot Nimrod)", sections 2 and 3;
///           R. Brooks, "A robust layered control system for a mobile robot" (1986).
class Priority final : public Coordinator {
 public:
  static Result<std::unique_ptr<Coordinator>> make(const Parameters& parameters);
  Command coordinate(const Feedback& feedback, std::span<const Command* const> candidates,
                     std::span<double> shares) noexcept override;
};

extern const CoordinatorKind priority_kind;

}  // namespace ganglion
