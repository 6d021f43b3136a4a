#pragma once

#include <vector>

#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

/// What a device says of a surface nearer than its blind zone.
enum class TooClose : std::uint8_t { MinusInfinity, Minimum };

struct SonarConfig {
  Angle cone = Angle::from_deg(40);  ///< Full opening angle: the -6 dB cone.
  int rays = 7;                      ///< Spread evenly over it.
  double min_range_m = 0.02;         ///< Blind zone.
  double max_range_m = 3.0;
  double noise_m = 0.01;        ///< Standard deviation of one reading.
  double resolution_m = 0.001;  ///< Readings are multiples of it; 0 = as they are.
  double dropout = 0;           ///< Probability that an echo is lost.
  /// Largest angle between the ray and a surface's normal at which its echo still comes back, by material.
  std::array<Angle, 3> incidence_limit = {Angle::from_deg(90), Angle::from_deg(22.5), Angle::from_deg(45)};
  double soft_range = 0.5;           ///< Soft surfaces answer up to this share of max_range_m.
  int mirror_bounces = 1;            ///< How often a ray without echo goes on along its mirror direction.
  double air_C = 20;                 ///< True temperature of the air, which the echo's time depends on.
  double assumed_C = 20;             ///< What the device takes it for when it gives a range.
  double no_echo_s = 0.0191;         ///< The echo time given when nothing answers.
  double too_close_echo_s = 115e-6;  ///< The echo time given within the blind zone.
  TooClose too_close = TooClose::MinusInfinity;
};

/// Speed of sound in dry air [m/s] at a temperature in deg C: 331.3 + 0.606 T.
constexpr double speed_of_sound_mps(double air_C) noexcept { return 331.3 + 0.606 * air_C; }

/// An ultrasonic ranger. The nearest of several rays over its cone that meets a surface within the incidence limit of
/// the surface's material gives the echo; a ray that does not goes on along its mirror direction, and what answers
/// there is read as a phantom at the length of the whole way. Other robots are rough surfaces.
///
/// Channel `range` [m]      +inf without echo, in the blind zone -inf (or the minimum, as the device does), NaN when
/// dead. Channel `echo_time` [s]  there and back; no_echo_s without echo, too_close_echo_s in the blind zone, 0 when
/// dead (the
///                          device gave no pulse).
/// Defaults are the Parallax PING's: 40 deg, 0.02..3.0 m, a pulse of 115 us at least, 3.29 m when nothing answers. An
/// SRF02: cone_deg 50, 0.16..6.0 m, resolution 0.01 m, period 0.07 s; a Polaroid: cone_deg 30.
/// Source    Kuc and Siegel, "Physically based simulation model for acoustic sensor robot navigation" (1987), for
/// mirror
///           reflection; the limit of 22.5 deg on a smooth wall is a measured one. Limits of the other materials are
///           ours.
/// Differs   Cross-talk between sensors is not modelled: fire them in turn with phase_s.
class Sonar final : public Sensor {
 public:
  explicit Sonar(const SonarConfig& config);
  Limits limits(std::size_t channel) const noexcept override;
  double reach_m() const noexcept override { return config_.max_range_m; }
  std::span<const Vector2> rays() const noexcept override { return rays_; }
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;
  void broken(std::span<double> values) const noexcept override;

  /// Range at which the echo comes from, without noise; +inf without echo.
  double echo_range_m(const Scene& scene) const noexcept;

 private:
  /// Length of the way to where ray n is answered, +inf where that is not less than within_m. `axis` is the sonar's
  /// own.
  double way_m(const Scene& scene, const Ray& axis, std::size_t n, double within_m) const noexcept;
  bool answers(const Hit& hit, Vector2 unit_direction, double way_m) const noexcept;

  SonarConfig config_;
  std::vector<Vector2> rays_;              // unit directions in the sensor's frame
  std::array<double, 3> cos_incidence_{};  // of the limits, by material
};

extern const SensorKind sonar_kind;

}  // namespace ganglion::sim
