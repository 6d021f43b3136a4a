#pragma once

#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

/// A contact ring round the body. Channel `contact`: 1 if the robot touched anything since the last firing, else 0.
class Bumper final : public Sensor {
 public:
  Limits limits(std::size_t) const noexcept override { return {0, 1}; }
  Result<void> reset(const Scene& scene, Draws draws) override;
  bool follows() const noexcept override { return true; }
  void follow(const Scene& scene, double step_s) noexcept override;
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  bool touched_ = false;
};

extern const SensorKind bumper_kind;

}  // namespace ganglion::sim
