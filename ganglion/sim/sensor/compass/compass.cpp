#include "ganglion/sim/sensor/compass/compass.h"

#include <array>
#include <cmath>

#include "ganglion/math/functions.h"

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "heading",
                   .role = PortRole::Output,
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .help = {"Yaw in the world, counter-clockwise from x", "Rumbo en el mundo, antihorario desde x"}},
};

constexpr ParameterDescriptor degrees(std::string_view name, double max, Text help, bool ours = false) {
  return {.name = name,
          .unit = "deg",
          .preset = 0,
          .min = name == "bias_deg" ? -max : 0,
          .max = max,
          .help = help,
          .ours = ours};
}

constexpr std::array kParameters = {
    degrees("noise_deg", 180, {"Standard deviation of one reading", "Desviación típica de una lectura"}),
    degrees("bias_deg", 180, {"Added to every reading", "Se suma a cada lectura"}),
    degrees("local_bias_deg", 180,
            {"Amplitude of a bias that varies with the place", "Amplitud de un sesgo que varía con el lugar"}, true),
    ParameterDescriptor{
        .name = "local_length_m",
        .unit = "m",
        .preset = 5,
        .min = 0.01,
        .max = 10000,
        .help = {"Way over which that bias goes through one period", "Distancia en que ese sesgo recorre un período"},
        .ours = true},
    ParameterDescriptor{.name = "lag_s",
                        .unit = "s",
                        .preset = 0,
                        .min = 0,
                        .max = 60,
                        .help = {"Time constant of the needle", "Constante de tiempo de la aguja"}},
    degrees("resolution_deg", 90,
            {"Readings are multiples of it; 0 = not rounded", "Las lecturas son múltiplos; 0 = sin redondeo"}),
};

Result<std::unique_ptr<Sensor>> make(const Parameters& parameters) {
  const auto rad = [&](std::string_view name) { return Angle::from_deg(parameters.real(name)).rad(); };
  return std::make_unique<Compass>(CompassConfig{.noise_rad = rad("noise_deg"),
                                                 .bias_rad = rad("bias_deg"),
                                                 .local_bias_rad = rad("local_bias_deg"),
                                                 .local_length_m = parameters.real("local_length_m"),
                                                 .lag_s = parameters.real("lag_s"),
                                                 .resolution_rad = rad("resolution_deg")});
}

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
  heading_rad += config_.bias_rad;
  if (config_.local_bias_rad > 0) {
    const double wave_radpm = 2 * kPi / config_.local_length_m;
    heading_rad += config_.local_bias_rad * math::sin(wave_radpm * scene.mount().position.x) *
                   math::cos(wave_radpm * scene.mount().position.y);
  }
  if (config_.noise_rad > 0) heading_rad += config_.noise_rad * draws.normal();
  if (config_.resolution_rad > 0) {
    heading_rad = std::floor(heading_rad / config_.resolution_rad + 0.5) * config_.resolution_rad;
  }
  values[0] = wrap_rad(heading_rad);
}

extern constinit const SensorKind compass_kind{.descriptor = {.component_class = ComponentClass::Sensor,
                                                              .name = "Compass",
                                                              .summary = {"Tells the heading", "Indica el rumbo"},
                                                              .ports = kPorts,
                                                              .parameters = kParameters,
                                                              .source = "ours"},
                                               .make = make};

}  // namespace ganglion::sim
