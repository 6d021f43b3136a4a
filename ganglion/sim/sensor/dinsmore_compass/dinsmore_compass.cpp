#include "ganglion/sim/sensor/dinsmore_compass/dinsmore_compass.h"

#include <array>
#include <cmath>

#include "ganglion/sim/sensor/magnetic_north.h"

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "va",
                   .title = {"cosine voltage", "tensión del coseno"},
                   .help = {"centre + amplitude cos(bearing)", "centro + amplitud cos(rumbo)"},
                   .role = PortRole::Output,
                   .unit = "V"},
    PortDescriptor{.name = "vb",
                   .title = {"sine voltage", "tensión del seno"},
                   .help = {"centre + amplitude sin(bearing)", "centro + amplitud sen(rumbo)"},
                   .role = PortRole::Output,
                   .unit = "V"},
};

using Config = DinsmoreCompassConfig;

constexpr std::array kParameters = {
    parameter<Config, &Config::centre_V>(
        {.name = "centre_V",
         .title = {"centre voltage", "tensión central"},
         .help = {"Voltage midway between the extremes", "Tensión media entre los extremos"},
         .unit = "V",
         .min = 0,
         .max = 100}),
    parameter<Config, &Config::amplitude_V>(
        {.name = "amplitude_V",
         .title = {"amplitude", "amplitud"},
         .help = {"Half the swing of a full turn; 0.594 fits the listing's 107.14 deg/V",
                  "Media oscilación de una vuelta; 0,594 concuerda con los 107,14 grados/V del listado"},
         .unit = "V",
         .min = 1e-3,
         .max = 100,
         .ours = true}),
    parameter<Config, &Config::lag_s>(
        {.name = "lag_s",
         .title = {"lag", "retardo"},
         .help = {"Time constant of the damped needle", "Constante de tiempo de la aguja amortiguada"},
         .unit = "s",
         .min = 0,
         .max = 60,
         .ours = true}),
    parameter<Config, &Config::noise_V>(
        {.name = "noise_V",
         .title = {"noise", "ruido"},
         .help = {"Standard deviation of one reading", "Desviación típica de una lectura"},
         .unit = "V",
         .min = 0,
         .max = 100,
         .ours = true,
         .live = true}),
    parameter<Config, &Config::bits>({.name = "bits",
                                      .title = {"converter bits", "bits del conversor"},
                                      .help = {"Of the converter; 0 = not rounded", "Del conversor; 0 = sin redondeo"},
                                      .min = 0,
                                      .max = 24}),
    parameter<Config, &Config::reference_V>({.name = "reference_V",
                                             .title = {"full scale", "fondo de escala"},
                                             .help = {"Full scale of the converter", "Fondo de escala del conversor"},
                                             .unit = "V",
                                             .min = 1e-3,
                                             .max = 100}),
    magnetic_north_parameter<Config>(),
};

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
    .make = make_bound<Sensor, DinsmoreCompass, DinsmoreCompassConfig>};

}  // namespace ganglion::sim
