#include "ganglion/acting/pid_regulator/pid_regulator.h"

#include <algorithm>
#include <cmath>

#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

enum Input : std::size_t { kSetpoint, kValue };
enum Output : std::size_t { kError, kProportional, kIntegral, kDerivative };

}  // namespace

Result<void> PidRegulator::judge(const PidRegulatorConfig& config) {
  if (!(config.min < config.max)) {
    return fail(ErrorCode::BadParameter,
                {"min is {}, must be less than max = {}", "min es {}, debe ser menor que max = {}"}, config.min,
                config.max);
  }
  if (config.base < config.min || config.base > config.max) {
    return fail(
        ErrorCode::BadParameter,
        {"base is {}, must lie within the limits [{}, {}]", "base es {}, debe estar entre los límites [{}, {}]"},
        config.base, config.min, config.max);
  }
  return {};
}

double PidRegulator::difference(double to, double from) const noexcept {
  return config_.circular ? wrap_rad(to - from) : to - from;
}

void PidRegulator::rest() noexcept {
  integral_ = 0;
  derivative_ = 0;
  has_last_ = false;
}

void PidRegulator::derive(double value, const Tick& tick) noexcept {
  const double elapsed_s = tick.time_s - last_s_;
  if (has_last_ && elapsed_s > 0) {
    const double change = difference(value, last_value_);
    derivative_ = (config_.filter_s * derivative_ + config_.kd_s * change) / (config_.filter_s + elapsed_s);
  }
  last_value_ = value;
  last_s_ = tick.time_s;
  last_tick_ = tick.number;
  has_last_ = true;
}

Command PidRegulator::command(double whole) const noexcept {
  const auto cut = [this](double u) { return std::clamp(u, config_.min, config_.max); };
  if (config_.drives == PidRegulatorConfig::Drives::Single) return Command::act({cut(whole)});
  const double turn = whole - config_.base;
  return Command::act({cut(config_.base - turn), cut(config_.base + turn)});
}

Command PidRegulator::internal_propagation(const Request& request, const Feedback& feedback) noexcept {
  const double value = feedback.value(kValue), setpoint = request.values[0];
  const bool on = has_last_ && feedback.tick.number == last_tick_ + 1;
  if (!on) rest();
  if (!std::isfinite(value)) return Command::inactive();
  derive(value, feedback.tick);
  const double error = difference(setpoint, value);
  const double proportional = config_.kp * (error - (1 - config_.setpoint_weight) * setpoint);
  const double whole = config_.base + proportional + integral_ - derivative_;
  put(kError, error);
  put(kProportional, proportional);
  put(kIntegral, integral_);
  put(kDerivative, -derivative_);
  if (!on || feedback.granted()) {
    const double cut_off = std::clamp(whole, config_.min, config_.max) - whole;
    const double step_s = feedback.tick.step_s;
    integral_ +=
        config_.ki_per_s * error * step_s + cut_off * std::min(1.0, step_s / std::max(config_.tracking_s, 1e-9));
  }
  return command(whole);
}

}  // namespace ganglion
