#pragma once

#include <limits>
#include <span>
#include <string_view>

#include "ganglion/application/description.h"
#include "ganglion/geometry/pose2.h"
#include "ganglion/module/component.h"

namespace ganglion::sim {

/// What a drive does within one sub-step if nothing stands in its way.
struct Movement {
  Vector2 displacement{};  ///< Of the body's centre, in the world's frame [m].
  double turn_rad = 0;     ///< Counter-clockwise.
  double left_m = 0;       ///< Way of the wheels' rims.
  double right_m = 0;
  double effort = 0;  ///< Share of full power taken, in [0, 1]; up to twice that uphill (FloorRide).
  double path_m = 0;  ///< Length of the centre's path; a curve is longer than its displacement.
};

/// Moves a simulated robot. The body decides what comes of it: walls block, and the drive is told by feel().
/// Takes no memory after it was made.
class Drive {
 public:
  Drive() = default;
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;
  virtual ~Drive() = default;

  /// Limits and safe value of element n of the descriptor's Command port.
  virtual CommandElement element(std::size_t n) const = 0;
  virtual void reset() noexcept = 0;
  /// Values in force from now on, finite and within their limits. At the start of a step_s long step `fresh` is true;
  /// within a step, when their time to live has run out, the safe values come with `fresh` false.
  virtual void command(std::span<const double> values, const Pose2& pose, double step_s, bool fresh) noexcept = 0;
  /// The next sub-step, from where the body is.
  virtual Movement move(const Pose2& pose, double step_s) noexcept = 0;
  /// The share of its full voltage that the battery gives from now on, in [0, 1]; 1 where there is no battery.
  virtual void supply(double share) noexcept { static_cast<void>(share); }
  /// The centre's speed if it is the same in all sub-steps to come, which are exact then however long they are; +inf
  /// where the drive cannot promise that, and short sub-steps are taken.
  virtual double steady_mps() const noexcept { return std::numeric_limits<double>::infinity(); }
  /// Whether another robot can push it away; one that goes by places keeps to them.
  virtual bool yields() const noexcept { return true; }
  /// What move() would give; asked only of drives with a steady_mps().
  virtual Movement foreseen(const Pose2& pose, double step_s) const noexcept {
    static_cast<void>(pose), static_cast<void>(step_s);
    return {};
  }
  /// What the last sub-step ran into.
  virtual void feel(bool touched) noexcept { static_cast<void>(touched); }
};

/// A kind's descriptor has exactly one Command port; its name becomes the command channel's.
using DriveKind = Kind<Drive>;

}  // namespace ganglion::sim
