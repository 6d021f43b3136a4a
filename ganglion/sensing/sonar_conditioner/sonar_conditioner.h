#pragma once

#include <array>
#include <limits>

#include "ganglion/module/sensing_module.h"
#include "ganglion/units/speed_of_sound.h"

namespace ganglion {

struct SonarConditionerConfig {
  double min_range_m = 0.02;
  double max_range_m = 3.0;
  double temperature_C = 20;
  double dead_after_s = 0.5;
  int readings = 3;
};

/// A sonar as the behaviours want it: one range, after REP-117.
///
/// Feedback  one of: echo_time [s], there and back, which is taken if both are wired; raw_range [m]. temperature
///           [deg C] of the air, optional, else the parameter.
/// Output    range [m], the median of the latest readings (of two the nearer); dead: 1 while there is none.
/// Missing   an echo time of 0 is no pulse: NaN. NaN, and a reading older than dead_after_s, is a dead sonar: NaN, and
///           what was read before is forgotten. Below min_range_m -inf, above max_range_m +inf; both take part in the
///           median. A sonar that repeats itself cannot be told from a robot that stands still: not looked for.
/// Source    ours (ruling 1.12); the speed of sound is the usual linear fit about 0 deg C.
class SonarConditioner final : public SensingModule {
 public:
  static constexpr int kMaxReadings = 3;

  explicit SonarConditioner(const SonarConditionerConfig& config) noexcept : config_(config) {}
  /// Fails with BadParameter unless min_range_m < max_range_m.
  static Result<void> judge(const SonarConditionerConfig& config);

 private:
  void perceive(const Feedback& feedback) noexcept override;
  double read(const Feedback& feedback, std::size_t port) const noexcept;
  double median() const noexcept;

  SonarConditionerConfig config_;
  std::array<double, kMaxReadings> latest_{};  ///< A ring.
  int count_ = 0;                              ///< Of readings so far; goes round, but never back below a full ring.
  double measured_s_ = -std::numeric_limits<double>::infinity();
};

extern const SensingModuleKind sonar_conditioner_kind;

}  // namespace ganglion
