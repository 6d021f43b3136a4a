#pragma once

#include <vector>

#include "ganglion/sim/robot/sensor.h"
#include "ganglion/units/speed_of_sound.h"

namespace ganglion::sim {

enum class SonarDevice : std::uint8_t { Ping, Srf02, Polaroid };

/// What a device says of a surface nearer than its blind zone.
enum class TooClose : std::uint8_t { MinusInfinity, Minimum };

/// By itself a Parallax PING.
struct SonarConfig {
  SonarDevice device = SonarDevice::Ping;
  Angle cone = Angle::from_deg(40);  ///< Full opening angle: the -6 dB cone.
  bool fading = false;               ///< Echoes from off the axis are weaker.
  int rays = 7;                      ///< Spread evenly over it.
  double min_range_m = 0.02;         ///< Blind zone.
  double max_range_m = 3.0;
  double noise_m = 0.01;        ///< Standard deviation of one reading.
  double resolution_m = 0.001;  ///< Readings are multiples of it; 0 = as they are.
  double dropout = 0;           ///< Probability that an echo is lost.
  /// Largest angle between the ray and a surface's normal at which its echo still comes back, by material.
  std::array<Angle, 3> incidence_limit = {Angle::from_deg(90), Angle::from_deg(22.5), Angle::from_deg(45)};
  double soft_range = 0.5;           ///< Soft surfaces answer up to this share of max_range_m.
  bool crosstalk = false;            ///< Hears the robot's other sonars that fire in the same slot.
  int mirror_bounces = 1;            ///< How often a ray without echo goes on along its mirror direction.
  double air_C = 20;                 ///< True temperature of the air, which the echo's time depends on.
  double assumed_C = 20;             ///< What the device takes it for when it gives a range.
  double no_echo_s = 0.0191;         ///< The echo time given when nothing answers.
  double too_close_echo_s = 115e-6;  ///< The echo time given within the blind zone.
  TooClose too_close = TooClose::MinusInfinity;
};

/// An ultrasonic ranger. The nearest of several rays over its cone that meets a surface within the incidence limit of
/// the surface's material gives the echo; a ray that does not goes on along its mirror direction, and what answers
/// there is read as a phantom at the length of the whole way. Other robots are rough surfaces.
///
/// Channel `range` [m]      +inf without echo, in the blind zone -inf (or the minimum, as the device does), NaN when
///                          dead.
/// Channel `echo_time` [s]  there and back; no_echo_s without echo, too_close_echo_s in the blind zone, 0 when dead
///                          (the device gave no pulse).
/// Devices: the Parallax PING, 40 deg, 0.02..3.0 m, a pulse of 115 us at least, 3.29 m when nothing answers; the
/// Devantech SRF02, 50 deg, 0.16..6.0 m in whole centimetres (give it a period of 0.07 s); the Polaroid 6500, 30 deg,
/// 0.41..10.7 m. Fading: seen off the axis by a of a half cone c the echo's amplitude is 2^-(a/c)^2, half (-6 dB) at
/// the rim; as echoes weaken with the square of the range, what is heard up to max_range_m on the axis is heard up to
/// max_range_m 2^-(a/c)^2/2 there, 0.71 of it at the rim (ours).
/// Source    Kuc and Siegel, "Physically based simulation model for acoustic sensor robot navigation" (1987), for
///           mirror reflection; the limit of 22.5 deg on a smooth wall is a measured one. Limits of the other materials
///           are ours.
/// Crosstalk, where it is asked for: another sonar of the robot that fires at the same moment sends its ping to a
/// surface within its cone and in its sight, and what this one hears of that, half the way from there over the surface
/// to here, is taken for an echo if it is the nearest (ours). Sonars of other robots are not heard. Fire them in turn
/// with phase_s.
class Sonar final : public Sensor {
 public:
  explicit Sonar(const SonarConfig& config);
  /// Takes from its device what `values` do not give: cone, ranges, resolution, echo times and what is too close. Fails
  /// with BadParameter unless min_range_m is less than max_range_m then.
  static Result<void> judge(SonarConfig& config, const Parameters& values);
  bool remembers() const noexcept override { return false; }
  Limits limits(std::size_t channel) const noexcept override;
  double reach_m() const noexcept override { return config_.max_range_m; }
  std::span<const Vector2> rays() const noexcept override { return rays_; }
  std::optional<double> ping_cos_half_cone() const noexcept override { return cos_half_cone_; }
  bool draws_normal() const noexcept override { return true; }
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;
  void broken(std::span<double> values) const noexcept override;

  /// Range at which the echo comes from, without noise; +inf without echo.
  double echo_range_m(const Scene& scene) const noexcept;

 private:
  /// Length of the way to where ray n is answered, +inf where that is not less than within_m. `axis` is the sonar's
  /// own.
  double way_m(const Scene& scene, const Ray& axis, std::size_t n, double within_m) const noexcept;
  /// Half the nearest way of another's ping over a surface to here, if it is less than within_m; else +inf.
  double crosstalk_m(const Scene& scene, double within_m) const noexcept;
  bool answers(const Sight::Incidence& met, double way_m) const noexcept;
  bool answers(const Hit& hit, Vector2 unit_direction, double way_m) const noexcept {
    return answers({-hit.normal.dot(unit_direction), hit.material}, way_m);
  }

  SonarConfig config_;
  std::vector<Vector2> rays_;        // unit directions in the sensor's frame
  std::vector<double> ray_reach_m_;  // +inf where echoes do not fade
  double cos_half_cone_ = 1;
  std::array<double, 3> cos_incidence_{};  // of the limits, by material
};

extern const SensorKind sonar_kind;

}  // namespace ganglion::sim
