#pragma once

#include "ganglion/module/coordinator.h"

namespace ganglion {

struct WeightedSumConfig {
  double least_weight = 0;  ///< A candidate that weighs this or less has no part.
};

/// Blends the candidates' commands, each as much as it weighs: command fusion.
///
/// Candidate commands.
/// Feedback  weights, optional: one for each candidate, in their order; unwired all weigh 1. A weight that is negative or
///           no number counts as 0.
/// Command   sum of weight times command over the sum of weights, of the candidates that act; it lives as long as the
///           shortest-lived of them. Inactive where none has a part; where all have withdrawn the first one's withdrawal.
///           A command of another width than the first that has a part is left out.
/// Share     weight over the sum of weights. A command that was blended counts as not carried out by any of them, so
///           nobody learns from it; one that acts alone has share 1.
/// Source    Acosta Amaya et al. (2014), references 10 to 14, name fusion as the other way of coordinating behaviours;
///           the mean by activation is ours.
class WeightedSum final : public Coordinator {
 public:
  explicit WeightedSum(const WeightedSumConfig& config) noexcept : config_(config) {}
  Command coordinate(const Feedback& feedback, std::span<const Command* const> candidates,
                     std::span<double> shares) noexcept override;

 private:
  /// What a candidate weighs; 0 = it has no part.
  double weight(const Feedback& feedback, std::span<const Command* const> candidates, std::size_t i) const noexcept;

  WeightedSumConfig config_;
};

extern const CoordinatorKind weighted_sum_kind;

}  // namespace ganglion
