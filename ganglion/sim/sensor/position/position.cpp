#include "ganglion/sim/sensor/position/position.h"

#include <array>

namespace ganglion::sim {
namespace {

constexpr std::array<ElementDescriptor, 2> kCoordinates = {"x", "y"};
constexpr std::array kPorts = {
    PortDescriptor{.name = "position",
                   .role = PortRole::Output,
                   .unit = "m",
                   .size = 2,
                   .elements = kCoordinates,
                   .help = {"Where the sensor is, in the world", "Dónde está el sensor, en el mundo"}},
};
constexpr std::array kParameters = {
    ParameterDescriptor{.name = "noise_m",
                        .unit = "m",
                        .preset = 0,
                        .min = 0,
                        .max = 1000,
                        .help = {"Standard deviation of each coordinate of one reading",
                                 "Desviación típica de cada coordenada de una lectura"}},
};

Result<std::unique_ptr<Sensor>> make(const Parameters& parameters) {
  return std::make_unique<Position>(parameters.real("noise_m"));
}

}  // namespace

void Position::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  values[0] = scene.mount().position.x;
  values[1] = scene.mount().position.y;
  if (noise_m_ <= 0) return;
  values[0] += noise_m_ * draws.normal();
  values[1] += noise_m_ * draws.normal();
}

extern constinit const SensorKind position_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "Position",
                   .summary = {"Tells where the robot is", "Indica dónde está el robot"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "ours"},
    .make = make};

}  // namespace ganglion::sim
