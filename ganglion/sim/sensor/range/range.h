#pragma once

#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

struct RangeConfig {
  double min_range_m = 0;
  double max_range_m = 3;
  double noise_m = 0;  ///< Standard deviation of one reading.
};

/// One ideal ray ahead of its mount. Channel `range` [m]: the first surface, of whatever material and angle; +inf
/// beyond max_range_m, -inf nearer than min_range_m (REP-117).
class Range final : public Sensor {
 public:
  explicit Range(const RangeConfig& config) noexcept : config_(config) {}
  /// Fails with BadParameter unless min_range_m is less than max_range_m.
  static Result<void> judge(RangeConfig& config);
  bool remembers() const noexcept override { return false; }
  Limits limits(std::size_t) const noexcept override { return {config_.min_range_m, config_.max_range_m}; }
  double reach_m() const noexcept override { return config_.max_range_m; }
  std::span<const Vector2> rays() const noexcept override { return {&kAhead, 1}; }
  std::optional<Ranging> ranging() const noexcept override {
    return config_.noise_m > 0 ? std::nullopt : std::optional(ideal());
  }
  bool draws_normal() const noexcept override { return config_.noise_m > 0; }
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  Ranging ideal() const noexcept { return {config_.min_range_m, config_.max_range_m}; }
  static constexpr Vector2 kAhead{1, 0};
  RangeConfig config_;
};

extern const SensorKind range_kind;

}  // namespace ganglion::sim
