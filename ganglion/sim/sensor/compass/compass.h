#pragma once

#include "ganglion/sim/robot/first_order_lag.h"
#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

struct CompassConfig {
  Angle noise;                ///< Standard deviation of one reading.
  Angle bias;                 ///< Added to every reading.
  Angle local_bias;           ///< Amplitude of a bias that varies with the place.
  double local_length_m = 5;  ///< Over which that bias goes through one period.
  double lag_s = 0;
  Angle resolution;  ///< Readings are multiples of it; 0 = as they are.
};

/// Tells the heading. Channel `heading` [rad]: the yaw of the sensor in the world's frame, in (-pi, pi],
/// counter-clockwise from x; a compass bearing clockwise from north (y) is 90 deg minus that. With a lag the needle, a
/// unit vector, follows with that time constant. Iron in the building bends the field by local_bias sin(2 pi x / L)
/// cos(2 pi y / L) (ours). A CMPS03: resolution_deg 0.1, local_bias_deg 3.5.
class Compass final : public Sensor {
 public:
  explicit Compass(const CompassConfig& config) noexcept : config_(config), lag_(config.lag_s) {}
  bool remembers() const noexcept override { return config_.lag_s > 0; }
  Limits limits(std::size_t) const noexcept override { return {-kPi, kPi}; }
  Result<void> reset(const Scene& scene, Draws draws) override;
  bool follows() const noexcept override { return config_.lag_s > 0; }
  void follow(const Scene& scene, double step_s) noexcept override;
  bool draws_normal() const noexcept override { return config_.noise.rad() > 0; }
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  CompassConfig config_;
  FirstOrderLag lag_;
  Vector2 needle_{1, 0};
};

extern const SensorKind compass_kind;

}  // namespace ganglion::sim
