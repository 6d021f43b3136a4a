#pragma once

#include <utility>
#include <vector>

#include "ganglion/module/global_goal.h"

namespace ganglion {

struct ConstantConfig {
  std::vector<double> value = {0};  ///< One number for each value of the request.
  double intensity = 1;             ///< In [0, 1].
};

/// Wants the same values at every tick: a set-point to hold, a place to be (ours; the GFM papers name only App).
class ConstantGoal final : public GlobalGoal {
 public:
  explicit ConstantGoal(ConstantConfig config) noexcept : config_(std::move(config)) {}
  /// Fails with BadParameter unless there are 1 to 16 finite values.
  static Result<void> judge(const ConstantConfig& config);

 private:
  Bid bid(const Feedback&) noexcept override { return {config_.value, config_.intensity, false}; }

  ConstantConfig config_;
};

}  // namespace ganglion
