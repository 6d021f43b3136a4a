#pragma once

#include <cstdint>

namespace ganglion {

/// The time of an application that goes by steps: of equal steps it is a product, not a sum, so that it does not drift.
class StepClock {
 public:
  double time_s() const noexcept { return time_s_; }
  /// When a step that begins now ends.
  double end_s(double step_s) noexcept {
    if (step_s != pace_s_) *this = {time_s_, step_s, time_s_, 0};
    return began_s_ + pace_s_ * (steps_ + 1);
  }
  /// It is over.
  void advance() noexcept { time_s_ = began_s_ + pace_s_ * ++steps_; }

  StepClock() = default;

 private:
  StepClock(double time_s, double pace_s, double began_s, std::uint32_t steps) noexcept
      : time_s_(time_s), pace_s_(pace_s), began_s_(began_s), steps_(steps) {}
  double time_s_ = 0;
  double pace_s_ = 0;   // length of the present run of equal steps
  double began_s_ = 0;  // when it began
  std::uint32_t steps_ = 0;
};

}  // namespace ganglion
