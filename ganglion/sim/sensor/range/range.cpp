#include "ganglion/sim/sensor/range/range.h"

#include <array>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "range",
                   .title = {"range", "distancia"},
                   .help = {"Range to the first surface; inf = nothing in range, -inf = too close",
                            "Distancia a la primera superficie; inf = nada al alcance, -inf = demasiado cerca"},
                   .role = PortRole::Output,
                   .unit = "m"},
};
constexpr std::array kParameters = {
    parameter<RangeConfig, &RangeConfig::min_range_m>(
        {.name = "min_range_m",
         .title = {"minimum range", "alcance mínimo"},
         .help = {"Nearer surfaces read -inf", "Superficies más cercanas dan -inf"},
         .unit = "m",
         .min = 0,
         .max = 1000}),
    parameter<RangeConfig, &RangeConfig::max_range_m>(
        {.name = "max_range_m",
         .title = {"maximum range", "alcance máximo"},
         .help = {"Farther surfaces read inf", "Superficies más lejanas dan inf"},
         .unit = "m",
         .min = 1e-3,
         .max = 1000}),
    parameter<RangeConfig, &RangeConfig::noise_m>(
        {.name = "noise_m",
         .title = {"noise", "ruido"},
         .help = {"Standard deviation of one reading", "Desviación típica de una lectura"},
         .unit = "m",
         .min = 0,
         .max = 100}),
};

}  // namespace

Result<void> Range::judge(RangeConfig& config) {
  if (config.min_range_m >= config.max_range_m) {
    return fail(ErrorCode::BadParameter,
                {"min_range_m is {}, must be less than max_range_m = {}",
                 "min_range_m es {}, debe ser menor que max_range_m = {}"},
                config.min_range_m, config.max_range_m);
  }
  return {};
}

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
                                             .make = make_bound<Sensor, Range, RangeConfig>};

}  // namespace ganglion::sim
