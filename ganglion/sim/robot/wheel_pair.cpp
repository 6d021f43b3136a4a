#include "ganglion/sim/robot/wheel_pair.h"

#include <cmath>

#include "ganglion/math/functions.h"

namespace ganglion::sim {
namespace {

/// sin(x) / x, also near 0.
double sinc(double x) noexcept { return std::fabs(x) < 1e-4 ? 1 - x * x / 6 : math::sin(x) / x; }

constexpr double kSettled_mps = 1e-6;  // a lag never quite ends

}  // namespace

void WheelPair::reset() noexcept {
  left_ = right_ = Side{};
  supply_ = 1;
}

void WheelPair::command(double left_duty, double right_duty) noexcept {
  left_.duty = left_duty;
  right_.duty = right_duty;
}

double WheelPair::wanted_mps(const Side& side, double gain) const noexcept {
  const double moving_duty = std::fabs(side.duty) < config_.dead_zone ? 0 : side.duty;
  return moving_duty * gain * config_.full_scale_mps * supply_;
}

double WheelPair::steady_mps() const noexcept {
  const double left_mps = wanted_mps(left_, config_.left_gain), right_mps = wanted_mps(right_, config_.right_gain);
  const double missing_mps = std::fabs(left_mps - left_.speed_mps) + std::fabs(right_mps - right_.speed_mps);
  const double mean_mps = std::fabs(left_mps + right_mps) / 2;
  if (config_.lag_s <= 0 || missing_mps <= 0) return mean_mps;
  return missing_mps > kSettled_mps ? std::numeric_limits<double>::infinity() : mean_mps + kSettled_mps;
}

double WheelPair::roll(Side& side, double gain, double step_s) noexcept {
  const double wanted_mps = this->wanted_mps(side, gain);
  const double share = lag_.share(step_s);
  const double missing_mps = side.speed_mps - wanted_mps;
  side.speed_mps = wanted_mps + missing_mps * (1 - share);
  return wanted_mps * step_s + missing_mps * config_.lag_s * share;
}

Vector2 WheelPair::towards(double yaw_rad) noexcept {
  if (yaw_rad != towards_rad_) {
    towards_rad_ = yaw_rad;
    towards_ = direction(yaw_rad);
  }
  return towards_;
}

Movement WheelPair::move(const Pose2& pose, double step_s) noexcept {
  Movement movement;
  movement.left_m = roll(left_, config_.left_gain, step_s);
  movement.right_m = roll(right_, config_.right_gain, step_s);
  movement.turn_rad = (movement.right_m - movement.left_m) / config_.track_m;
  const double half_turn_rad = movement.turn_rad / 2;
  const double chord_m = (movement.left_m + movement.right_m) / 2 * sinc(half_turn_rad);
  if (chord_m != 0) movement.displacement = towards(pose.yaw.rad() + half_turn_rad) * chord_m;
  movement.path_m = std::fabs(movement.left_m + movement.right_m) / 2;
  movement.effort = (std::fabs(left_.duty) + std::fabs(right_.duty)) / 2;
  return movement;
}

CommandElement wheel_pair_element(std::size_t n) {
  return {.name = n == 0 ? "left" : "right", .unit = "", .min = -1, .max = 1, .safe = 0};
}

}  // namespace ganglion::sim
