#pragma once

#include "ganglion/sim/robot/first_order_lag.h"
#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

struct ThermometerConfig {
  double air_C = 20;          ///< Temperature of the air; zones of floor may be warmer.
  double noise_C = 0.1;       ///< Standard deviation of one reading.
  double bias_C = 0;          ///< Added to every reading.
  double lag_s = 0;           ///< Time constant of its body.
  double resolution_C = 0.5;  ///< Readings are multiples of it; 0 = as they are.
};

/// Temperature of the air at its mount. Channel `temperature` [degC]. Ours.
class Thermometer final : public Sensor {
 public:
  explicit Thermometer(const ThermometerConfig& config) noexcept : config_(config), lag_(config.lag_s) {}
  Limits limits(std::size_t) const noexcept override { return {-273.15, 1000}; }
  Result<void> reset(const Scene& scene, Draws draws) override;
  bool follows() const noexcept override { return config_.lag_s > 0; }
  void follow(const Scene& scene, double step_s) noexcept override;
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  double air_C(const Scene& scene) const noexcept;

  ThermometerConfig config_;
  FirstOrderLag lag_;
  double body_C_ = 0;
};

extern const SensorKind thermometer_kind;

}  // namespace ganglion::sim
