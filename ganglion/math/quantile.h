#pragma once

#include <vector>

namespace ganglion::math {

/// The p-quantile of values, 0 <= p <= 1, by linear interpolation between neighbours (Hyndman and Fan's type 7, the
/// default of R). NaN are left out, infinities count. NaN for no values.
double quantile(std::vector<double> values, double p);

}  // namespace ganglion::math
