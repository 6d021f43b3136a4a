#pragma once

#include <array>
#include <optional>

namespace ganglion {

/// Finds the course at the start from a compass that may still be settling (ours): the middle one of three readings
/// that agree. Angles in rad.
class CourseLearner {
 public:
  explicit CourseLearner(double agreement_rad) noexcept : agreement_rad_(agreement_rad) {}
  /// Takes a reading, not NaN; the course as soon as any three of the latest kReadings lie within the agreement.
  std::optional<double> learn(double heading_rad) noexcept;

 private:
  static constexpr int kReadings = 9;
  double agreement_rad_;
  std::array<double, kReadings> readings_{};
  int count_ = 0;  ///< Goes round, but never back below a full ring.
};

}  // namespace ganglion
