#pragma once

#include <array>
#include <memory>

#include "ganglion/acting/subsumption/subsumption.h"
#include "ganglion/module/acting_module.h"

namespace ganglion {

struct EscapeConfig {
  subsumption::Preset preset = subsumption::Preset::Recommended;
  double trigger_range_m = 0.10;
  double max_range_m = 3.0;
  double back_s = 2.0;
  double back_duty = 1.0 / 6;
  double turn_s = 1.5;
  double turn_duty = 0.3;
  int stuck_escapes = 3;
  double stuck_window_s = 20;
  double half_turn_s = 4.7;
};

/// Backs off and turns away once something is too near. A behaviour: it needs no request and is inactive otherwise.
///
/// Feedback  left, right: ranges of the front sonars [m]; heading [rad], optional; side, optional: the side another
///           behaviour turns to already.
/// Command   tracks {left, right}, duty. Each part of the manoeuvre has a budget of time and a time to live, so that it
///           lasts as long at any tick; a part begins with a tick. Once begun it runs to its end, whatever is read.
/// Output    stuck, from the beginning to the end of an escape that is one of many in a short time; phase.
/// Missing   too close (-inf) triggers; of a dead sonar (NaN) the other decides; both dead: inactive.
/// Source    Alonso, "Desarrollo de un robot con arquitectura de subsuncion (robot Nimrod)", section 3 and subroutine
///           ESCAPE of section 5: back 2.0 s, then clockwise 0.8 s at 1/6 (the text says 1.5 s).
/// Differs   recommended turns towards the wired side, or else the freer one (ours), clockwise where there is none, for
///           1.5 s and faster; when stuck, by 180 deg: measured where heading is wired, else by half_turn_s. listing
///           takes a dead sonar for one that reads 0 m, and so escapes for ever.
class Escape final : public ActingModule {
 public:
  enum class Phase { Idle = 0, Back = 1, Turn = 2, HalfTurn = 3 };
  static constexpr int kMaxStuckEscapes = 8;

  explicit Escape(const EscapeConfig& config) noexcept : config_(config) {}
  /// Puts in what the listing preset turns by, and that it is never stuck. Fails with BadParameter where that preset
  /// meets a parameter that it fixes.
  static Result<void> judge(EscapeConfig& config, const Parameters& parameters);

 private:
  void internal_adaptation(const Feedback&, Cost) noexcept override {}  // a reflex: nothing is learned
  Command internal_propagation(const Request& request, const Feedback& feedback) noexcept override;

  bool triggered(const Feedback& feedback) const noexcept;
  void begin(const Feedback& feedback) noexcept;
  void spend(const Feedback& feedback) noexcept;
  void begin_turn(const Feedback& feedback) noexcept;
  void measure_turn(const Feedback& feedback) noexcept;
  double freer_side(const Feedback& feedback) const noexcept;
  Command move(const Feedback& feedback) noexcept;

  EscapeConfig config_;
  Phase phase_ = Phase::Idle;
  bool stuck_ = false;
  double rest_s_ = 0;  ///< Of the present part.
  double then_s_ = 0;  ///< Time of the last tick of a manoeuvre, and for how long it was to move.
  double moves_s_ = 0;
  double clockwise_ = 1;     ///< 1 or -1
  double last_heading_ = 0;  ///< NaN while unknown.
  double turned_rad_ = 0;
  std::array<double, kMaxStuckEscapes> begun_s_{};  ///< Of the latest escapes, a ring.
  int escapes_ = 0;
};

extern const ActingModuleKind escape_kind;

}  // namespace ganglion
