#include "ganglion/sim/sensor/compass/compass.h"

#include <array>
#include <cmath>

#include "ganglion/math/functions.h"

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "heading",
                   .title = {"heading", "rumbo"},
                   .help = {"Yaw in the world, counter-clockwise from x", "Rumbo en el mundo, antihorario desde x"},
                   .role = PortRole::Output,
                   .unit = "rad",
                   .type = ValueType::Circular},
};

constexpr std::array kParameters = {
    parameter<CompassConfig, &CompassConfig::noise>(
        {.name = "noise_deg",
         .title = {"noise", "ruido"},
         .help = {"Standard deviation of one reading", "Desviación típica de una lectura"},
         .unit = "deg",
         .min = 0,
         .max = 180}),
    parameter<CompassConfig, &CompassConfig::bias>({.name = "bias_deg",
                                                    .title = {"bias", "sesgo"},
                                                    .help = {"Added to every reading", "Se suma a cada lectura"},
                                                    .unit = "deg",
                                                    .min = -180,
                                                    .max = 180,
                                                    .live = true}),
    parameter<CompassConfig, &CompassConfig::local_bias>(
        {.name = "local_bias_deg",
         .title = {"local bias", "sesgo local"},
         .help = {"Amplitude of a bias that varies with the place", "Amplitud de un sesgo que varía con el lugar"},
         .unit = "deg",
         .min = 0,
         .max = 180,
         .ours = true,
         .live = true}),
    parameter<CompassConfig, &CompassConfig::local_length_m>(
        {.name = "local_length_m",
         .title = {"local bias period", "período del sesgo"},
         .help = {"Way over which that bias goes through one period", "Distancia en que ese sesgo recorre un período"},
         .unit = "m",
         .min = 0.01,
         .max = 10000,
         .ours = true}),
    parameter<CompassConfig, &CompassConfig::lag_s>(
        {.name = "lag_s",
         .title = {"lag", "retardo"},
         .help = {"Time constant of the needle", "Constante de tiempo de la aguja"},
         .unit = "s",
         .min = 0,
         .max = 60}),
    parameter<CompassConfig, &CompassConfig::resolution>(
        {.name = "resolution_deg",
         .title = {"resolution", "resolución"},
         .help = {"Readings are multiples of it; 0 = not rounded", "Las lecturas son múltiplos; 0 = sin redondeo"},
         .unit = "deg",
         .min = 0,
         .max = 90,
         .live = true}),
};

}  // namespace

Result<void> Compass::reset(const Scene& scene, Draws) {
  needle_ = direction(scene.mount().yaw.rad());
  return {};
}

void Compass::follow(const Scene& scene, double step_s) noexcept {
  needle_ += (direction(scene.mount().yaw.rad()) - needle_) * lag_.share(step_s);
}

void Compass::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  double heading_rad = config_.lag_s > 0 ? math::atan2(needle_.y, needle_.x) : scene.mount().yaw.rad();
  heading_rad += config_.bias.rad();
  if (config_.local_bias.rad() > 0) {
    const double wave_radpm = 2 * kPi / config_.local_length_m;
    heading_rad += config_.local_bias.rad() * math::sin(wave_radpm * scene.mount().position.x) *
                   math::cos(wave_radpm * scene.mount().position.y);
  }
  if (config_.noise.rad() > 0) heading_rad += config_.noise.rad() * draws.normal();
  if (const double step_rad = config_.resolution.rad(); step_rad > 0) {
    heading_rad = std::floor(heading_rad / step_rad + 0.5) * step_rad;
  }
  values[0] = wrap_rad(heading_rad);
}

extern constinit const SensorKind compass_kind{.descriptor = {.component_class = ComponentClass::Sensor,
                                                              .name = "Compass",
                                                              .summary = {"Tells the heading", "Indica el rumbo"},
                                                              .ports = kPorts,
                                                              .parameters = kParameters,
                                                              .source = "ours"},
                                               .make = make_bound<Sensor, Compass, CompassConfig>};

}  // namespace ganglion::sim
