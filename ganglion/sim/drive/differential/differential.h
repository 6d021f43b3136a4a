#pragma once

#include "ganglion/sim/robot/wheel_pair.h"

namespace ganglion::sim {

/// Two driven wheels on one axle. Command `drive`: duties of left and right, each in [-1, 1], safe 0.
class Differential final : public Drive {
 public:
  explicit Differential(const WheelPairConfig& config) noexcept : wheels_(config) {}

  CommandElement element(std::size_t n) const override { return wheel_pair_element(n); }
  void reset() noexcept override { wheels_.reset(); }
  void command(std::span<const double> values, const Pose2&, double, bool) noexcept override {
    wheels_.command(values[0], values[1]);
  }
  void supply(double share) noexcept override { wheels_.supply(share); }
  Movement move(const Pose2& pose, double step_s) noexcept override { return wheels_.move(pose, step_s); }
  double steady_mps() const noexcept override { return wheels_.steady_mps(); }
  Movement foreseen(const Pose2& pose, double step_s) const noexcept override { return wheels_.foreseen(pose, step_s); }

 private:
  WheelPair wheels_;
};

extern const DriveKind differential_kind;

}  // namespace ganglion::sim
