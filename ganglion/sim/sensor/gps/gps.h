#pragma once

#include "ganglion/sim/robot/sensor.h"

namespace ganglion::sim {

/// Where on the Earth the world's origin lies, and when: by default Medellín, 2026 (ours).
struct Datum {
  Angle latitude = Angle::from_deg(6.25);
  Angle longitude = Angle::from_deg(-75.57);
  double altitude_m = 1500;           ///< Above the ellipsoid.
  Angle north = Angle::from_deg(90);  ///< Direction of true north in the world.
  double utc_s = 1767225600;          ///< When an episode begins, seconds since 1970-01-01T00:00:00Z.
};

struct GpsConfig {
  Datum datum;
  double noise_m = 0.5;              ///< Standard deviation of one fix, along each of east and north.
  double drift_m = 1.5;              ///< Stationary standard deviation of the slow error, along each.
  double drift_s = 120;              ///< Its correlation time.
  double vertical_factor = 1.5;      ///< Errors of the altitude over those along the ground.
  double velocity_noise_mps = 0.05;  ///< Standard deviation of the velocity, along each of east and north.
  double course_from_mps = 0.1;      ///< Below that speed there is no course.
  double lost_every_s = 0;           ///< Mean time between two spells without a fix; 0 = never lost.
  double lost_for_s = 10;            ///< Mean length of a spell.
};

/// A satellite receiver. Each fix is the true place, plus white noise, plus a slow error: a first-order Gauss-Markov
/// process, a random walk drawn back to zero, which keeps it bounded. Spells without a fix begin and end as a two-state
/// Markov chain, so both lengths are exponential. Both are exact for any time between firings.
///
/// Channel `position` {x, y} [m]   the fix on the world's ground plane, as a receiver set up with the datum gives it.
/// Channels `latitude`, `longitude` [deg], `altitude` [m].
/// Channel `course` [rad]          course over ground in the world's frame, counter-clockwise from x; NaN when slower
///                                 than course_from_mps, where noise would make it up.
/// Channels `speed` [m/s], `utc` [s] since 1970, `fix` 1 or 0. Without a fix all but `utc` and `fix` are NaN: the
/// receiver's clock runs on.
/// Degrees are those of the tangent plane at the datum with the radii of WGS 84: 1 km off it is some 0.1 m wrong at
/// middle latitudes.
/// Source   WGS 84 (NIMA TR8350.2) for the radii; Gauss-Markov errors are the usual model of receivers
///          (Brown and Hwang, Introduction to random signals); the numbers are ours.
class Gps final : public Sensor {
 public:
  explicit Gps(const GpsConfig& config) noexcept;
  Limits limits(std::size_t channel) const noexcept override;
  double turn(std::size_t channel) const noexcept override { return channel == 2 ? 360 : 0; }  // longitude
  Result<void> reset(const Scene& scene, Draws draws) override;
  void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept override;

 private:
  /// East, north and up: how wrong slow drift makes a fix, of standard deviation 1.
  struct Drift {
    double east = 0, north = 0, up = 0;
  };
  void age(double step_s, Draws& draws) noexcept;

  GpsConfig config_;
  Vector2 east_, north_;  // unit vectors in the world
  double deg_per_m_north_ = 0, deg_per_m_east_ = 0;
  Drift drift_;
  bool lost_ = false;
  double fired_s_ = 0;
};

extern const SensorKind gps_kind;

}  // namespace ganglion::sim
