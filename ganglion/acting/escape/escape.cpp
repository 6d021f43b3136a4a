#include "ganglion/acting/escape/escape.h"

#include <algorithm>
#include <cmath>

#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

using Config = EscapeConfig;
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
                   .title = {"heading", "rumbo"},
                   .help = {"Yaw, to measure a half turn by", "Rumbo, para medir la media vuelta"},
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .required = false},
    PortDescriptor{.name = "side",
                   .title = {"side", "lado"},
                   .help = {"Side to turn to whatever the sonars say: -1 left, 1 right; 0 leaves it to them. Of "
                            "AvoidObstacle: \"avoid.side@previous\"",
                            "Lado al que girar digan lo que digan los sonares: -1 izquierda, 1 derecha; 0 lo deja a "
                            "ellos. De AvoidObstacle: \"avoid.side@previous\""},
                   .type = ValueType::Discrete,
                   .required = false},
    subsumption::kTracksPort,
    PortDescriptor{
        .name = "stuck",
        .title = {"stuck", "atascado"},
        .help = {"1 during an escape that follows too many others", "1 durante un escape que sigue a demasiados otros"},
        .role = PortRole::Output,
        .type = ValueType::Discrete,
        .meaning = Meaning::StandsOnPurpose},
    PortDescriptor{.name = "phase",
                   .title = {"phase", "fase"},
                   .help = {"0 idle, 1 back, 2 turn, 3 half turn", "0 en reposo, 1 atrás, 2 giro, 3 media vuelta"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
};

constexpr std::array kParameters = {
    subsumption::preset_parameter<Config>(),
    parameter<Config, &Config::trigger_range_m>(
        {.name = "trigger_range_m",
         .title = {"trigger range", "distancia de disparo"},
         .help = {"Escapes when a sonar reads this or less", "Escapa si un sonar lee esto o menos"},
         .unit = "m",
         .min = 0,
         .max = 10,
         .live = true}),
    parameter<Config, &Config::max_range_m>(
        {.name = "max_range_m",
         .title = {"maximum range", "alcance máximo"},
         .help = {"What a sonar with nothing in range counts as when the freer side is sought",
                  "Lo que vale un sonar sin eco al buscar el lado más libre"},
         .unit = "m",
         .min = 0.1,
         .max = 100,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::back_s>({.name = "back_s",
                                        .title = {"backing time", "tiempo de retroceso"},
                                        .help = {"Time of backing off", "Tiempo de retroceso"},
                                        .unit = "s",
                                        .min = 0,
                                        .max = 60,
                                        .live = true}),
    parameter<Config, &Config::back_duty>(
        {.name = "back_duty",
         .title = {"backing duty", "ciclo de trabajo de retroceso"},
         .help = {"Duty of both tracks while backing off", "Ciclo de trabajo de ambas orugas al retroceder"},
         .min = 0,
         .max = 1,
         .live = true}),
    parameter<Config, &Config::turn_s>({.name = "turn_s",
                                        .title = {"turn time", "tiempo de giro"},
                                        .help = {"Time of the turn; listing: 0.8 s", "Tiempo del giro; listing: 0,8 s"},
                                        .unit = "s",
                                        .min = 0,
                                        .max = 60,
                                        .live = true}),
    parameter<Config, &Config::turn_duty>(
        {.name = "turn_duty",
         .title = {"turn duty", "ciclo de trabajo de giro"},
         .help = {"Duty of the turn, one track against the other; listing: 1/6",
                  "Ciclo de trabajo del giro, una oruga contra la otra; listing: 1/6"},
         .min = 0,
         .max = 1,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::stuck_escapes>({.name = "stuck_escapes",
                                               .title = {"stuck escapes", "escapes de atasco"},
                                               .help = {"So many escapes within stuck_window_s mean stuck",
                                                        "Tantos escapes en stuck_window_s significan atascado"},
                                               .min = 2,
                                               .max = Escape::kMaxStuckEscapes,
                                               .ours = true}),
    parameter<Config, &Config::stuck_window_s>({.name = "stuck_window_s",
                                                .title = {"stuck window", "ventana de atasco"},
                                                .help = {"Time in which escapes add up to stuck; 0 = never stuck",
                                                         "Tiempo en que los escapes se suman; 0 = nunca atascado"},
                                                .unit = "s",
                                                .min = 0,
                                                .max = 3600,
                                                .ours = true,
                                                .live = true}),
    parameter<Config, &Config::half_turn_s>(
        {.name = "half_turn_s",
         .title = {"half-turn time", "tiempo de media vuelta"},
         .help = {"Time of the half turn without a heading; with one, at most twice this",
                  "Tiempo de la media vuelta sin rumbo; con rumbo, a lo sumo el doble"},
         .unit = "s",
         .min = 0,
         .max = 60,
         .ours = true,
         .live = true}),
};

}  // namespace

Result<void> Escape::judge(EscapeConfig& config, const Parameters& parameters) {
  if (config.preset != Preset::Listing) return {};
  config.turn_s = kListingTurn_s;
  config.turn_duty = kListingTurnDuty;
  config.stuck_window_s = 0;
  return subsumption::check_listing(config.preset, parameters);
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
    .make = make_bound<ActingModule, Escape, EscapeConfig>};

}  // namespace ganglion
