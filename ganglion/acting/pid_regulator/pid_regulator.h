#pragma once

#include "ganglion/module/acting_module.h"

namespace ganglion {

struct PidRegulatorConfig {
  /// What is commanded: one value, or the duties of two tracks or wheels that turn by it.
  enum class Drives { Single, Tracks } drives = Drives::Single;
  double kp = 1;
  double ki_per_s = 0;
  double kd_s = 0;
  double setpoint_weight = 1;  ///< Of the set-point in the proportional part.
  double filter_s = 0;         ///< Time constant of the derivative's filter.
  double base = 0;             ///< Commanded where all parts are 0; of tracks the duty of both.
  double min = -1;             ///< Limits of the command.
  double max = 1;
  double tracking_s = 1;  ///< Time in which the integral gives up what the limits cut off; 0 = at once.
  bool circular = false;  ///< The value is an angle: errors go round the turn.
};

/// Holds a value at a set-point: the textbook regulator with proportional, integral and derivative parts.
///
/// Request   set-point, standing, in the unit of the value; the output `settled` is 1 while the value is within the
///           component's tolerance of it.
/// Feedback  value, required. While it is missing the module is inactive and its parts rest.
/// Command   u = base + kp (b r - y) + I - D, within [min, max]. D = kd dy/dt, filtered to first order: the set-point's
///           jumps make none. Single: u. Tracks: {left, right} = {base - v, base + v} for v = u - base, each within the
///           limits: a value that grows counter-clockwise, as a heading, is turned up by v > 0.
/// Output    error r - y; proportional, integral, derivative: the parts of u.
/// Integral  I grows by (ki e + (cut - whole) / tracking_s) step_s, where `whole` is u before the limits and `cut` after
///           them (back-calculation against windup). It rests while the command is not carried out whole and alone, and
///           starts anew when the module has not been asked for a while.
/// Errors    BadParameter unless min < max and min <= base <= max.
/// Source    Astrom and Hagglund, "Advanced PID Control" (2006), sections 3.4 (set-point weight, derivative filter) and
///           3.5 (back-calculation); standing requests and tracks are ours.
class PidRegulator final : public ActingModule {
 public:
  explicit PidRegulator(const PidRegulatorConfig& config) noexcept : config_(config) {}
  static Result<void> judge(const PidRegulatorConfig& config);
  /// The command is one value or two, the value an angle or not.
  static Result<Ports> shape(const Parameters& parameters);

 private:
  void internal_adaptation(const Feedback&, Cost) noexcept override {}  // its gains are given
  Command internal_propagation(const Request& request, const Feedback& feedback) noexcept override;

  double difference(double to, double from) const noexcept;
  /// Filtered rate of the value times kd; 0 where there is no reading before.
  void derive(double value, const Tick& tick) noexcept;
  Command command(double whole) const noexcept;
  void rest() noexcept;

  PidRegulatorConfig config_;
  double integral_ = 0;
  double derivative_ = 0;
  double last_value_ = 0;
  double last_s_ = 0;
  std::uint32_t last_tick_ = 0;
  bool has_last_ = false;
};

extern const ActingModuleKind pid_regulator_kind;

}  // namespace ganglion
