#pragma once

#include "ganglion/sim/robot/first_order_lag.h"
#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

struct DinsmoreCompassConfig {
  double centre_V = 2.5;
  double amplitude_V = 0.594;         ///< The one the listing's 107.14 deg/V fits (ours).
  double lag_s = 1;                   ///< Time constant of the damped needle.
  double noise_V = 0;                 ///< Standard deviation of one reading.
  int bits = 10;                      ///< Of the converter; 0 = not rounded.
  double reference_V = 5;             ///< Full scale of the converter.
  Angle north = Angle::from_deg(90);  ///< Direction of magnetic north in the world.
};

/// The analogue Dinsmore 1655: two voltages, sine and cosine of the bearing. Channels `va`, `vb` [V]:
///   va = centre + amplitude cos(bearing),   vb = centre + amplitude sin(bearing),
/// with the bearing clockwise from magnetic north, so that bearing = atan2(vb - centre, va - centre). The converter
/// cuts off to whole counts of reference / 2^bits.
///
/// The phase follows from the decoder in Nimrod's listing: around 90 deg it takes 45 + 107.14 (2.92 - VA) where VB is
/// the larger, so there VA falls through the centre while VB is high; around 270 deg VA rises while VB is low; around
/// 180 deg VB falls; around 0 deg it is 107.14 (VB - 2.5), VB rises while VA is high. Only cosine and sine of the
/// bearing do that.
/// Source    Nimrod, section 5 (listing); lag of about 1 s: the listing waits 1.5 s for the needle to settle.
class DinsmoreCompass final : public Sensor {
 public:
  explicit DinsmoreCompass(const DinsmoreCompassConfig& config) noexcept : config_(config), lag_(config.lag_s) {}
  Limits limits(std::size_t) const noexcept override { return {0, config_.reference_V}; }
  Result<void> reset(const Scene& scene, Draws draws) override;
  bool follows() const noexcept override { return true; }
  void follow(const Scene& scene, double step_s) noexcept override;
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  /// Cosine and sine of the sensor's bearing.
  Vector2 bearing(const Scene& scene) const noexcept;
  double converted_V(double volts) const noexcept;

  DinsmoreCompassConfig config_;
  FirstOrderLag lag_;
  Vector2 needle_{1, 0};  // cosine and sine, lagging
};

extern const SensorKind dinsmore_compass_kind;

}  // namespace ganglion::sim
