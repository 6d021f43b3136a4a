#include "ganglion/acting/escape/escape.h"

#include <algorithm>
#include <cmath>

#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

using subsumption::Preset;

enum Input : std::size_t { kLeft, kRight, kHeading, kSide };
enum Output : std::size_t { kStuck, kPhase };

constexpr double kListingTurn_s = 0.8;  // 20 pulses of 40 ms, 200 counts of 1200
constexpr double kListingTurnDuty = 1.0 / 6;
constexpr double kInstant_s = 1e-6;    // rounding of times that were added up
constexpr double kHoldOver_s = 0.3;    // a late frame makes no gap in a part; the default time to live of a link
constexpr double kHalfTurnSlack = 10;  // deg: a compass lags behind the turn

constexpr std::array kPorts = {
    subsumption::sonar_port(true),
    subsumption::sonar_port(false),
    PortDescriptor{.name = "heading",
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .required = false,
                   .help = {"Yaw, to measure a half turn by", "Rumbo, para medir la media vuelta"}},
    PortDescriptor{.name = "side",
                   .type = ValueType::Discrete,
                   .required = false,
                   .help = {"Side to turn to whatever the sonars say: -1 left, 1 right; 0 leaves it to them. Of "
                            "AvoidObstacle: \"avoid.side@previous\"",
                            "Lado al que girar digan lo que digan los sonares: -1 izquierda, 1 derecha; 0 lo deja a "
                            "ellos. De AvoidObstacle: \"avoid.side@previous\""}},
    subsumption::kTracksPort,
    PortDescriptor{.name = "stuck",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .help = {"1 during an escape that follows too many others",
                            "1 durante un escape que sigue a demasiados otros"}},
    PortDescriptor{.name = "phase",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .help = {"0 idle, 1 back, 2 turn, 3 half turn", "0 en reposo, 1 atrás, 2 giro, 3 media vuelta"}},
};

constexpr std::array kParameters = {
    subsumption::kPresetParameter,
    ParameterDescriptor{.name = "trigger_range_m",
                        .unit = "m",
                        .preset = 0.10,
                        .min = 0,
                        .max = 10,
                        .help = {"Escapes when a sonar reads this or less", "Escapa si un sonar lee esto o menos"}},
    ParameterDescriptor{.name = "max_range_m",
                        .unit = "m",
                        .preset = 3.0,
                        .min = 0.1,
                        .max = 100,
                        .help = {"What a sonar with nothing in range counts as when the freer side is sought",
                                 "Lo que vale un sonar sin eco al buscar el lado más libre"},
                        .ours = true},
    ParameterDescriptor{.name = "back_s",
                        .unit = "s",
                        .preset = 2.0,
                        .min = 0,
                        .max = 60,
                        .help = {"Time of backing off", "Tiempo de retroceso"}},
    ParameterDescriptor{
        .name = "back_duty",
        .preset = 1.0 / 6,
        .min = 0,
        .max = 1,
        .help = {"Duty of both tracks while backing off", "Ciclo de trabajo de ambas orugas al retroceder"}},
    ParameterDescriptor{.name = "turn_s",
                        .unit = "s",
                        .preset = 1.5,
                        .min = 0,
                        .max = 60,
                        .help = {"Time of the turn; listing: 0.8 s", "Tiempo del giro; listing: 0,8 s"}},
    ParameterDescriptor{.name = "turn_duty",
                        .preset = 0.3,
                        .min = 0,
                        .max = 1,
                        .help = {"Duty of the turn, one track against the other; listing: 1/6",
                                 "Ciclo de trabajo del giro, una oruga contra la otra; listing: 1/6"},
                        .ours = true},
    ParameterDescriptor{.name = "stuck_escapes",
                        .type = ParameterType::Integer,
                        .preset = 3,
                        .min = 2,
                        .max = Escape::kMaxStuckEscapes,
                        .help = {"So many escapes within stuck_window_s mean stuck",
                                 "Tantos escapes en stuck_window_s significan atascado"},
                        .ours = true},
    ParameterDescriptor{.name = "stuck_window_s",
                        .unit = "s",
                        .preset = 20,
                        .min = 0,
                        .max = 3600,
                        .help = {"Time in which escapes add up to stuck; 0 = never stuck",
                                 "Tiempo en que los escapes se suman; 0 = nunca atascado"},
                        .ours = true},
    ParameterDescriptor{.name = "half_turn_s",
                        .unit = "s",
                        .preset = 4.7,
                        .min = 0,
                        .max = 60,
                        .help = {"Time of the half turn without a heading; with one, at most twice this",
                                 "Tiempo de la media vuelta sin rumbo; con rumbo, a lo sumo el doble"},
                        .ours = true},
};

}  // namespace

