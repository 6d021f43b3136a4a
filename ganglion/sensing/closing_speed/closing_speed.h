#pragma once

#include <limits>

#include "ganglion/module/sensing_module.h"

namespace ganglion {

struct ClosingSpeedConfig {
  enum class Preset { Recommended, Listing };
  Preset preset = Preset::Recommended;
};

/// How fast something comes nearer.
///
/// Feedback  range [m].
/// Output    speed [m/s], > 0 while the range falls; acceleration [m/s^2], its rate.
/// Missing   a range that is not finite: both are NaN, and again until there are two (three) finite ones in a row.
/// Source    Alonso, "Desarrollo de un robot con arquitectura de subsuncion (robot Nimrod)", section 5, SENSORES, where
///           they are computed and not used.
/// Differs   recommended divides by the true time between the readings, and changes nothing while a sonar repeats
///           itself. listing divides by 0.3 s whatever its cycle takes, and begins with a range of 3 m at rest.
class ClosingSpeed final : public SensingModule {
 public:
  explicit ClosingSpeed(const ClosingSpeedConfig& config) noexcept;

 private:
  void perceive(const Feedback& feedback) noexcept override;
  void differentiate(double range_m, double dt_s) noexcept;
  void publish() const noexcept;

  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  bool listing_;
  double range_m_ = kUnknown;
  double speed_mps_ = kUnknown;
  double acceleration_mps2_ = kUnknown;
  double measured_s_ = 0;
};

extern const SensingModuleKind closing_speed_kind;

}  // namespace ganglion
