#include "ganglion/units/angle.h"

#include <cmath>

namespace ganglion {

double wrap_rad(double rad) noexcept {
  double turned = rad;
  if (!(std::fabs(rad) < 2 * kPi)) turned = std::fmod(rad, 2 * kPi);  // exact in IEEE 754, but slow
  if (turned > kPi) turned -= 2 * kPi;
  if (turned <= -kPi) turned += 2 * kPi;
  return turned;
}

Angle Angle::wrapped() const noexcept { return Angle{wrap_rad(rad_)}; }

double compass_deg_from_yaw(Angle yaw) noexcept {
  double bearing = std::fmod(90 - yaw.deg(), 360);
  if (bearing < 0) bearing += 360;
  return bearing >= 360 ? 0 : bearing;
}

Angle yaw_from_compass_deg(double bearing_deg) noexcept { return Angle::from_deg(90 - bearing_deg).wrapped(); }

}  // namespace ganglion