Result<EscapeConfig> EscapeConfig::from(const Parameters& parameters) {
  if (auto fixed = subsumption::check_listing(parameters); !fixed) return tl::unexpected(fixed.error());
  EscapeConfig config;
  config.preset = subsumption::preset_of(parameters);
  config.trigger_range_m = parameters.real("trigger_range_m");
  config.max_range_m = parameters.real("max_range_m");
  config.back_s = parameters.real("back_s");
  config.back_duty = parameters.real("back_duty");
  config.turn_s = config.preset == Preset::Listing ? kListingTurn_s : parameters.real("turn_s");
  config.turn_duty = config.preset == Preset::Listing ? kListingTurnDuty : parameters.real("turn_duty");
  config.stuck_escapes = parameters.integer("stuck_escapes");
  config.stuck_window_s = config.preset == Preset::Listing ? 0 : parameters.real("stuck_window_s");
  config.half_turn_s = parameters.real("half_turn_s");
  return config;
}

Result<std::unique_ptr<ActingModule>> Escape::make(const Parameters& parameters) {
  const auto config = EscapeConfig::from(parameters);
  if (!config) return tl::unexpected(config.error());
  return std::make_unique<Escape>(*config);
}

Command Escape::internal_propagation(const Request&, const Feedback& feedback) noexcept {
  spend(feedback);
  if (phase_ == Phase::Idle && triggered(feedback)) begin(feedback);
  put(kStuck, stuck_ ? 1 : 0);
  put(kPhase, static_cast<double>(phase_));
  return phase_ == Phase::Idle ? Command::inactive() : move(feedback);
}

bool Escape::triggered(const Feedback& feedback) const noexcept {
  const double left_m = feedback.value(kLeft);
  const double right_m = feedback.value(kRight);
  if (config_.preset == Preset::Listing) {
    return subsumption::listing_range_cm(left_m) < 10.0F || subsumption::listing_range_cm(right_m) < 10.0F;
  }
  return left_m <= config_.trigger_range_m || right_m <= config_.trigger_range_m;  // false for NaN
}

void Escape::begin(const Feedback& feedback) noexcept {
  const double now_s = feedback.tick.time_s;
  begun_s_[static_cast<std::size_t>(escapes_ % kMaxStuckEscapes)] = now_s;
  ++escapes_;
  if (escapes_ >= config_.stuck_escapes) {
    const int first = (escapes_ - config_.stuck_escapes) % kMaxStuckEscapes;
    stuck_ = now_s - begun_s_[static_cast<std::size_t>(first)] < config_.stuck_window_s;
  }
  phase_ = Phase::Back;
  rest_s_ = config_.back_s;
  if (rest_s_ < kInstant_s) begin_turn(feedback);
}

/// Takes off what the last tick used of the present part, and goes on to the next one.
void Escape::spend(const Feedback& feedback) noexcept {
  if (phase_ == Phase::Idle) return;
  rest_s_ -= std::clamp(feedback.tick.time_s - then_s_, 0.0, moves_s_);
  if (phase_ == Phase::HalfTurn) measure_turn(feedback);
  if (rest_s_ > kInstant_s) return;
  if (phase_ == Phase::Back) {
    begin_turn(feedback);
    return;
  }
  phase_ = Phase::Idle;
  if (stuck_) escapes_ = 0;
  stuck_ = false;
}

void Escape::begin_turn(const Feedback& feedback) noexcept {
  phase_ = stuck_ ? Phase::HalfTurn : Phase::Turn;
  clockwise_ = config_.preset == Preset::Listing ? 1 : freer_side(feedback);
  last_heading_ = feedback.value(kHeading);
  turned_rad_ = 0;
  rest_s_ = config_.turn_s;
  if (stuck_) rest_s_ = std::isfinite(last_heading_) ? 2 * config_.half_turn_s : config_.half_turn_s;
}

void Escape::measure_turn(const Feedback& feedback) noexcept {
  const double heading = feedback.value(kHeading);
  if (!std::isfinite(heading)) return;
  if (std::isfinite(last_heading_)) turned_rad_ -= clockwise_ * wrap_rad(heading - last_heading_);
  last_heading_ = heading;
  if (turned_rad_ >= Angle::from_deg(180 - kHalfTurnSlack).rad()) rest_s_ = 0;
}

/// 1 to turn clockwise, -1 the other way. A dead side counts as free: the danger is where it was read.
double Escape::freer_side(const Feedback& feedback) const noexcept {
  if (feedback.value(kSide) < 0) return -1;
  if (feedback.value(kSide) > 0) return 1;
  const double left_m = subsumption::comparable(feedback.value(kLeft), config_.max_range_m);
  const double right_m = subsumption::comparable(feedback.value(kRight), config_.max_range_m);
  return std::isnan(left_m) || left_m > right_m ? -1 : 1;
}

Command Escape::move(const Feedback& feedback) noexcept {
  then_s_ = feedback.tick.time_s;
  moves_s_ = std::min(rest_s_, std::max(feedback.tick.step_s, kHoldOver_s));
  if (phase_ == Phase::Back) return subsumption::tracks(-config_.back_duty, 0, moves_s_);
  return subsumption::tracks(0, clockwise_ * config_.turn_duty, moves_s_);
}

extern constinit const ActingModuleKind escape_kind{
    .descriptor = {.component_class = ComponentClass::Acting,
                   .name = "Escape",
                   .summary = {"Backs off and turns away when something is too near",
                               "Retrocede y gira cuando algo está demasiado cerca"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "Alonso, robot Nimrod, sections 3 and 5 (ESCAPE)"},
    .make = Escape::make};

}  // namespace ganglion
