#pragma once

#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

struct BatteryConfig {
  double noise_V = 0.02;    ///< Standard deviation of one reading.
  double divider = 1;       ///< What the divider's resistors make of the voltage: read over true.
  int bits = 10;            ///< Of the converter; 0 = not rounded.
  double reference_V = 20;  ///< Full scale of the converter, before the divider.
};

/// What the robot has left, as its [battery] and [energy] have it. Channels `voltage` [V] at the terminals, sagging
/// with load and charge, through a converter that cuts off to whole counts; `charge` in [0, 1], as a fuel gauge knows
/// it (exact); `current` [A], the mean since the sensor fired last. Robots without a [battery] read NaN. Ours.
class Battery final : public Sensor {
 public:
  explicit Battery(const BatteryConfig& config) noexcept : config_(config) {}
  Limits limits(std::size_t channel) const noexcept override;
  Result<void> reset(const Scene& scene, Draws draws) override;
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  BatteryConfig config_;
  double fired_s_ = 0;
  double taken_J_ = 0;  // by then
};

extern const SensorKind battery_kind;

}  // namespace ganglion::sim
