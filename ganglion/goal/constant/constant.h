#pragma once

#include <array>

#include "ganglion/module/global_goal.h"

namespace ganglion {

struct ConstantGoalConfig {
  std::span<const double> value{};
  int priority_class = 0;
  double intensity = 1;  ///< In [0, 1].
};

/// Wants the same values at every tick: a set-point to hold, a place to be (ours; the GFM papers name only App).
class ConstantGoal final : public GlobalGoal {
 public:
  /// Fails with BadParameter unless there are 1 to 16 finite values.
  static Result<std::unique_ptr<ConstantGoal>> make(const ConstantGoalConfig& config);

 private:
  explicit ConstantGoal(const ConstantGoalConfig& config) noexcept;
  Bid bid(const Feedback& feedback) noexcept override;

  std::array<double, kMaxCommandValues> value_{};
  std::size_t size_;
  int priority_class_;
  double intensity_;
};

}  // namespace ganglion
