#include "ganglion/acting/avoid_obstacle/avoid_obstacle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ganglion {
namespace {

using Config = AvoidObstacleConfig;
using subsumption::Preset;

enum Input : std::size_t { kLeft, kRight, kEscaping };
enum Output : std::size_t { kDifference, kSide };

constexpr std::array kPorts = {
    subsumption::sonar_port(true),
    subsumption::sonar_port(false),
    PortDescriptor{.name = "escaping",
                   .title = {"escaping", "escape en curso"},
                   .help = {"1 while Escape drives: keeps this behaviour inactive",
                            "1 mientras Escape conduce: deja inactivo este comportamiento"},
                   .type = ValueType::Discrete,
                   .required = false},
    subsumption::kTracksPort,
    PortDescriptor{.name = "difference",
                   .title = {"difference", "diferencia"},
                   .help = {"Right range less left range", "Distancia derecha menos izquierda"},
                   .role = PortRole::Output,
                   .unit = "m"},
    PortDescriptor{.name = "side",
                   .title = {"side", "lado"},
                   .help = {"Side it has committed itself to: -1 left, 0 none, 1 right",
                            "Lado con el que se ha comprometido: -1 izquierda, 0 ninguno, 1 derecha"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
};

constexpr std::array kParameters = {
    subsumption::preset_parameter<Config>(),
    parameter<Config, &Config::trigger_range_m>(
        {.name = "trigger_range_m",
         .title = {"trigger range", "distancia de disparo"},
         .help = {"Avoids when a sonar reads this or less", "Evita si un sonar lee esto o menos"},
         .unit = "m",
         .min = 0,
         .max = 10,
         .live = true}),
    parameter<Config, &Config::max_range_m>(
        {.name = "max_range_m",
         .title = {"maximum range", "alcance máximo"},
         .help = {"What a sonar with nothing in range counts as", "Lo que vale un sonar sin eco"},
         .unit = "m",
         .min = 0.1,
         .max = 100,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::gain_per_m>(
        {.name = "gain_per_m",
         .title = {"turn gain", "ganancia del giro"},
         .help = {"Duty of the turn for each metre of difference (3 of 1200 counts per cm)",
                  "Ciclo de trabajo del giro por metro de diferencia (3 de 1200 cuentas por cm)"},
         .unit = "1/m",
         .min = 0,
         .max = 100,
         .live = true}),
    parameter<Config, &Config::straight_m>(
        {.name = "straight_m",
         .title = {"straight band", "banda recta"},
         .help = {"Goes straight on while the difference is below this; listing: 4 cm",
                  "Sigue recto mientras la diferencia es menor; listing: 4 cm"},
         .unit = "m",
         .min = 0,
         .max = 10,
         .live = true}),
    parameter<Config, &Config::straight_hysteresis_m>(
        {.name = "straight_hysteresis_m",
         .title = {"straight hysteresis", "histéresis de banda"},
         .help = {"So much more until it turns again", "Tanto más hasta volver a girar"},
         .unit = "m",
         .min = 0,
         .max = 10,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::forward_duty>({.name = "forward_duty",
                                              .title = {"forward duty", "ciclo de trabajo de avance"},
                                              .help = {"Duty straight ahead with all at trigger_range_m",
                                                       "Ciclo de trabajo hacia delante con todo a trigger_range_m"},
                                              .min = 0,
                                              .max = 1,
                                              .live = true}),
    parameter<Config, &Config::fade_m>(
        {.name = "fade_m",
         .title = {"fade difference", "diferencia de atenuación"},
         .help = {"Difference at which it turns on the spot", "Diferencia con que gira en el sitio"},
         .unit = "m",
         .min = 0.01,
         .max = 100,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::stop_range_m>({.name = "stop_range_m",
                                              .title = {"stop range", "distancia de parada"},
                                              .help = {"Nearest range at which the speed ahead has fallen to 0",
                                                       "Distancia a la que la velocidad hacia delante llega a 0"},
                                              .unit = "m",
                                              .min = 0,
                                              .max = 10,
                                              .ours = true,
                                              .live = true}),
    parameter<Config, &Config::commit_range_m>({.name = "commit_range_m",
                                                .title = {"commit range", "distancia de compromiso"},
                                                .help = {"Nearest range at which it commits itself to one side",
                                                         "Distancia a la que se compromete con un lado"},
                                                .unit = "m",
                                                .min = 0,
                                                .max = 10,
                                                .ours = true,
                                                .live = true}),
    parameter<Config, &Config::commit_s>({.name = "commit_s",
                                          .title = {"commit time", "tiempo de compromiso"},
                                          .help = {"Keeps to that side for so long after it is clear",
                                                   "Mantiene ese lado este tiempo tras quedar libre"},
                                          .unit = "s",
                                          .min = 0,
                                          .max = 60,
                                          .ours = true,
                                          .live = true}),
    parameter<Config, &Config::min_turn_duty>(
        {.name = "min_turn_duty",
         .title = {"least turn duty", "ciclo de trabajo mínimo"},
         .help = {"Least duty of the turn while committed", "Ciclo de trabajo mínimo del giro comprometido"},
         .min = 0,
         .max = 1,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::commit_reversals>(
        {.name = "commit_reversals",
         .title = {"commit reversals", "cambios hasta comprometerse"},
         .help = {"Commits itself, too, once the freer side has changed so often",
                  "También se compromete cuando el lado más libre ha cambiado tantas veces"},
         .min = 1,
         .max = 1000,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::side_memory_s>(
        {.name = "side_memory_s",
         .title = {"side memory", "memoria del lado"},
         .help = {"For so long it takes the side of last time where both are about equal",
                  "Durante este tiempo toma el lado de la última vez si ambos son casi iguales"},
         .unit = "s",
         .min = 0,
         .max = 3600,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::undecided_m>({.name = "undecided_m",
                                             .title = {"undecided band", "banda de indecisión"},
                                             .help = {"Both sides are about equal while they differ by less than this",
                                                      "Ambos lados son casi iguales si difieren en menos que esto"},
                                             .unit = "m",
                                             .min = 0,
                                             .max = 10,
                                             .ours = true,
                                             .live = true}),
    subsumption::one_sonar_share_parameter<Config>(),
};

}  // namespace

Result<void> AvoidObstacle::judge(const AvoidObstacleConfig& config, const Parameters& parameters) {
  if (auto fixed = subsumption::check_listing(config.preset, parameters); !fixed) return fixed;
  if (!(config.stop_range_m < config.commit_range_m && config.commit_range_m <= config.trigger_range_m)) {
    return fail(ErrorCode::BadParameter,
                {"must be stop_range_m < commit_range_m <= trigger_range_m, are {}, {}, {}: it could come to a stand",
                 "debe ser stop_range_m < commit_range_m <= trigger_range_m, son {}, {}, {}: podría quedarse parado"},
                config.stop_range_m, config.commit_range_m, config.trigger_range_m);
  }
  return {};
}

Command AvoidObstacle::internal_propagation(const Request&, const Feedback& feedback) noexcept {
  put(kDifference, std::numeric_limits<double>::quiet_NaN());
  const Command command = config_.preset == Preset::Listing ? listing(feedback) : recommended(feedback);
  put(kSide, side_);
  return command;
}

Command AvoidObstacle::listing(const Feedback& feedback) const noexcept {
  const float left_cm = subsumption::listing_range_cm(feedback.value(kLeft));
  const float right_cm = subsumption::listing_range_cm(feedback.value(kRight));
  put(kDifference, static_cast<double>(right_cm - left_cm) / 100);
  const bool escape = left_cm < 10.0F || right_cm < 10.0F || feedback.value(kEscaping) > 0;
  if (escape || (left_cm > 40.0F && right_cm > 40.0F)) return Command::inactive();
  return subsumption::listing_pulses(subsumption::listing_m(right_cm, left_cm), 4.0F);
}

Command AvoidObstacle::recommended(const Feedback& feedback) noexcept {
  double left_m = subsumption::comparable(feedback.value(kLeft), config_.max_range_m);
  double right_m = subsumption::comparable(feedback.value(kRight), config_.max_range_m);
  const bool left_dead = std::isnan(left_m);
  const bool right_dead = std::isnan(right_m);
  if (left_dead && right_dead) return Command::inactive();
  if (left_dead) left_m = config_.trigger_range_m;
  if (right_dead) right_m = config_.trigger_range_m;
  const double difference_m = right_m - left_m;
  put(kDifference, difference_m);
  // The stand-in of a dead sonar lies on the threshold: only what is really read may trigger.
  const double nearest_m = left_dead ? right_m : right_dead ? left_m : std::min(left_m, right_m);
  const bool near = nearest_m <= config_.trigger_range_m && !(feedback.value(kEscaping) > 0);
  commit(near, near && nearest_m <= config_.commit_range_m, difference_m, feedback.tick.time_s);
  if (!near) {
    straight_ = false;
    return Command::inactive();
  }
  return turn_and_go(nearest_m, difference_m, left_dead || right_dead ? config_.one_sonar_share : 1);
}

void AvoidObstacle::commit(bool near, bool too_near, double difference_m, double now_s) noexcept {
  if (near) {
    count_reversal(difference_m);
    const bool swings = reversals_ >= config_.commit_reversals;
    if (side_ == 0 && (too_near || swings)) side_ = side_to_take(difference_m, now_s);
    committed_until_s_ = now_s + config_.commit_s;
  } else if (now_s >= committed_until_s_) {
    side_ = 0;
    leaning_ = 0;
    reversals_ = 0;
  }
  if (side_ == 0) return;
  last_side_ = side_;
  remembered_until_s_ = now_s + config_.side_memory_s;
}

void AvoidObstacle::count_reversal(double difference_m) noexcept {
  if (std::fabs(difference_m) < config_.straight_m) return;
  const double freer = difference_m < 0 ? -1 : 1;
  if (freer == -leaning_) ++reversals_;
  leaning_ = freer;
}

double AvoidObstacle::side_to_take(double difference_m, double now_s) const noexcept {
  const bool remembers = last_side_ != 0 && now_s < remembered_until_s_;
  if (remembers && std::fabs(difference_m) < config_.undecided_m) return last_side_;
  return difference_m < 0 ? -1 : 1;
}

Command AvoidObstacle::turn_and_go(double nearest_m, double difference_m, double share) noexcept {
  const double apart_m = std::fabs(difference_m);
  const double edge_m = config_.straight_m + (straight_ ? config_.straight_hysteresis_m : 0);
  straight_ = side_ == 0 && apart_m < edge_m;
  double clockwise = straight_ ? 0 : std::clamp(config_.gain_per_m * difference_m, -1.0, 1.0);
  if (side_ != 0) clockwise = side_ * std::max(side_ * clockwise, config_.min_turn_duty);
  const double room = (nearest_m - config_.stop_range_m) / (config_.trigger_range_m - config_.stop_range_m);
  const double balance = straight_ ? 1 : 1 - apart_m / config_.fade_m;
  const double forward = config_.forward_duty * std::clamp(room, 0.0, 1.0) * std::clamp(balance, 0.0, 1.0);
  return subsumption::tracks(share * forward, clockwise);
}

extern constinit const ActingModuleKind avoid_obstacle_kind{
    .descriptor = {.component_class = ComponentClass::Acting,
                   .name = "AvoidObstacle",
                   .summary = {"Turns towards the freer side while something is near",
                               "Gira hacia el lado más libre mientras algo está cerca"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "Alonso, robot Nimrod, sections 3 and 5 (EVITAR)"},
    .make = make_bound<ActingModule, AvoidObstacle, AvoidObstacleConfig>};

}  // namespace ganglion
