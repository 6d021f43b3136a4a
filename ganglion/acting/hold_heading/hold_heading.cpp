#include "ganglion/acting/hold_heading/hold_heading.h"

#include <algorithm>
#include <cmath>

namespace ganglion {
namespace {

using subsumption::Preset;

// In the order of the ports in kind.cpp.
enum Input : std::size_t { kHeading, kDisplacedBy, kLeft, kRight, kCourse };
enum Output : std::size_t { kOriginal, kTarget, kError, kHeld, kBlind };

constexpr double kAlong_rad = 110 * kPi / 180;  // farther from the course a heading leads back, not along
constexpr double kInstant_s = 1e-6;             // rounding of times that were added up

float compass_deg(double yaw_rad) noexcept {
  return static_cast<float>(compass_deg_from_yaw(Angle::from_rad(yaw_rad)));
}

}  // namespace

Command HoldHeading::internal_propagation(const Request&, const Feedback& feedback) noexcept {
  return config_.preset == Preset::Listing ? listing(feedback) : recommended(feedback);
}

Command HoldHeading::listing(const Feedback& feedback) noexcept {
  const double wanted_rad = feedback.value(kCourse);
  const auto wanted_deg = std::isfinite(wanted_rad) ? std::optional<float>(compass_deg(wanted_rad)) : std::nullopt;
  const double heading_rad = feedback.value(kHeading);
  const float heading_deg = std::isfinite(heading_rad) ? compass_deg(heading_rad) : static_cast<float>(kUnknown);
  const Command command = navigator_.navigate(heading_deg, displaced(feedback), wanted_deg);
  course_rad_ = yaw_from_compass_deg(static_cast<double>(navigator_.course_deg())).rad();
  const double clockwise_deg = static_cast<double>(navigator_.target_deg() - navigator_.heading_deg());
  publish(yaw_from_compass_deg(static_cast<double>(navigator_.target_deg())).rad(),
          -Angle::from_deg(clockwise_deg).rad(), navigator_.held(), false);
  return command;
}

Command HoldHeading::recommended(const Feedback& feedback) noexcept {
  const double now_s = feedback.tick.time_s;
  const double heading_rad = feedback.value(kHeading);
  const double share = sonar_share(feedback);
  pending_ = pending_ || displaced(feedback);
  if (!std::isfinite(heading_rad)) return without_heading(feedback, share);
  heading_s_ = now_s;
  find_course(feedback, heading_rad);
  if (pending_) hold(heading_rad, feedback.tick);
  if (now_s < settled_s_) held_rad_ = heading_rad;
  const bool held = now_s < held_until_s_ - kInstant_s;
  const double target_rad = held ? held_target_rad(now_s) : course_rad_;
  const double error_rad = wrap_rad(target_rad - heading_rad);
  const bool stands = share == 0 || std::isnan(course_rad_);
  publish(target_rad, error_rad, held, share == 0);
  last_ = stands ? subsumption::tracks(0, 0) : steer(error_rad, share);
  return last_;
}

void HoldHeading::hold(double heading_rad, const Tick& tick) noexcept {
  pending_ = false;
  if (config_.hold_s <= 0) return;  // the held course is switched off
  if (tick.time_s > held_until_s_ + config_.calm_s) struggle_s_ = 0;
  struggle_s_ += tick.step_s;
  const double longest_s = std::max(config_.hold_s, config_.max_hold_s);
  held_rad_ = heading_rad;
  held_from_s_ = tick.time_s;
  held_until_s_ = tick.time_s + std::clamp(config_.hold_growth * struggle_s_, config_.hold_s, longest_s);
  settled_s_ = tick.time_s + config_.settle_s;
}

/// What is held along an obstacle goes back to the course little by little beyond hold_s, so that the robot feels its
/// way round. Out of a dead end it is held to its end: going back little by little would be a circle into it again.
double HoldHeading::held_target_rad(double now_s) const noexcept {
  const double sure_s = held_from_s_ + config_.hold_s;
  const double back_rad = wrap_rad(course_rad_ - held_rad_);
  if (now_s <= sure_s || !(std::fabs(back_rad) <= kAlong_rad)) return held_rad_;
  const double gone = (now_s - sure_s) / (held_until_s_ - sure_s);  // held: the end lies after now
  return wrap_rad(held_rad_ + config_.hold_return * gone * back_rad);
}

Command HoldHeading::without_heading(const Feedback& feedback, double share) const noexcept {
  const bool blind = share == 0 || feedback.tick.time_s - heading_s_ > config_.patience_s + kInstant_s;
  publish(kUnknown, kUnknown, false, blind);
  if (!blind) return last_;
  return subsumption::tracks(share * config_.blind_share * config_.forward_duty, 0);
}

Command HoldHeading::steer(double error_rad, double share) const noexcept {
  const double clockwise_deg = -Angle::from_rad(error_rad).deg();
  const double balance = std::clamp(1 - std::fabs(clockwise_deg) / config_.fade_deg, 0.0, 1.0);
  const double turn = std::clamp(config_.gain_per_deg * clockwise_deg, -1.0, 1.0);
  return subsumption::tracks(share * config_.forward_duty * balance, turn);
}

bool HoldHeading::displaced(const Feedback& feedback) const noexcept {
  const PortView& flags = feedback[kDisplacedBy];
  if (!flags.wired()) return !feedback.granted();
  return std::any_of(flags.values.begin(), flags.values.end(), [](double flag) { return flag > 0; });
}

void HoldHeading::find_course(const Feedback& feedback, double heading_rad) noexcept {
  if (feedback[kCourse].wired()) {
    const double wanted_rad = feedback.value(kCourse);
    if (std::isfinite(wanted_rad)) course_rad_ = wrap_rad(wanted_rad);
    return;
  }
  if (!std::isnan(course_rad_) || !new_reading(feedback)) return;
  if (const auto course_rad = learner_.learn(heading_rad)) course_rad_ = *course_rad;
}

/// A compass that has not measured again repeats itself: that is no agreement.
bool HoldHeading::new_reading(const Feedback& feedback) noexcept {
  const auto ages_s = feedback[kHeading].ages_s;
  const double measured_s = feedback.tick.time_s - (ages_s.empty() ? 0 : ages_s[0]);
  if (!(measured_s > measured_s_ + kInstant_s)) return false;
  measured_s_ = measured_s;
  return true;
}

/// The share of the speed ahead that the wired sonars allow; 0 = all of them are dead.
double HoldHeading::sonar_share(const Feedback& feedback) const noexcept {
  int wired = 0;
  int alive = 0;
  double nearest_m = kForever;
  for (const std::size_t port : {std::size_t{kLeft}, std::size_t{kRight}}) {
    if (!feedback[port].wired()) continue;
    ++wired;
    const double range_m = feedback.value(port);
    if (std::isnan(range_m)) continue;
    ++alive;
    nearest_m = std::min(nearest_m, range_m);
  }
  if (wired > 0 && alive == 0) return 0;
  const double share = std::clamp(nearest_m / config_.slow_range_m, config_.least_share, 1.0);
  return alive < wired ? share * config_.one_sonar_share : share;
}

void HoldHeading::publish(double target_rad, double error_rad, bool held, bool blind) const noexcept {
  put(kOriginal, course_rad_);
  put(kTarget, target_rad);
  put(kError, error_rad);
  put(kHeld, held ? 1 : 0);
  put(kBlind, blind ? 1 : 0);
}

}  // namespace ganglion
