#pragma once

#include "ganglion/sim/robot/first_order_lag.h"
#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

struct TiltConfig {
  Angle noise = Angle::from_deg(0.5);  ///< Standard deviation of one reading.
  Angle roll_bias;                     ///< Added to every reading: a sensor not quite level in the body.
  Angle pitch_bias;
  double lag_s = 0;                 ///< Time constant of the pendulum or of the filter.
  Angle max = Angle::from_deg(60);  ///< Readings end there.
  Angle resolution;                 ///< Readings are multiples of it; 0 = as they are.
};

/// How the floor tilts the body. Channels `roll`, `pitch` [rad] of the sensor (REP-103: roll about x, positive with the
/// left side up; pitch about y, positive nose down), from the slope of the floor under its mount: with the rise g per
/// metre ahead and h per metre to the left, pitch = -atan g and roll = atan(h / sqrt(1 + g^2)). Ours.
class Tilt final : public Sensor {
 public:
  explicit Tilt(const TiltConfig& config) noexcept : config_(config), lag_(config.lag_s) {}
  Limits limits(std::size_t) const noexcept override { return {-config_.max.rad(), config_.max.rad()}; }
  Result<void> reset(const Scene& scene, Draws draws) override;
  bool follows() const noexcept override { return config_.lag_s > 0; }
  void follow(const Scene& scene, double step_s) noexcept override;
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  double read(double angle_rad) const noexcept;

  TiltConfig config_;
  FirstOrderLag lag_;
  double roll_rad_ = 0;  // lagging
  double pitch_rad_ = 0;
};

extern const SensorKind tilt_kind;

}  // namespace ganglion::sim
