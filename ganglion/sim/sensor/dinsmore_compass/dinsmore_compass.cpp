#include "ganglion/sim/sensor/dinsmore_compass/dinsmore_compass.h"

#include <array>
#include <cmath>

#include "ganglion/sim/sensor/magnetic_north.h"

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "va",
                   .role = PortRole::Output,
                   .unit = "V",
                   .help = {"centre + amplitude cos(bearing)", "centro + amplitud cos(rumbo)"}},
    PortDescriptor{.name = "vb",
                   .role = PortRole::Output,
                   .unit = "V",
                   .help = {"centre + amplitude sin(bearing)", "centro + amplitud sen(rumbo)"}},
};

constexpr ParameterDescriptor volts(std::string_view name, double preset, double min, Text help, bool ours = false) {
  return {.name = name, .unit = "V", .preset = preset, .min = min, .max = 100, .help = help, .ours = ours};
}

constexpr std::array kParameters = {
    volts("centre_V", 2.5, 0, {"Voltage midway between the extremes", "Tensión media entre los extremos"}),
    volts("amplitude_V", 0.594, 1e-3,
          {"Half the swing of a full turn; 0.594 fits the listing's 107.14 deg/V",
           "Media oscilación de una vuelta; 0,594 concuerda con los 107,14 grados/V del listado"},
          true),
    ParameterDescriptor{.name = "lag_s",
                        .unit = "s",
                        .preset = 1,
                        .min = 0,
                        .max = 60,
                        .help = {"Time constant of the damped needle", "Constante de tiempo de la aguja amortiguada"},
                        .ours = true},
    volts("noise_V", 0, 0, {"Standard deviation of one reading", "Desviación típica de una lectura"}, true),
    ParameterDescriptor{.name = "bits",
                        .type = ParameterType::Integer,
                        .preset = 10,
                        .min = 0,
                        .max = 24,
                        .help = {"Of the converter; 0 = not rounded", "Del conversor; 0 = sin redondeo"}},
    volts("reference_V", 5, 1e-3, {"Full scale of the converter", "Fondo de escala del conversor"}),
    kMagneticNorth,
};

Result<std::unique_ptr<Sensor>> make(const Parameters& parameters) {
  return std::make_unique<DinsmoreCompass>(
      DinsmoreCompassConfig{.centre_V = parameters.real("centre_V"),
                            .amplitude_V = parameters.real("amplitude_V"),
                            .lag_s = parameters.real("lag_s"),
                            .noise_V = parameters.real("noise_V"),
                            .bits = parameters.integer("bits"),
                            .reference_V = parameters.real("reference_V"),
                            .north = Angle::from_deg(parameters.real("north_deg"))});
}

}  // namespace

Vector2 DinsmoreCompass::bearing(const Scene& scene) const noexcept {
  return direction((config_.north - scene.mount().yaw).rad());
}

Result<void> DinsmoreCompass::reset(const Scene& scene, Draws) {
  needle_ = bearing(scene);
  return {};
}

void DinsmoreCompass::follow(const Scene& scene, double step_s) noexcept {
  needle_ += (bearing(scene) - needle_) * lag_.share(step_s);
}

double DinsmoreCompass::converted_V(double volts) const noexcept {
  if (config_.bits == 0) return std::clamp(volts, 0.0, config_.reference_V);
  const double counts = static_cast<double>(1 << config_.bits);
  return std::clamp(std::floor(volts / config_.reference_V * counts), 0.0, counts - 1) * config_.reference_V / counts;
}

void DinsmoreCompass::measure(const Scene&, Draws& draws, std::span<double> values) noexcept {
  const double noise_a_V = draws.normal() * config_.noise_V;
  const double noise_b_V = draws.normal() * config_.noise_V;
  values[0] = converted_V(config_.centre_V + config_.amplitude_V * needle_.x + noise_a_V);
  values[1] = converted_V(config_.centre_V + config_.amplitude_V * needle_.y + noise_b_V);
}

extern constinit const SensorKind dinsmore_compass_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "DinsmoreCompass",
                   .summary = {"Analogue compass with two voltages, Dinsmore 1655",
                               "Brújula analógica de dos tensiones, Dinsmore 1655"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "Nimrod, section 5 (listing)"},
    .make = make};

}  // namespace ganglion::sim
