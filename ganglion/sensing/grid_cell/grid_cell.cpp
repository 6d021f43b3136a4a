#include "ganglion/sensing/grid_cell/grid_cell.h"

#include <array>
#include <cmath>
#include <limits>

namespace ganglion {

Result<void> GridCell::judge(const GridCellConfig& config) {
  const double farthest_m = config.cell_m * std::sqrt(0.5);
  if (!(config.reach_m >= 0 && config.reach_m <= farthest_m)) {
    return fail(ErrorCode::BadParameter,
                {"reach_m is {}, must be in [0, {}], the distance to a cell's corner",
                 "reach_m es {}, debe estar en [0, {}], la distancia a la esquina de una celda"},
                config.reach_m, farthest_m);
  }
  return {};
}

void GridCell::perceive(const Feedback& feedback) noexcept {
  const auto position = feedback[0].values;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto cell = output(0);
  if (position.size() < 2 || !std::isfinite(position[0]) || !std::isfinite(position[1])) {
    cell[0] = cell[1] = nan;
    return;
  }
  const Vector2 scaled = Vector2{position[0], position[1]} * (1 / config_.cell_m);
  const Vector2 here{std::floor(scaled.x), std::floor(scaled.y)};
  const double off_centre_m = (scaled - here - Vector2{0.5, 0.5}).length() * config_.cell_m;
  const auto carried_off = [&] { return std::fabs(here.x - reached_->x) > 1 || std::fabs(here.y - reached_->y) > 1; };
  if (!reached_ || config_.reach_m == 0 || off_centre_m <= config_.reach_m || carried_off()) reached_ = here;
  cell[0] = reached_->x;
  cell[1] = reached_->y;
}

namespace {

using Config = GridCellConfig;

constexpr std::array<ElementDescriptor, 2> kXY = {"x", "y"};
constexpr std::array<ElementDescriptor, 2> kColumnRow = {"column", "row"};

constexpr std::array kPorts = {
    PortDescriptor{.name = "position",
                   .title = {"position", "posición"},
                   .help = {"Position in the map's frame", "Posición en el marco del mapa"},
                   .role = PortRole::Feedback,
                   .unit = "m",
                   .size = 2,
                   .elements = kXY},
    PortDescriptor{.name = "cell",
                   .title = {"cell", "celda"},
                   .help = {"Cell reached; NaN while unknown", "Celda alcanzada; NaN mientras se desconoce"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .size = 2,
                   .elements = kColumnRow},
};

constexpr std::array kParameters = {
    parameter<Config, &Config::cell_m>({.name = "cell_m",
                                        .title = {"cell side", "lado de celda"},
                                        .help = {"Side of a cell", "Lado de una celda"},
                                        .unit = "m",
                                        .min = 0.001,
                                        .max = 1000,
                                        .ours = true}),
    parameter<Config, &Config::reach_m>(
        {.name = "reach_m",
         .title = {"reach", "alcance"},
         .help = {"A cell counts as reached within this distance of its centre; 0 = anywhere in it",
                  "Una celda cuenta como alcanzada a esta distancia de su centro; 0 = en toda ella"},
         .unit = "m",
         .min = 0,
         .max = 1000,
         .ours = true,
         .live = true}),
};

}  // namespace

extern constinit const SensingModuleKind grid_cell_kind{
    .descriptor = {.component_class = ComponentClass::Sensing,
                   .name = "GridCell",
                   .summary = {"The cell of a grid that a position lies in",
                               "La celda de una cuadrícula de una posición"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "ours"},
    .make = make_bound<SensingModule, GridCell, GridCellConfig>};

}  // namespace ganglion
