#include "ganglion/sim/drive/ackermann/ackermann.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ganglion/math/functions.h"
#include "ganglion/sim/robot/wheel_pair.h"

namespace ganglion::sim {
namespace {

constexpr std::array<ElementDescriptor, 2> kElements = {"throttle", "steering"};
constexpr std::array kPorts = {
    PortDescriptor{.name = "drive",
                   .title = {"drive", "tracción"},
                   .help = {"Throttle in [-1, 1]; angle of the front wheels [rad], positive to the left",
                            "Acelerador en [-1, 1]; ángulo de las ruedas delanteras [rad], positivo a la izquierda"},
                   .role = PortRole::Command,
                   .size = 2,
                   .elements = kElements},
};

constexpr std::array kParameters = {
    full_scale_parameter<AckermannConfig>(),
    parameter<AckermannConfig, &AckermannConfig::wheelbase_m>(
        {.name = "wheelbase_m",
         .title = {"wheelbase", "distancia entre ejes"},
         .help = {"From the rear axle to the front one", "Distancia entre ejes"},
         .unit = "m",
         .min = 1e-3,
         .max = 100,
         .ours = true}),
    parameter<AckermannConfig, &AckermannConfig::centre_m>(
        {.name = "centre_m",
         .title = {"centre ahead", "centro adelantado"},
         .help = {"How far the body's centre lies ahead of the rear axle",
                  "Cuánto está el centro delante del eje trasero"},
         .unit = "m",
         .min = -100,
         .max = 100,
         .ours = true}),
    track_parameter<AckermannConfig>(),
    parameter<AckermannConfig, &AckermannConfig::max_steer>(
        {.name = "max_steer_deg",
         .title = {"steering limit", "límite de dirección"},
         .help = {"Steering limit, to either side", "Límite de dirección a cada lado"},
         .unit = "deg",
         .min = 0.1,
         .max = 80,
         .ours = true}),
    parameter<AckermannConfig, &AckermannConfig::steer_rate>(
        {.name = "steer_rate_degps",
         .title = {"steering rate", "rapidez de dirección"},
         .help = {"How fast the steering turns; 0 = at once", "Rapidez de la dirección; 0 = al instante"},
         .unit = "deg/s",
         .min = 0,
         .max = 10000,
         .ours = true}),
    parameter<AckermannConfig, &AckermannConfig::steer_offset>(
        {.name = "steer_offset_deg",
         .title = {"steering offset", "desvío de dirección"},
         .help = {"What straight ahead really is: a linkage out of true",
                  "A qué equivale el centro: dirección desalineada"},
         .unit = "deg",
         .min = -30,
         .max = 30,
         .ours = true}),
    dead_zone_parameter<AckermannConfig>(),
    motor_lag_parameter<AckermannConfig>(),
};

}  // namespace

CommandElement Ackermann::element(std::size_t n) const {
  if (n == 0) return {.name = "throttle", .unit = "", .min = -1, .max = 1, .safe = 0};
  const double limit_rad = config_.max_steer.rad();
  return {.name = "steering", .unit = "rad", .min = -limit_rad, .max = limit_rad, .safe = 0};
}

void Ackermann::reset() noexcept {
  throttle_ = wanted_rad_ = steering_rad_ = speed_mps_ = 0;
  supply_ = 1;
}

void Ackermann::command(std::span<const double> values, const Pose2&, double, bool) noexcept {
  throttle_ = values[0];
  wanted_rad_ = values[1];
}

double Ackermann::steer_rad(double step_s) noexcept {
  const double before_rad = steering_rad_;
  const double reach_rad = config_.steer_rate.rad() > 0 ? config_.steer_rate.rad() * step_s : kPi;
  steering_rad_ += std::clamp(wanted_rad_ - steering_rad_, -reach_rad, reach_rad);
  if (config_.steer_rate.rad() <= 0) return steering_rad_ + config_.steer_offset.rad();
  return (before_rad + steering_rad_) / 2 + config_.steer_offset.rad();
}

double Ackermann::roll_m(double step_s) noexcept {
  const double moving = std::fabs(throttle_) < config_.dead_zone ? 0 : throttle_;
  const double wanted_mps = moving * config_.full_scale_mps * supply_;
  const double share = lag_.share(step_s);
  const double missing_mps = speed_mps_ - wanted_mps;
  speed_mps_ = wanted_mps + missing_mps * (1 - share);
  return wanted_mps * step_s + missing_mps * config_.lag_s * share;
}

Movement Ackermann::move(const Pose2& pose, double step_s) noexcept {
  const double curvature_radpm = math::tan(steer_rad(step_s)) / config_.wheelbase_m;
  const double way_m = roll_m(step_s);
  Movement movement;
  movement.turn_rad = way_m * curvature_radpm;
  const double half_turn_rad = movement.turn_rad / 2;
  const double chord_m = std::fabs(half_turn_rad) < 1e-4 ? way_m * (1 - half_turn_rad * half_turn_rad / 6)
                                                         : way_m * math::sin(half_turn_rad) / half_turn_rad;
  const double yaw_rad = pose.yaw.rad();
  movement.displacement = direction(yaw_rad + half_turn_rad) * chord_m +
                          (direction(yaw_rad + movement.turn_rad) - direction(yaw_rad)) * config_.centre_m;
  movement.left_m = way_m - movement.turn_rad * config_.track_m / 2;
  movement.right_m = way_m + movement.turn_rad * config_.track_m / 2;
  movement.effort = std::fabs(throttle_);
  const double aside = config_.centre_m * curvature_radpm;  // the centre's circle is the wider one
  movement.path_m = std::fabs(way_m) * std::sqrt(1 + aside * aside);
  return movement;
}

extern constinit const DriveKind ackermann_kind{
    .descriptor = {.component_class = ComponentClass::Drive,
                   .name = "Ackermann",
                   .summary = {"A car: driven rear axle, steered front wheels",
                               "Un coche: eje trasero motriz, ruedas delanteras directrices"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "kinematic bicycle model (LaValle 2006, 13.1.2.1); rate, offset and lag ours"},
    .make = make_bound<Drive, Ackermann, AckermannConfig>};

}  // namespace ganglion::sim
