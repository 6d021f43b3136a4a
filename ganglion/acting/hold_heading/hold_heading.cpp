#include "ganglion/acting/hold_heading/hold_heading.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ganglion {
namespace {

using subsumption::Preset;

enum Input : std::size_t { kHeading, kDisplacedBy, kLeft, kRight, kCourse };
enum Output : std::size_t { kOriginal, kTarget, kError, kHeld, kBlind };

constexpr double kInstant_s = 1e-6;  // rounding of times that were added up

constexpr std::array kPorts = {
    PortDescriptor{.name = "heading",
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .help = {"Yaw by compass", "Rumbo de la brújula"}},
    PortDescriptor{.name = "displaced_by",
                   .type = ValueType::Discrete,
                   .required = false,
                   .many = true,
                   .help = {"Whether a behaviour above drove in the tick before: \"escape.active@previous\"",
                            "Si un comportamiento superior condujo en el tic anterior: \"escape.active@previous\""}},
    PortDescriptor{.name = "left",
                   .unit = "m",
                   .required = false,
                   .help = {"Range of the left front sonar", "Distancia del sonar delantero izquierdo"}},
    PortDescriptor{.name = "right",
                   .unit = "m",
                   .required = false,
                   .help = {"Range of the right front sonar", "Distancia del sonar delantero derecho"}},
    PortDescriptor{
        .name = "course",
        .unit = "rad",
        .type = ValueType::Circular,
        .required = false,
        .help = {"Course to steer instead of the heading at the start", "Rumbo que seguir en lugar del inicial"}},
    subsumption::kTracksPort,
    PortDescriptor{.name = "original",
                   .role = PortRole::Output,
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .help = {"The course it returns to", "El rumbo al que vuelve"}},
    PortDescriptor{
        .name = "target",
        .role = PortRole::Output,
        .unit = "rad",
        .type = ValueType::Circular,
        .help = {"What it steers now: the course or a held one", "Lo que sigue ahora: el rumbo o el mantenido"}},
    PortDescriptor{.name = "error",
                   .role = PortRole::Output,
                   .unit = "rad",
                   .help = {"Target less heading, counter-clockwise; listing: not wrapped",
                            "Objetivo menos rumbo, antihorario; listing: sin reducir"}},
    PortDescriptor{.name = "held",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .help = {"1 while a held course is steered", "1 mientras sigue un rumbo mantenido"}},
    PortDescriptor{.name = "blind",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .help = {"1 while it stops for want of readings", "1 mientras se detiene por falta de lecturas"}},
};

constexpr std::array kParameters = {
    subsumption::kPresetParameter,
    ParameterDescriptor{.name = "gain_per_deg",
                        .unit = "1/deg",
                        .preset = 0.0025,
                        .min = 0,
                        .max = 1,
                        .help = {"Duty of the turn for each degree of error (3 of 1200 counts)",
                                 "Ciclo del giro por grado de error (3 de 1200 cuentas)"}},
    ParameterDescriptor{.name = "forward_duty",
                        .preset = 1.0 / 3,
                        .min = 0,
                        .max = 1,
                        .help = {"Duty ahead while on course", "Ciclo hacia delante si va en rumbo"}},
    ParameterDescriptor{.name = "fade_deg",
                        .unit = "deg",
                        .preset = 90,
                        .min = 1,
                        .max = 360,
                        .help = {"Error at which it turns on the spot", "Error con que gira en el sitio"},
                        .ours = true},
    ParameterDescriptor{.name = "hold_s",
                        .unit = "s",
                        .preset = 3.0,
                        .min = 0,
                        .max = 600,
                        .help = {"Holds the heading it was left with for so long; listing: 15 cycles",
                                 "Mantiene este tiempo el rumbo en que quedó; listing: 15 ciclos"},
                        .ours = true},
    ParameterDescriptor{.name = "settle_s",
                        .unit = "s",
                        .preset = 1.5,
                        .min = 0,
                        .max = 60,
                        .help = {"For so long the held course follows the heading: the lag of the compass",
                                 "Durante este tiempo el rumbo mantenido sigue a la brújula: su retraso"},
                        .ours = true},
    ParameterDescriptor{.name = "hold_growth",
                        .preset = 2.0,
                        .min = 0,
                        .max = 100,
                        .help = {"Holds so many seconds for each one of being displaced, if that is more than hold_s",
                                 "Mantiene tantos segundos por cada uno de desplazamiento, si supera hold_s"},
                        .ours = true},
    ParameterDescriptor{.name = "max_hold_s",
                        .unit = "s",
                        .preset = 48,
                        .min = 0,
                        .max = 3600,
                        .help = {"Longest time of holding", "Tiempo máximo de mantener"},
                        .ours = true},
    ParameterDescriptor{.name = "calm_s",
                        .unit = "s",
                        .preset = 5.0,
                        .min = 0,
                        .max = 3600,
                        .help = {"After so long on course the time of being displaced is forgotten",
                                 "Tras este tiempo en rumbo se olvida el tiempo de desplazamiento"},
                        .ours = true},
    ParameterDescriptor{.name = "agreement_deg",
                        .unit = "deg",
                        .preset = 5,
                        .min = 0,
                        .max = 180,
                        .help = {"Three readings this near to each other give the course",
                                 "Tres lecturas así de próximas dan el rumbo"},
                        .ours = true},
    ParameterDescriptor{.name = "patience_s",
                        .unit = "s",
                        .preset = 0.5,
                        .min = 0,
                        .max = 60,
                        .help = {"Keeps the last command for so long without a heading",
                                 "Mantiene el último mando este tiempo sin brújula"},
                        .ours = true},
    ParameterDescriptor{.name = "slow_range_m",
                        .unit = "m",
                        .preset = 0.60,
                        .min = 0.01,
                        .max = 10,
                        .help = {"Below this range it goes slower, in proportion",
                                 "Por debajo de esta distancia va más lento, en proporción"},
                        .ours = true},
    ParameterDescriptor{.name = "least_share",
                        .preset = 0.3,
                        .min = 0,
                        .max = 1,
                        .help = {"Share of the speed ahead that is left however near", "Parte mínima de la velocidad"},
                        .ours = true},
    ParameterDescriptor{.name = "one_sonar_share",
                        .preset = 0.5,
                        .min = 0,
                        .max = 1,
                        .help = {"Share of the speed ahead while one sonar is dead",
                                 "Parte de la velocidad de avance con un sonar muerto"},
                        .ours = true},
};

float compass_deg(double yaw_rad) noexcept {
  return static_cast<float>(compass_deg_from_yaw(Angle::from_rad(yaw_rad)));
}

}  // namespace

