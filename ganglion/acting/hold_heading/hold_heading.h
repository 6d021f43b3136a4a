#pragma once

#include <memory>

#include "ganglion/acting/hold_heading/course_learner.h"
#include "ganglion/acting/hold_heading/listing_navigator.h"
#include "ganglion/acting/subsumption/subsumption.h"
#include "ganglion/module/acting_module.h"
#include "ganglion/units/angle.h"

namespace ganglion {

struct HoldHeadingConfig {
  subsumption::Preset preset = subsumption::Preset::Recommended;
  double gain_per_deg = 0.0025;
  double forward_duty = 1.0 / 3;
  double fade_deg = 90;
  double hold_s = 3.0;
  double settle_s = 1.5;
  double hold_growth = 2.0;
  double max_hold_s = 48;
  double hold_return = 0;
  double calm_s = 5.0;
  Angle agreement = Angle::from_deg(5);
  double patience_s = 0.5;
  double blind_share = 0.5;
  double slow_range_m = 0.60;
  double least_share = 0.3;
  double one_sonar_share = 0.5;
};

/// Drives along a course by compass; after being displaced by another behaviour it holds for a while the heading which
/// that one left it with, so that it does not turn straight back to the obstacle. A behaviour, active in every tick.
///
/// Feedback  heading [rad]; displaced_by: flags of the behaviours above as they were in the tick before (wired
///           "escape.active@previous"; where nothing is wired, an own command that was overruled says the same); left,
///           right: sonars [m], optional; course [rad], optional, instead of the one learned at the start.
/// Command   tracks {left, right}, duty; a turn proportional to the error of heading, slower ahead the larger it is.
/// Output    original and target [rad] (NaN until known): the course wanted in the end, and now; error = target -
///           heading [rad], counter-clockwise; held: 1 while a held course is steered; blind: 1 while it goes without
///           a heading, or stops for want of sonars.
/// Missing   no heading: the last command for patience_s, then straight on at blind_share of the speed ahead, and it is
///           blind: what avoids and escapes still works. Sonars, where wired: one dead (NaN): one_sonar_share of the
///           speed ahead; all dead: it stops and is blind. Nothing in range: full speed.
/// Source    Alonso, "Desarrollo de un robot con arquitectura de subsuncion (robot Nimrod)", sections 3, 8 and the
///           program of section 5 (SP_RUMBO, RUMBO, CONTADOR; NAVEGAR, AJUSTE, AVANCE). Gain: 3 of 1200 counts per deg.
/// Differs   recommended (all of this ours) wraps the error, never stands between the bands and learns the course from
///           three readings that agree. It holds for hold_s, or hold_growth times as long as it was displaced since it
///           was last calm, since a course into a corner else leads back there for ever; for settle_s the held course
///           follows the heading, as a damped compass is behind after a turn. With hold_return what is held along an
///           obstacle goes back to the course little by little after hold_s. listing is the printed program: compass
///           degrees without wrap, the first heading is the course, 15 cycles of a held course (the text says 10),
///           bursts of 0.04 and 0.2 s; a heading that is not there keeps its last value, 0 deg at first; sonars are not
///           looked at.
class HoldHeading final : public ActingModule {
 public:
  explicit HoldHeading(const HoldHeadingConfig& config) noexcept : config_(config), learner_(config.agreement.rad()) {}
  /// Fails with BadParameter where the listing preset meets a parameter that it fixes.
  static Result<void> judge(const HoldHeadingConfig& config, const Parameters& parameters) {
    return subsumption::check_listing(config.preset, parameters);
  }

 private:
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  static constexpr double kForever = std::numeric_limits<double>::infinity();

  void internal_adaptation(const Feedback&, Cost) noexcept override {}  // the course is a reading, not a fit
  Command internal_propagation(const Request& request, const Feedback& feedback) noexcept override;

  Command listing(const Feedback& feedback) noexcept;
  Command recommended(const Feedback& feedback) noexcept;
  Command without_heading(const Feedback& feedback, double share) const noexcept;
  Command steer(double error_rad, double share) const noexcept;
  bool displaced(const Feedback& feedback) const noexcept;
  bool new_reading(const Feedback& feedback) noexcept;
  void hold(double heading_rad, const Tick& tick) noexcept;
  void find_course(const Feedback& feedback, double heading_rad) noexcept;
  double held_target_rad(double now_s) const noexcept;
  double sonar_share(const Feedback& feedback) const noexcept;
  void publish(double target_rad, double error_rad, bool held, bool blind) const noexcept;

  HoldHeadingConfig config_;
  ListingNavigator navigator_;
  CourseLearner learner_;
  double course_rad_ = kUnknown;
  double held_rad_ = kUnknown;
  double held_from_s_ = -kForever;
  double held_until_s_ = -kForever;
  double settled_s_ = -kForever;   ///< When the held course follows the heading no longer.
  double struggle_s_ = 0;          ///< Time of being displaced since it was calm.
  bool pending_ = false;           ///< Displaced, and no heading since.
  double measured_s_ = -kForever;  ///< When the last reading that was learned from was taken.
  double heading_s_ = -kForever;   ///< Time of the last heading, and what was commanded then.
  Command last_ = subsumption::tracks(0, 0);
};

extern const ActingModuleKind hold_heading_kind;

}  // namespace ganglion
