#include "ganglion/acting/hold_heading/course_learner.h"

#include <algorithm>
#include <cmath>

#include "ganglion/units/angle.h"

namespace ganglion {

std::optional<double> CourseLearner::learn(double heading_rad) noexcept {
  const int held = std::min(count_, kReadings);
  std::optional<double> course;
  // Round the new reading angles are short, so that the middle of three is well defined.
  for (int i = 0; i < held && !course; ++i) {
    for (int j = i + 1; j < held && !course; ++j) {
      const double a = wrap_rad(readings_[static_cast<std::size_t>(i)] - heading_rad);
      const double b = wrap_rad(readings_[static_cast<std::size_t>(j)] - heading_rad);
      const double low = std::min({a, b, 0.0});
      const double high = std::max({a, b, 0.0});
      if (high - low <= agreement_rad_) course = wrap_rad(heading_rad + (a + b - low - high));
    }
  }
  readings_[static_cast<std::size_t>(count_ % kReadings)] = heading_rad;
  if (++count_ == 2 * kReadings) count_ = kReadings;
  return course;
}

}  // namespace ganglion
