#include "ganglion/sim/drive/stepper/stepper.h"

#include <array>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr double kTurnToleranceRad = 1e-6;  // so that 45 deg that went through rounding still are 45 deg

constexpr std::array<ElementDescriptor, 2> kElements = {"motion", "direction"};
constexpr std::array kPorts = {
    PortDescriptor{
        .name = "step",
        .title = {"step", "paso"},
        .help = {"Motion -1 back, 0 stay, 1 forward; direction of travel [rad] in the world, multiple of 45 deg",
                 "Movimiento -1 atrás, 0 quieto, 1 adelante; dirección de avance [rad] en el mundo, múltiplo "
                 "de 45 grados"},
        .role = PortRole::Command,
        .size = 2,
        .elements = kElements},
};
constexpr std::array kParameters = {
    parameter<StepperConfig, &StepperConfig::cell_m>({.name = "cell_m",
                                                      .title = {"cell side", "lado de celda"},
                                                      .help = {"Side of a cell", "Lado de una celda"},
                                                      .unit = "m",
                                                      .min = 1e-3,
                                                      .max = 1000}),
    parameter<StepperConfig, &StepperConfig::max_turn>(
        {.name = "max_turn_deg",
         .title = {"largest turn", "giro máximo"},
         .help = {"Largest change of heading in one step; commands that ask for more are not carried out",
                  "Mayor cambio de rumbo en un paso; no se ejecuta un mando que pida más"},
         .unit = "deg",
         .min = 0,
         .max = 180}),
};

/// The multiple of 45 deg nearest to an angle, as 0..7 counter-clockwise from x.
int eighth_of(double rad) noexcept {
  const int eighths = static_cast<int>(std::floor(wrap_rad(rad) / (kPi / 4) + 0.5));
  return (eighths + 8) % 8;
}

constexpr std::array<int, 8> kColumns = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr std::array<int, 8> kRows = {0, 1, 1, 1, 0, -1, -1, -1};

}  // namespace

CommandElement Stepper::element(std::size_t n) const {
  if (n == 0) return {.name = "motion", .unit = "", .min = -1, .max = 1, .safe = 0};
  return {.name = "direction", .unit = "rad", .min = -kPi, .max = kPi, .safe = 0};
}

Vector2 Stepper::centre_of(Vector2 position) const noexcept {
  return {(std::floor(position.x / config_.cell_m) + 0.5) * config_.cell_m,
          (std::floor(position.y / config_.cell_m) + 0.5) * config_.cell_m};
}

void Stepper::command(std::span<const double> values, const Pose2& pose, double step_s, bool fresh) noexcept {
  if (!fresh) return;  // a move once begun is carried to its end
  leg_ = Leg::None;
  const int motion = values[0] >= 0.5 ? 1 : values[0] <= -0.5 ? -1 : 0;
  if (motion == 0) return;
  const int eighth = eighth_of(values[1]);
  const Angle heading = Angle::from_deg(45.0 * (motion > 0 ? eighth : eighth + 4)).wrapped();
  if (std::fabs((heading - pose.yaw).wrapped().rad()) > config_.max_turn.rad() + kTurnToleranceRad) return;

  origin_ = {centre_of(pose.position), pose.yaw};
  const auto way = static_cast<std::size_t>(eighth);
  target_ = {centre_of(origin_.position +
                       Vector2{static_cast<double>(kColumns[way]), static_cast<double>(kRows[way])} * config_.cell_m),
             heading};
  speed_mps_ = 2 * (target_.position - pose.position).length() / step_s;
  leg_ = Leg::Out;
}

Movement Stepper::move(const Pose2& pose, double step_s) noexcept {
  Movement movement;
  if (leg_ == Leg::None) return movement;
  const Pose2& aim = leg_ == Leg::Out ? target_ : origin_;
  const Vector2 missing = aim.position - pose.position;
  const double missing_turn_rad = (aim.yaw - pose.yaw).wrapped().rad();
  const double missing_m = missing.length();
  const double reach_m = speed_mps_ * step_s;
  arrives_ = missing_m <= reach_m * (1 + 1e-9);
  const double share = arrives_ ? 1 : reach_m / missing_m;
  movement.displacement = missing * share;
  movement.turn_rad = missing_turn_rad * share;
  const double sign = movement.displacement.dot(direction(pose.yaw.rad())) >= 0 ? 1 : -1;
  movement.path_m = missing_m * share;
  movement.left_m = movement.right_m = sign * missing_m * share;
  movement.effort = 1;
  return movement;
}

void Stepper::feel(bool touched) noexcept {
  if (touched && leg_ == Leg::Out) {
    leg_ = Leg::Back;
  } else if (arrives_) {
    leg_ = Leg::None;
  }
}

extern constinit const DriveKind stepper_kind{
    .descriptor =
        {.component_class = ComponentClass::Drive,
         .name = "Stepper",
         .summary = {"Moves by whole cells of a grid, as the GFM papers' test robot does",
                     "Se mueve por celdas enteras de una cuadrícula, como el robot de prueba de los artículos GFM"},
         .ports = kPorts,
         .parameters = kParameters,
         .source = "A growing functional modules locomotion subsystem, section 5; timing ours"},
    .make = make_bound<Drive, Stepper, StepperConfig>};

}  // namespace ganglion::sim
