#include "ganglion/sensing/sonar_conditioner/sonar_conditioner.h"

#include <algorithm>
#include <cmath>

namespace ganglion {
namespace {

enum Input : std::size_t { kEchoTime, kRawRange, kTemperature };
enum Output : std::size_t { kRange, kDead };

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDeadReading = std::numeric_limits<double>::quiet_NaN();
constexpr double kInstant_s = 1e-6;  // rounding of times that were added up

constexpr std::array kPorts = {
    PortDescriptor{
        .name = "echo_time",
        .unit = "s",
        .required = false,
        .help = {"Time of the echo, there and back; 0 = no pulse", "Tiempo del eco, ida y vuelta; 0 = sin pulso"}},
    PortDescriptor{.name = "raw_range",
                   .unit = "m",
                   .required = false,
                   .help = {"Range, where no echo time is wired", "Distancia, si no hay tiempo del eco"}},
    PortDescriptor{.name = "temperature",
                   .unit = "degC",
                   .required = false,
                   .help = {"Temperature of the air", "Temperatura del aire"}},
    PortDescriptor{.name = "range",
                   .role = PortRole::Output,
                   .unit = "m",
                   .help = {"Median range; inf nothing, -inf too close, nan dead",
                            "Distancia mediana; inf nada, -inf demasiado cerca, nan muerto"}},
    PortDescriptor{.name = "dead",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .help = {"1 while there is no valid reading", "1 mientras no hay lectura válida"}},
};

constexpr std::array kParameters = {
    ParameterDescriptor{
        .name = "min_range_m",
        .unit = "m",
        .preset = 0.02,
        .min = 0,
        .max = 10,
        .help = {"Below this it is too close to measure", "Por debajo está demasiado cerca para medir"}},
    ParameterDescriptor{.name = "max_range_m",
                        .unit = "m",
                        .preset = 3.0,
                        .min = 0.01,
                        .max = 100,
                        .help = {"Beyond this there is nothing", "Más allá no hay nada"}},
    ParameterDescriptor{.name = "temperature_C",
                        .unit = "degC",
                        .preset = 20,
                        .min = -50,
                        .max = 80,
                        .help = {"Temperature of the air where none is wired", "Temperatura del aire si no se mide"},
                        .ours = true},
    ParameterDescriptor{.name = "dead_after_s",
                        .unit = "s",
                        .preset = 0.5,
                        .min = 0.01,
                        .max = 60,
                        .help = {"A reading older than this counts as none", "Una lectura más vieja no vale"},
                        .ours = true},
    ParameterDescriptor{.name = "readings",
                        .type = ParameterType::Integer,
                        .preset = 3,
                        .min = 1,
                        .max = SonarConditioner::kMaxReadings,
                        .help = {"Takes the median of so many", "Toma la mediana de tantas"},
                        .ours = true},
};

}  // namespace

Result<std::unique_ptr<SensingModule>> SonarConditioner::make(const Parameters& parameters) {
  SonarConditionerConfig config;
  config.min_range_m = parameters.real("min_range_m");
  config.max_range_m = parameters.real("max_range_m");
  config.temperature_C = parameters.real("temperature_C");
  config.dead_after_s = parameters.real("dead_after_s");
  config.readings = parameters.integer("readings");
  if (!(config.min_range_m < config.max_range_m)) {
    return fail(ErrorCode::BadParameter,
                {"min_range_m is {}, must be < max_range_m = {}", "min_range_m es {}, debe ser < max_range_m = {}"},
                config.min_range_m, config.max_range_m);
  }
  return std::make_unique<SonarConditioner>(config);
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
    .make = SonarConditioner::make};

}  // namespace ganglion
