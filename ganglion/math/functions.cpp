#include "ganglion/math/functions.h"

#include <sleef.h>

namespace ganglion::math {

double sin(double radians) noexcept { return Sleef_cinz_sind1_u10purec(radians); }
double cos(double radians) noexcept { return Sleef_cinz_cosd1_u10purec(radians); }
double tan(double radians) noexcept { return Sleef_cinz_tand1_u10purec(radians); }
double asin(double x) noexcept { return Sleef_cinz_asind1_u10purec(x); }
double acos(double x) noexcept { return Sleef_cinz_acosd1_u10purec(x); }
double atan2(double y, double x) noexcept { return Sleef_cinz_atan2d1_u10purec(y, x); }
double exp(double x) noexcept { return Sleef_cinz_expd1_u10purec(x); }
double log(double x) noexcept { return Sleef_cinz_logd1_u10purec(x); }
double pow(double base, double exponent) noexcept { return Sleef_cinz_powd1_u10purec(base, exponent); }
double hypot(double x, double y) noexcept { return Sleef_cinz_hypotd1_u05purec(x, y); }

SinCos sincos(double radians) noexcept {
  const Sleef_double_2 both = Sleef_cinz_sincosd1_u10purec(radians);
  return {both.x, both.y};
}

}  // namespace ganglion::math
