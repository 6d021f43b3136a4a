#include "ganglion/math/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ganglion::math {

double quantile(std::vector<double> values, double p) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const double at = p * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  const double rest = at - static_cast<double>(low);
  if (rest == 0 || values[low] == values[high]) return values[low];  // also where one or both are infinite
  return values[low] + rest * (values[high] - values[low]);
}

}  // namespace ganglion::math
