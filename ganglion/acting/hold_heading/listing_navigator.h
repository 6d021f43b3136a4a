#pragma once

#include <optional>

#include "ganglion/module/tick/command.h"

namespace ganglion {

/// The navigation of the printed program with its variables: SP_RUMBO, RUMBO, heading and CONTADOR. All angles are
/// compass degrees, clockwise in [0, 360), as 32-bit floats; differences are not wrapped.
/// Source: Alonso, robot Nimrod, section 5: main loop, NAVEGAR, AJUSTE, AVANCE.
class ListingNavigator {
 public:
  /// One program cycle. `heading_deg` NaN keeps the last value, 0 at first; `displaced` says that EVITAR or ESCAPE ran
  /// in the cycle before; a `course_deg` from outside takes the place of the first heading.
  Command navigate(float heading_deg, bool displaced, std::optional<float> course_deg) noexcept;

  float course_deg() const noexcept { return sp_rumbo_; }
  /// What the last cycle steered, the heading it had, and whether that was a held course.
  float target_deg() const noexcept { return target_; }
  float heading_deg() const noexcept { return heading_; }
  bool held() const noexcept { return held_; }

 private:
  void count_cycle() noexcept;

  bool started_ = false;
  float heading_ = 0;
  float sp_rumbo_ = 0;
  float rumbo_ = 0;
  float target_ = 0;
  int contador_ = 0;
  bool rumbo_is_held_ = false;
  bool held_ = false;
};

}  // namespace ganglion
