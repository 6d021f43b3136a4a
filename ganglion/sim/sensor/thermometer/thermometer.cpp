#include "ganglion/sim/sensor/thermometer/thermometer.h"

#include <array>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "temperature",
                   .title = {"temperature", "temperatura"},
                   .help = {"Temperature of the air", "Temperatura del aire"},
                   .role = PortRole::Output,
                   .unit = "degC"},
};

using Config = ThermometerConfig;

constexpr std::array kParameters = {
    parameter<Config, &Config::air_C>(
        {.name = "air_C",
         .title = {"air temperature", "temperatura del aire"},
         .help = {"Temperature of the air away from warmer zones", "Temperatura del aire fuera de zonas más cálidas"},
         .unit = "degC",
         .min = -60,
         .max = 80,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::noise_C>(
        {.name = "noise_C",
         .title = {"noise", "ruido"},
         .help = {"Standard deviation of one reading", "Desviación típica de una lectura"},
         .unit = "degC",
         .min = 0,
         .max = 100,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::bias_C>({.name = "bias_C",
                                        .title = {"bias", "sesgo"},
                                        .help = {"Added to every reading", "Se suma a cada lectura"},
                                        .unit = "degC",
                                        .min = -100,
                                        .max = 100,
                                        .ours = true,
                                        .live = true}),
    parameter<Config, &Config::resolution_C>(
        {.name = "resolution_C",
         .title = {"resolution", "resolución"},
         .help = {"Readings are multiples of it; 0 = not rounded", "Las lecturas son múltiplos; 0 = sin redondeo"},
         .unit = "degC",
         .min = 0,
         .max = 100,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::lag_s>({.name = "lag_s",
                                       .title = {"lag", "retardo"},
                                       .help = {"Time constant of its body", "Constante de tiempo de su cuerpo"},
                                       .unit = "s",
                                       .min = 0,
                                       .max = 3600,
                                       .ours = true}),
};

}  // namespace

double Thermometer::air_C(const Scene& scene) const noexcept {
  return config_.air_C + scene.world.ground().plan().floor.warmer_C_at(scene.mount().position);
}

Result<void> Thermometer::reset(const Scene& scene, Draws) {
  body_C_ = air_C(scene);
  return {};
}

void Thermometer::follow(const Scene& scene, double step_s) noexcept {
  body_C_ += (air_C(scene) - body_C_) * lag_.share(step_s);
}

void Thermometer::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  const double true_C = config_.lag_s > 0 ? body_C_ : air_C(scene);
  double read_C = true_C + config_.bias_C + draws.normal() * config_.noise_C;
  if (config_.resolution_C > 0) read_C = std::floor(read_C / config_.resolution_C + 0.5) * config_.resolution_C;
  values[0] = std::clamp(read_C, limits(0).min, limits(0).max);
}

extern constinit const SensorKind thermometer_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "Thermometer",
                   .summary = {"Temperature of the air", "Temperatura del aire"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "ours"},
    .make = make_bound<Sensor, Thermometer, ThermometerConfig>};

}  // namespace ganglion::sim
