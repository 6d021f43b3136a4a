#pragma once

#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

struct EncodersConfig {
  double resolution_m = 0;  ///< Way of one count; 0 = continuous.
  double left_scale = 1;    ///< Read over true way: wheels of other sizes than thought.
  double right_scale = 1;
};

/// Counts the turning of both sides. Channels `left`, `right` [m]: way of the rims since the reset, backwards counting
/// negative, cut off to whole counts. Wheels of a robot that is blocked go on turning, and so do the readings.
class Encoders final : public Sensor {
 public:
  explicit Encoders(const EncodersConfig& config) noexcept : config_(config) {}
  Limits limits(std::size_t) const noexcept override { return {-1e9, 1e9}; }
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  EncodersConfig config_;
};

extern const SensorKind encoders_kind;

}  // namespace ganglion::sim
