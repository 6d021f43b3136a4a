#pragma once

namespace ganglion::sim {

/// A first-order lag, exact for an input that stays constant over each step.
class FirstOrderLag {
 public:
  /// time_constant_s >= 0; 0 = no lag.
  explicit FirstOrderLag(double time_constant_s) noexcept : time_constant_s_(time_constant_s) {}
  /// The share of the way to its input that is gone in step_s: 1 - exp(-step / time constant).
  double share(double step_s) noexcept;
  double time_constant_s() const noexcept { return time_constant_s_; }

 private:
  double time_constant_s_;
  double step_s_ = -1;  ///< What share_ was worked out for.
  double share_ = 1;
};

}  // namespace ganglion::sim
