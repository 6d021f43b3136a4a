#include "ganglion/sim/sensor/range/range.h"

#include <array>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "range",
                   .role = PortRole::Output,
                   .unit = "m",
                   .help = {"Range to the first surface; inf = nothing in range, -inf = too close",
                            "Distancia a la primera superficie; inf = nada al alcance, -inf = demasiado cerca"}},
};
constexpr std::array kParameters = {
    ParameterDescriptor{.name = "min_range_m",
                        .unit = "m",
                        .preset = 0,
                        .min = 0,
                        .max = 1000,
                        .help = {"Nearer surfaces read -inf", "Superficies más cercanas dan -inf"}},
    ParameterDescriptor{.name = "max_range_m",
                        .unit = "m",
                        .preset = 3,
                        .min = 1e-3,
                        .max = 1000,
                        .help = {"Farther surfaces read inf", "Superficies más lejanas dan inf"}},
    ParameterDescriptor{.name = "noise_m",
                        .unit = "m",
                        .preset = 0,
                        .min = 0,
                        .max = 100,
                        .help = {"Standard deviation of one reading", "Desviación típica de una lectura"}},
};

Result<std::unique_ptr<Sensor>> make(const Parameters& parameters) {
  const RangeConfig config{parameters.real("min_range_m"), parameters.real("max_range_m"), parameters.real("noise_m")};
  if (config.min_range_m >= config.max_range_m) {
    return fail(ErrorCode::BadParameter,
                {"min_range_m is {}, must be less than max_range_m = {}",
                 "min_range_m es {}, debe ser menor que max_range_m = {}"},
                config.min_range_m, config.max_range_m);
  }
  return std::make_unique<Range>(config);
}

}  // namespace

void Range::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  const double noise_m = config_.noise_m > 0 ? draws.normal() * config_.noise_m : 0;
  const double reading_m = ideal().reading_m(first_range_m(scene, kAhead, 0, config_.max_range_m));
  const bool seen = std::isfinite(reading_m);
  values[0] = seen ? std::clamp(reading_m + noise_m, config_.min_range_m, config_.max_range_m) : reading_m;
}

extern constinit const SensorKind range_kind{.descriptor = {.component_class = ComponentClass::Sensor,
                                                            .name = "Range",
                                                            .summary = {"One ideal ray", "Un rayo ideal"},
                                                            .ports = kPorts,
                                                            .parameters = kParameters,
                                                            .source = "ours"},
                                             .make = make};

}  // namespace ganglion::sim
