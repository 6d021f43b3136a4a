#include "ganglion/sim/sensor/position/position.h"

#include <array>

namespace ganglion::sim {
namespace {

constexpr std::array<ElementDescriptor, 2> kCoordinates = {"x", "y"};
constexpr std::array kPorts = {
    PortDescriptor{.name = "position",
                   .title = {"position", "posición"},
                   .help = {"Where the sensor is, in the world", "Dónde está el sensor, en el mundo"},
                   .role = PortRole::Output,
                   .unit = "m",
                   .size = 2,
                   .elements = kCoordinates},
};
constexpr std::array kParameters = {
    parameter<PositionConfig, &PositionConfig::noise_m>(
        {.name = "noise_m",
         .title = {"noise", "ruido"},
         .help = {"Standard deviation of each coordinate of one reading",
                  "Desviación típica de cada coordenada de una lectura"},
         .unit = "m",
         .min = 0,
         .max = 1000,
         .live = true}),
};

}  // namespace

void Position::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  values[0] = scene.mount().position.x;
  values[1] = scene.mount().position.y;
  if (config_.noise_m <= 0) return;
  values[0] += config_.noise_m * draws.normal();
  values[1] += config_.noise_m * draws.normal();
}

extern constinit const SensorKind position_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "Position",
                   .summary = {"Tells where the robot is", "Indica dónde está el robot"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "ours"},
    .make = make_bound<Sensor, Position, PositionConfig>};

}  // namespace ganglion::sim
