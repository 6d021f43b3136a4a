#pragma once

namespace ganglion::math {

/// The elementary functions of tick code: the same bits on every CPU, compiler and optimisation level, unlike libm's.
/// Thin over SLEEF's deterministic variants, error at most 1 ulp. What IEEE 754 fixes exactly (sqrt, fabs, floor,
/// fmod, arithmetic) may be used from the standard library.
double sin(double radians) noexcept;
double cos(double radians) noexcept;
double tan(double radians) noexcept;
double asin(double x) noexcept;
double acos(double x) noexcept;
double atan2(double y, double x) noexcept;
double exp(double x) noexcept;
double log(double x) noexcept;
double pow(double base, double exponent) noexcept;
double hypot(double x, double y) noexcept;

struct SinCos {
  double sin;
  double cos;
};
SinCos sincos(double radians) noexcept;

}  // namespace ganglion::math
