#include "ganglion/sim/sensor/tilt/tilt.h"

#include <array>
#include <cmath>

#include "ganglion/math/functions.h"

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "roll",
                   .role = PortRole::Output,
                   .unit = "rad",
                   .help = {"Positive with the left side up", "Positivo con el lado izquierdo arriba"}},
    PortDescriptor{.name = "pitch",
                   .role = PortRole::Output,
                   .unit = "rad",
                   .help = {"Positive with the nose down", "Positivo con el frente abajo"}},
};

constexpr ParameterDescriptor degrees(std::string_view name, double preset, double min, double max, Text help) {
  return {.name = name, .unit = "deg", .preset = preset, .min = min, .max = max, .help = help, .ours = true};
}

constexpr std::array kParameters = {
    degrees("noise_deg", 0.5, 0, 90, {"Standard deviation of one reading", "Desviación típica de una lectura"}),
    degrees("roll_bias_deg", 0, -90, 90, {"Added to every roll", "Se suma a cada alabeo"}),
    degrees("pitch_bias_deg", 0, -90, 90, {"Added to every pitch", "Se suma a cada cabeceo"}),
    degrees("max_deg", 60, 1, 90, {"Readings end there", "Las lecturas acaban ahí"}),
    degrees("resolution_deg", 0, 0, 90,
            {"Readings are multiples of it; 0 = not rounded", "Las lecturas son múltiplos; 0 = sin redondeo"}),
    ParameterDescriptor{.name = "lag_s",
                        .unit = "s",
                        .preset = 0,
                        .min = 0,
                        .max = 60,
                        .help = {"Time constant of the device", "Constante de tiempo del sensor"},
                        .ours = true},
};

Result<std::unique_ptr<Sensor>> make(const Parameters& parameters) {
  const auto rad = [&](std::string_view name) { return Angle::from_deg(parameters.real(name)).rad(); };
  return std::make_unique<Tilt>(TiltConfig{.noise_rad = rad("noise_deg"),
                                           .roll_bias_rad = rad("roll_bias_deg"),
                                           .pitch_bias_rad = rad("pitch_bias_deg"),
                                           .lag_s = parameters.real("lag_s"),
                                           .max_rad = rad("max_deg"),
                                           .resolution_rad = rad("resolution_deg")});
}

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
  if (config_.resolution_rad > 0) {
    angle_rad = std::floor(angle_rad / config_.resolution_rad + 0.5) * config_.resolution_rad;
  }
  return std::clamp(angle_rad, -config_.max_rad, config_.max_rad);
}

void Tilt::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  const Attitude attitude = config_.lag_s > 0 ? Attitude{roll_rad_, pitch_rad_} : attitude_of(scene);
  const double roll_noise_rad = draws.normal() * config_.noise_rad;
  const double pitch_noise_rad = draws.normal() * config_.noise_rad;
  values[0] = read(attitude.roll_rad + config_.roll_bias_rad + roll_noise_rad);
  values[1] = read(attitude.pitch_rad + config_.pitch_bias_rad + pitch_noise_rad);
}

extern constinit const SensorKind tilt_kind{.descriptor = {.component_class = ComponentClass::Sensor,
                                                           .name = "Tilt",
                                                           .summary = {"Roll and pitch from the slope of the floor",
                                                                       "Alabeo y cabeceo por la pendiente del suelo"},
                                                           .ports = kPorts,
                                                           .parameters = kParameters,
                                                           .source = "ours"},
                                            .make = make};

}  // namespace ganglion::sim
