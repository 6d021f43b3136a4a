#include "ganglion/sim/sensor/encoders/encoders.h"

#include <array>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "left",
                   .role = PortRole::Output,
                   .unit = "m",
                   .help = {"Way of the left side since the reset", "Camino del lado izquierdo desde el inicio"}},
    PortDescriptor{.name = "right",
                   .role = PortRole::Output,
                   .unit = "m",
                   .help = {"Way of the right side since the reset", "Camino del lado derecho desde el inicio"}},
};
constexpr std::array kParameters = {
    ParameterDescriptor{.name = "resolution_m",
                        .unit = "m",
                        .preset = 0,
                        .min = 0,
                        .max = 10,
                        .help = {"Way of one count; 0 = continuous", "Camino de una cuenta; 0 = continuo"}},
    ParameterDescriptor{.name = "left_scale",
                        .preset = 1,
                        .min = 0,
                        .max = 10,
                        .help = {"Read over true way of the left side", "Camino leído entre el real, lado izquierdo"},
                        .ours = true},
    ParameterDescriptor{.name = "right_scale",
                        .preset = 1,
                        .min = 0,
                        .max = 10,
                        .help = {"Read over true way of the right side", "Camino leído entre el real, lado derecho"},
                        .ours = true},
    ParameterDescriptor{
        .name = "scatter_m",
        .unit = "m",
        .preset = 0,
        .min = 0,
        .max = 10,
        .help = {"Standard deviation of a side's error after 1 m, growing with the root of the way: slip",
                 "Desviación típica del error de un lado tras 1 m, crece con la raíz: deslizamiento"},
        .ours = true},
};

Result<std::unique_ptr<Sensor>> make(const Parameters& parameters) {
  return std::make_unique<Encoders>(EncodersConfig{parameters.real("resolution_m"), parameters.real("left_scale"),
                                                   parameters.real("right_scale"), parameters.real("scatter_m")});
}

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
    .make = make};

}  // namespace ganglion::sim
