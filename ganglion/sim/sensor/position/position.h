#pragma once

#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

struct PositionConfig {
  double noise_m = 0;  ///< Standard deviation of each coordinate of one reading.
};

/// Tells where its mount is, in the world's frame: a tracking camera, a beacon system. Channel `position` {x, y} [m].
class Position final : public Sensor {
 public:
  explicit Position(const PositionConfig& config) noexcept : config_(config) {}
  bool remembers() const noexcept override { return false; }
  Limits limits(std::size_t) const noexcept override { return {-1e6, 1e6}; }
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  PositionConfig config_;
};

extern const SensorKind position_kind;

}  // namespace ganglion::sim
