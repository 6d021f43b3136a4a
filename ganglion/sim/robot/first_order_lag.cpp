#include "ganglion/sim/robot/first_order_lag.h"

#include "ganglion/math/functions.h"

namespace ganglion::sim {

double FirstOrderLag::share(double step_s) noexcept {
  if (time_constant_s_ <= 0) return 1;
  if (step_s != step_s_) {
    step_s_ = step_s;
    share_ = 1 - math::exp(-step_s / time_constant_s_);
  }
  return share_;
}

}  // namespace ganglion::sim
