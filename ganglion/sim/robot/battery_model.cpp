#include <algorithm>
#include <cmath>

#include "ganglion/sim/robot/robot_model.h"

namespace ganglion::sim {

double BatteryModel::voltage_V(double charge_left, double power_W) const noexcept {
  if (!(charge_left > 0)) return 0;
  const double half_open_V = (empty_V + (full_V - empty_V) * charge_left) / 2;
  return half_open_V + std::sqrt(std::max(half_open_V * half_open_V - resistance_ohm * power_W, 0.0));
}

}  // namespace ganglion::sim
