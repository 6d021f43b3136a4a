#pragma once

#include <numbers>

namespace ganglion {

inline constexpr double kPi = std::numbers::pi;

/// An angle that knows its unit; counter-clockwise positive (REP-103).
class Angle {
 public:
  constexpr Angle() noexcept = default;
  static constexpr Angle from_rad(double rad) noexcept { return Angle{rad}; }
  static constexpr Angle from_deg(double deg) noexcept { return Angle{deg * kPi / 180}; }
  constexpr double rad() const noexcept { return rad_; }
  constexpr double deg() const noexcept { return rad_ * 180 / kPi; }
  /// The same direction, in (-pi, pi]; NaN stays NaN.
  Angle wrapped() const noexcept;

  friend constexpr Angle operator+(Angle a, Angle b) noexcept { return Angle{a.rad_ + b.rad_}; }
  friend constexpr Angle operator-(Angle a, Angle b) noexcept { return Angle{a.rad_ - b.rad_}; }
  friend constexpr Angle operator-(Angle a) noexcept { return Angle{-a.rad_}; }
  friend constexpr Angle operator*(Angle a, double factor) noexcept { return Angle{a.rad_ * factor}; }
  friend constexpr bool operator==(Angle a, Angle b) noexcept = default;

 private:
  constexpr explicit Angle(double rad) noexcept : rad_(rad) {}
  double rad_ = 0;
};

/// The same direction in (-pi, pi], for angles that come as plain numbers on ports.
double wrap_rad(double rad) noexcept;

/// A compass bearing in degrees, clockwise from north in [0, 360), of a yaw counter-clockwise from east: (90 - yaw) mod
/// 360.
double compass_deg_from_yaw(Angle yaw) noexcept;
/// The yaw in (-pi, pi] of a compass bearing in degrees.
Angle yaw_from_compass_deg(double bearing_deg) noexcept;

}  // namespace ganglion
