#include "ganglion/sim/sensor/tilt/tilt.h"

#include <array>
#include <cmath>

#include "ganglion/math/functions.h"

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "roll",
                   .title = {"roll", "alabeo"},
                   .help = {"Positive with the left side up", "Positivo con el lado izquierdo arriba"},
                   .role = PortRole::Output,
                   .unit = "rad"},
    PortDescriptor{.name = "pitch",
                   .title = {"pitch", "cabeceo"},
                   .help = {"Positive with the nose down", "Positivo con el frente abajo"},
                   .role = PortRole::Output,
                   .unit = "rad"},
};

constexpr std::array kParameters = {
    parameter<TiltConfig, &TiltConfig::noise>(
        {.name = "noise_deg",
         .title = {"noise", "ruido"},
         .help = {"Standard deviation of one reading", "Desviación típica de una lectura"},
         .unit = "deg",
         .min = 0,
         .max = 90,
         .ours = true,
         .live = true}),
    parameter<TiltConfig, &TiltConfig::roll_bias>({.name = "roll_bias_deg",
                                                   .title = {"roll bias", "sesgo de alabeo"},
                                                   .help = {"Added to every roll", "Se suma a cada alabeo"},
                                                   .unit = "deg",
                                                   .min = -90,
                                                   .max = 90,
                                                   .ours = true,
                                                   .live = true}),
    parameter<TiltConfig, &TiltConfig::pitch_bias>({.name = "pitch_bias_deg",
                                                    .title = {"pitch bias", "sesgo de cabeceo"},
                                                    .help = {"Added to every pitch", "Se suma a cada cabeceo"},
                                                    .unit = "deg",
                                                    .min = -90,
                                                    .max = 90,
                                                    .ours = true,
                                                    .live = true}),
    parameter<TiltConfig, &TiltConfig::max>({.name = "max_deg",
                                             .title = {"measuring limit", "límite de medida"},
                                             .help = {"Readings end there", "Las lecturas acaban ahí"},
                                             .unit = "deg",
                                             .min = 1,
                                             .max = 90,
                                             .ours = true}),
    parameter<TiltConfig, &TiltConfig::resolution>(
        {.name = "resolution_deg",
         .title = {"resolution", "resolución"},
         .help = {"Readings are multiples of it; 0 = not rounded", "Las lecturas son múltiplos; 0 = sin redondeo"},
         .unit = "deg",
         .min = 0,
         .max = 90,
         .ours = true,
         .live = true}),
    parameter<TiltConfig, &TiltConfig::lag_s>(
        {.name = "lag_s",
         .title = {"lag", "retardo"},
         .help = {"Time constant of the device", "Constante de tiempo del sensor"},
         .unit = "s",
         .min = 0,
         .max = 60,
         .ours = true}),
};

struct Attitude {
  double roll_rad = 0;
  double pitch_rad = 0;
};

Attitude attitude_of(const Scene& scene) noexcept {
  const Vector2 gradient = scene.world.ground().plan().floor.gradient_at(scene.mount().position);
  if (gradient == Vector2{}) return {};
  const Vector2 ahead = scene.ahead();
  const double rise = gradient.dot(ahead);
  return {math::atan2(gradient.dot(ahead.left()), std::sqrt(1 + rise * rise)), math::atan2(-rise, 1)};
}

}  // namespace

Result<void> Tilt::reset(const Scene& scene, Draws) {
  const Attitude attitude = attitude_of(scene);
  roll_rad_ = attitude.roll_rad;
  pitch_rad_ = attitude.pitch_rad;
  return {};
}

void Tilt::follow(const Scene& scene, double step_s) noexcept {
  const Attitude attitude = attitude_of(scene);
  const double share = lag_.share(step_s);
  roll_rad_ += (attitude.roll_rad - roll_rad_) * share;
  pitch_rad_ += (attitude.pitch_rad - pitch_rad_) * share;
}

double Tilt::read(double angle_rad) const noexcept {
  if (const double step_rad = config_.resolution.rad(); step_rad > 0) {
    angle_rad = std::floor(angle_rad / step_rad + 0.5) * step_rad;
  }
  return std::clamp(angle_rad, -config_.max.rad(), config_.max.rad());
}

void Tilt::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  const Attitude attitude = config_.lag_s > 0 ? Attitude{roll_rad_, pitch_rad_} : attitude_of(scene);
  const double roll_noise_rad = draws.normal() * config_.noise.rad();
  const double pitch_noise_rad = draws.normal() * config_.noise.rad();
  values[0] = read(attitude.roll_rad + config_.roll_bias.rad() + roll_noise_rad);
  values[1] = read(attitude.pitch_rad + config_.pitch_bias.rad() + pitch_noise_rad);
}

extern constinit const SensorKind tilt_kind{.descriptor = {.component_class = ComponentClass::Sensor,
                                                           .name = "Tilt",
                                                           .summary = {"Roll and pitch from the slope of the floor",
                                                                       "Alabeo y cabeceo por la pendiente del suelo"},
                                                           .ports = kPorts,
                                                           .parameters = kParameters,
                                                           .source = "ours"},
                                            .make = make_bound<Sensor, Tilt, TiltConfig>};

}  // namespace ganglion::sim
