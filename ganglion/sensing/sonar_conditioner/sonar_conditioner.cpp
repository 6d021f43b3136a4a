#include "ganglion/sensing/sonar_conditioner/sonar_conditioner.h"

#include <algorithm>
#include <cmath>

namespace ganglion {
namespace {

using Config = SonarConditionerConfig;

enum Input : std::size_t { kEchoTime, kRawRange, kTemperature };
enum Output : std::size_t { kRange, kDead };

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDeadReading = std::numeric_limits<double>::quiet_NaN();
constexpr double kInstant_s = 1e-6;  // rounding of times that were added up

constexpr std::array kPorts = {
    PortDescriptor{
        .name = "echo_time",
        .title = {"echo time", "tiempo de eco"},
        .help = {"Time of the echo, there and back; 0 = no pulse", "Tiempo del eco, ida y vuelta; 0 = sin pulso"},
        .unit = "s",
        .required = false},
    PortDescriptor{.name = "raw_range",
                   .title = {"raw range", "distancia bruta"},
                   .help = {"Range, where no echo time is wired", "Distancia, si no hay tiempo del eco"},
                   .unit = "m",
                   .required = false},
    PortDescriptor{.name = "temperature",
                   .title = {"air temperature", "temperatura del aire"},
                   .help = {"Temperature of the air", "Temperatura del aire"},
                   .unit = "degC",
                   .required = false},
    PortDescriptor{.name = "range",
                   .title = {"range", "distancia"},
                   .help = {"Median range; inf nothing, -inf too close, nan dead",
                            "Distancia mediana; inf nada, -inf demasiado cerca, nan muerto"},
                   .role = PortRole::Output,
                   .unit = "m"},
    PortDescriptor{.name = "dead",
                   .title = {"dead", "muerto"},
                   .help = {"1 while there is no valid reading", "1 mientras no hay lectura válida"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
};

constexpr std::array kParameters = {
    parameter<Config, &Config::min_range_m>(
        {.name = "min_range_m",
         .title = {"minimum range", "distancia mínima"},
         .help = {"Below this it is too close to measure", "Por debajo está demasiado cerca para medir"},
         .unit = "m",
         .min = 0,
         .max = 10,
         .live = true}),
    parameter<Config, &Config::max_range_m>({.name = "max_range_m",
                                             .title = {"maximum range", "distancia máxima"},
                                             .help = {"Beyond this there is nothing", "Más allá no hay nada"},
                                             .unit = "m",
                                             .min = 0.01,
                                             .max = 100,
                                             .live = true}),
    parameter<Config, &Config::temperature_C>(
        {.name = "temperature_C",
         .title = {"air temperature", "temperatura del aire"},
         .help = {"Temperature of the air where none is wired", "Temperatura del aire si no se mide"},
         .unit = "degC",
         .min = -50,
         .max = 80,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::dead_after_s>(
        {.name = "dead_after_s",
         .title = {"time until dead", "tiempo hasta muerto"},
         .help = {"A reading older than this counts as none", "Una lectura más vieja no vale"},
         .unit = "s",
         .min = 0.01,
         .max = 60,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::readings>({.name = "readings",
                                          .title = {"readings", "lecturas"},
                                          .help = {"Takes the median of so many", "Toma la mediana de tantas"},
                                          .min = 1,
                                          .max = SonarConditioner::kMaxReadings,
                                          .ours = true}),
};

}  // namespace

Result<void> SonarConditioner::judge(const SonarConditionerConfig& config) {
  if (!(config.min_range_m < config.max_range_m)) {
    return fail(ErrorCode::BadParameter,
                {"min_range_m is {}, must be < max_range_m = {}", "min_range_m es {}, debe ser < max_range_m = {}"},
                config.min_range_m, config.max_range_m);
  }
  return {};
}

void SonarConditioner::perceive(const Feedback& feedback) noexcept {
  const std::size_t port = feedback[kEchoTime].wired() ? kEchoTime : kRawRange;
  const auto ages_s = feedback[port].ages_s;
  const double age_s = ages_s.empty() ? 0 : ages_s[0];
  const double reading_m = age_s > config_.dead_after_s ? kDeadReading : read(feedback, port);
  put(kDead, std::isnan(reading_m) ? 1 : 0);
  if (std::isnan(reading_m)) {
    count_ = 0;
    put(kRange, kDeadReading);
    return;
  }
  const double measured_s = feedback.tick.time_s - age_s;
  if (count_ == 0 || measured_s > measured_s_ + kInstant_s) {  // a repeated reading has one vote
    latest_[static_cast<std::size_t>(count_ % config_.readings)] = reading_m;
    if (++count_ == 2 * config_.readings) count_ = config_.readings;
    measured_s_ = measured_s;
  }
  put(kRange, median());
}

double SonarConditioner::read(const Feedback& feedback, std::size_t port) const noexcept {
  double range_m = feedback.value(port);
  if (port == kEchoTime) {
    if (range_m == 0) return kDeadReading;
    const double measured_C = feedback.value(kTemperature);
    const double air_C = std::isfinite(measured_C) ? measured_C : config_.temperature_C;
    range_m *= speed_of_sound_mps(air_C) / 2;
  }
  if (range_m < config_.min_range_m) return -kInfinity;
  return range_m > config_.max_range_m ? kInfinity : range_m;  // NaN passes both
}

double SonarConditioner::median() const noexcept {
  const double a = latest_[0];
  if (count_ == 1 || config_.readings == 1) return a;
  const double b = latest_[1];
  if (count_ == 2 || config_.readings == 2) return std::min(a, b);
  return std::max(std::min(a, b), std::min(std::max(a, b), latest_[2]));
}

extern constinit const SensingModuleKind sonar_conditioner_kind{
    .descriptor = {.component_class = ComponentClass::Sensing,
                   .name = "SonarConditioner",
                   .summary = {"Turns an echo time or a raw range into a clean range",
                               "Convierte el tiempo de eco o la distancia bruta en una distancia limpia"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "ours"},
    .make = make_bound<SensingModule, SonarConditioner, SonarConditionerConfig>};

}  // namespace ganglion
