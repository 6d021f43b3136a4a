#include "ganglion/sim/sensor/encoders/encoders.h"

#include <array>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "left",
                   .title = {"left travel", "recorrido izquierdo"},
                   .help = {"Way of the left side since the reset", "Camino del lado izquierdo desde el inicio"},
                   .role = PortRole::Output,
                   .unit = "m"},
    PortDescriptor{.name = "right",
                   .title = {"right travel", "recorrido derecho"},
                   .help = {"Way of the right side since the reset", "Camino del lado derecho desde el inicio"},
                   .role = PortRole::Output,
                   .unit = "m"},
};
constexpr std::array kParameters = {
    parameter<EncodersConfig, &EncodersConfig::resolution_m>(
        {.name = "resolution_m",
         .title = {"resolution", "resolución"},
         .help = {"Way of one count; 0 = continuous", "Camino de una cuenta; 0 = continuo"},
         .unit = "m",
         .min = 0,
         .max = 10}),
    parameter<EncodersConfig, &EncodersConfig::left_scale>(
        {.name = "left_scale",
         .title = {"left scale", "escala izquierda"},
         .help = {"Read over true way of the left side", "Camino leído entre el real, lado izquierdo"},
         .min = 0,
         .max = 10,
         .ours = true}),
    parameter<EncodersConfig, &EncodersConfig::right_scale>(
        {.name = "right_scale",
         .title = {"right scale", "escala derecha"},
         .help = {"Read over true way of the right side", "Camino leído entre el real, lado derecho"},
         .min = 0,
         .max = 10,
         .ours = true}),
    parameter<EncodersConfig, &EncodersConfig::scatter_m>(
        {.name = "scatter_m",
         .title = {"scatter", "dispersión"},
         .help = {"Standard deviation of a side's error after 1 m, growing with the root of the way: slip",
                  "Desviación típica del error de un lado tras 1 m, crece con la raíz: deslizamiento"},
         .unit = "m",
         .min = 0,
         .max = 10,
         .ours = true}),
};

double counted_m(double way_m, double resolution_m) noexcept {
  return resolution_m > 0 ? std::floor(way_m / resolution_m) * resolution_m : way_m;
}

}  // namespace

Result<void> Encoders::reset(const Scene&, Draws) {
  left_ = right_ = {};
  return {};
}

double Encoders::read_m(Side& side, double way_m, double scale, Draws& draws) const noexcept {
  if (config_.scatter_m > 0) {
    side.error_m += draws.normal() * config_.scatter_m * std::sqrt(std::fabs(way_m - side.way_m));
    side.way_m = way_m;
  }
  return counted_m(way_m * scale + side.error_m, config_.resolution_m);
}

void Encoders::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  values[0] = read_m(left_, scene.robot.left_m, config_.left_scale, draws);
  values[1] = read_m(right_, scene.robot.right_m, config_.right_scale, draws);
}

extern constinit const SensorKind encoders_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "Encoders",
                   .summary = {"Count the turning of both sides", "Cuentan el giro de ambos lados"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "ours"},
    .make = make_bound<Sensor, Encoders, EncodersConfig>};

}  // namespace ganglion::sim
