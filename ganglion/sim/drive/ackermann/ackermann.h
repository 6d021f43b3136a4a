#pragma once

#include "ganglion/sim/robot/drive.h"
#include "ganglion/sim/robot/first_order_lag.h"

namespace ganglion::sim {

struct AckermannConfig {
  double full_scale_mps = 0.2;              ///< Speed of the rear axle at throttle 1.
  double wheelbase_m = 0.2;                 ///< From the rear axle to the front one.
  double centre_m = 0.1;                    ///< How far the body's centre lies ahead of the rear axle.
  double track_m = 0.18;                    ///< Distance of the rear wheels, for their encoders.
  Angle max_steer = Angle::from_deg(30);    ///< To either side.
  Angle steer_rate = Angle::from_deg(120);  ///< Per second; 0 = at once.
  Angle steer_offset;                       ///< What straight ahead really is: a linkage out of true.
  double dead_zone = 0;                     ///< Throttles of less do not move it.
  double lag_s = 0;                         ///< Time constant of the motor.
};

/// A car: driven rear axle, steered front wheels, as a bicycle. Command `drive`: `throttle` in [-1, 1], safe 0, and
/// `steering` [rad], positive to the left, within +-max_steer, safe 0. The rear axle moves on an arc of curvature
/// tan(steering) / wheelbase; the steering runs to what was commanded at its rate, and a sub-step takes the mean of its
/// angles at both ends. It cannot turn on the spot.
/// Source    kinematic bicycle model, e.g. LaValle, Planning algorithms (2006), section 13.1.2.1; rate, offset, lag
/// ours.
class Ackermann final : public Drive {
 public:
  explicit Ackermann(const AckermannConfig& config) noexcept : config_(config), lag_(config.lag_s) {}

  CommandElement element(std::size_t n) const override;
  void reset() noexcept override;
  void command(std::span<const double> values, const Pose2& pose, double step_s, bool fresh) noexcept override;
  void supply(double share) noexcept override { supply_ = share; }
  Movement move(const Pose2& pose, double step_s) noexcept override;

 private:
  /// Turns the wheels for a sub-step; gives the mean of the angle before and after.
  double steer_rad(double step_s) noexcept;
  /// Way of the rear axle in a sub-step; the speed changes.
  double roll_m(double step_s) noexcept;

  AckermannConfig config_;
  FirstOrderLag lag_;
  double throttle_ = 0;
  double wanted_rad_ = 0;
  double steering_rad_ = 0;
  double speed_mps_ = 0;
  double supply_ = 1;
};

extern const DriveKind ackermann_kind;

}  // namespace ganglion::sim
