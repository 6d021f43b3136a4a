#pragma once

#include "ganglion/sim/robot/wheel_pair.h"

namespace ganglion::sim {

struct TrackedConfig : WheelPairConfig {
  double skid_factor = 1;  ///< Effective track width in turns over the true one.
};

/// Two tracks. They skid sideways in turns, so the body turns as if they stood `skid_factor` times as far apart.
/// Command `drive`: duties of left and right, each in [-1, 1], safe 0.
class Tracked final : public Drive {
 public:
  explicit Tracked(const TrackedConfig& config) noexcept : tracks_(widened(config)) {}

  CommandElement element(std::size_t n) const override { return wheel_pair_element(n); }
  void reset() noexcept override { tracks_.reset(); }
  void command(std::span<const double> values, const Pose2&, double, bool) noexcept override {
    tracks_.command(values[0], values[1]);
  }
  void supply(double share) noexcept override { tracks_.supply(share); }
  Movement move(const Pose2& pose, double step_s) noexcept override { return tracks_.move(pose, step_s); }
  double steady_mps() const noexcept override { return tracks_.steady_mps(); }
  Movement foreseen(const Pose2& pose, double step_s) const noexcept override { return tracks_.foreseen(pose, step_s); }

 private:
  static WheelPairConfig widened(TrackedConfig config) noexcept {
    config.track_m *= config.skid_factor;
    return config;
  }

  WheelPair tracks_;
};

extern const DriveKind tracked_kind;

}  // namespace ganglion::sim
