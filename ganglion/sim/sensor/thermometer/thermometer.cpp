#include "ganglion/sim/sensor/thermometer/thermometer.h"

#include <array>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "temperature",
                   .role = PortRole::Output,
                   .unit = "degC",
                   .help = {"Temperature of the air", "Temperatura del aire"}},
};

constexpr ParameterDescriptor celsius(std::string_view name, double preset, double min, double max, Text help) {
  return {.name = name, .unit = "degC", .preset = preset, .min = min, .max = max, .help = help, .ours = true};
}

constexpr std::array kParameters = {
    celsius("air_C", 20, -60, 80,
            {"Temperature of the air away from warmer zones", "Temperatura del aire fuera de zonas más cálidas"}),
    celsius("noise_C", 0.1, 0, 100, {"Standard deviation of one reading", "Desviación típica de una lectura"}),
    celsius("bias_C", 0, -100, 100, {"Added to every reading", "Se suma a cada lectura"}),
    celsius("resolution_C", 0.5, 0, 100,
            {"Readings are multiples of it; 0 = not rounded", "Las lecturas son múltiplos; 0 = sin redondeo"}),
    ParameterDescriptor{.name = "lag_s",
                        .unit = "s",
                        .preset = 0,
                        .min = 0,
                        .max = 3600,
                        .help = {"Time constant of its body", "Constante de tiempo de su cuerpo"},
                        .ours = true},
};

Result<std::unique_ptr<Sensor>> make(const Parameters& parameters) {
  return std::make_unique<Thermometer>(ThermometerConfig{.air_C = parameters.real("air_C"),
                                                         .noise_C = parameters.real("noise_C"),
                                                         .bias_C = parameters.real("bias_C"),
                                                         .lag_s = parameters.real("lag_s"),
                                                         .resolution_C = parameters.real("resolution_C")});
}

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
    .make = make};

}  // namespace ganglion::sim