Result<HoldHeadingConfig> HoldHeadingConfig::from(const Parameters& parameters) {
  if (auto fixed = subsumption::check_listing(parameters); !fixed) return tl::unexpected(fixed.error());
  HoldHeadingConfig config;
  config.preset = subsumption::preset_of(parameters);
  config.gain_per_deg = parameters.real("gain_per_deg");
  config.forward_duty = parameters.real("forward_duty");
  config.fade_deg = parameters.real("fade_deg");
  config.hold_s = parameters.real("hold_s");
  config.settle_s = parameters.real("settle_s");
  config.hold_growth = parameters.real("hold_growth");
  config.max_hold_s = parameters.real("max_hold_s");
  config.calm_s = parameters.real("calm_s");
  config.agreement_deg = parameters.real("agreement_deg");
  config.patience_s = parameters.real("patience_s");
  config.slow_range_m = parameters.real("slow_range_m");
  config.least_share = parameters.real("least_share");
  config.one_sonar_share = parameters.real("one_sonar_share");
  return config;
}

Result<std::unique_ptr<ActingModule>> HoldHeading::make(const Parameters& parameters) {
  const auto config = HoldHeadingConfig::from(parameters);
  if (!config) return tl::unexpected(config.error());
  return std::make_unique<HoldHeading>(*config);
}

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
  const double target_rad = held ? held_rad_ : course_rad_;
  const double error_rad = wrap_rad(target_rad - heading_rad);
  const bool stands = share == 0 || std::isnan(course_rad_);
  publish(target_rad, error_rad, held, share == 0);
  last_ = stands ? subsumption::tracks(0, 0) : steer(error_rad, share);
  return last_;
}

void HoldHeading::hold(double heading_rad, const Tick& tick) noexcept {
  if (tick.time_s > held_until_s_ + config_.calm_s) struggle_s_ = 0;
  struggle_s_ += tick.step_s;
  const double longest_s = std::max(config_.hold_s, config_.max_hold_s);
  held_rad_ = heading_rad;
  held_until_s_ = tick.time_s + std::clamp(config_.hold_growth * struggle_s_, config_.hold_s, longest_s);
  settled_s_ = tick.time_s + config_.settle_s;
  pending_ = false;
}

Command HoldHeading::without_heading(const Feedback& feedback, double share) const noexcept {
  const bool blind = share == 0 || feedback.tick.time_s - heading_s_ > config_.patience_s + kInstant_s;
  publish(kUnknown, kUnknown, false, blind);
  return blind ? subsumption::tracks(0, 0) : last_;
}

Command HoldHeading::steer(double error_rad, double share) const noexcept {
  const double clockwise_deg = -Angle::from_rad(error_rad).deg();
  const double balance = std::clamp(1 - std::fabs(clockwise_deg) / config_.fade_deg, 0.0, 1.0);
  const double turn = std::clamp(config_.gain_per_deg * clockwise_deg, -1.0, 1.0);
  return subsumption::tracks(share * config_.forward_duty * balance, turn);
}

bool HoldHeading::displaced(const Feedback& feedback) const noexcept {
  const PortView& flags = feedback[kDisplacedBy];
  if (!flags.wired()) return !feedback.granted;
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

extern constinit const ActingModuleKind hold_heading_kind{
    .descriptor = {.component_class = ComponentClass::Acting,
                   .name = "HoldHeading",
                   .summary = {"Drives along a course by compass", "Avanza por un rumbo según la brújula"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "Alonso, robot Nimrod, sections 3 and 5 (NAVEGAR)"},
    .make = HoldHeading::make};

}  // namespace ganglion
