#include "ganglion/sensing/grid_cell/grid_cell.h"

#include <array>
#include <cmath>
#include <limits>

namespace ganglion {

Result<std::unique_ptr<GridCell>> GridCell::make(const GridCellConfig& config) {
  if (!(config.cell_m > 0) || !std::isfinite(config.cell_m)) {
    return fail(ErrorCode::BadParameter, {"cell_m is {}, must be > 0", "cell_m es {}, debe ser > 0"}, config.cell_m);
  }
  const double farthest_m = config.cell_m * std::sqrt(0.5);
  if (!(config.reach_m >= 0 && config.reach_m <= farthest_m)) {
    return fail(ErrorCode::BadParameter,
                {"reach_m is {}, must be in [0, {}], the distance to a cell's corner",
                 "reach_m es {}, debe estar en [0, {}], la distancia a la esquina de una celda"},
                config.reach_m, farthest_m);
  }
  return std::unique_ptr<GridCell>(new GridCell(config));
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

constexpr std::array<ElementDescriptor, 2> kXY = {"x", "y"};
constexpr std::array<ElementDescriptor, 2> kColumnRow = {"column", "row"};

constexpr std::array kPorts = {
    PortDescriptor{.name = "position",
                   .role = PortRole::Feedback,
                   .unit = "m",
                   .size = 2,
                   .elements = kXY,
                   .help = {"Position in the map's frame", "Posición en el marco del mapa"}},
    PortDescriptor{.name = "cell",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .size = 2,
                   .elements = kColumnRow,
                   .help = {"Cell reached; NaN while unknown", "Celda alcanzada; NaN mientras se desconoce"}},
};

constexpr std::array kParameters = {
    ParameterDescriptor{.name = "cell_m",
                        .unit = "m",
                        .preset = 0.5,
                        .min = 0.001,
                        .max = 1000,
                        .help = {"Side of a cell", "Lado de una celda"},
                        .ours = true},
    ParameterDescriptor{.name = "reach_m",
                        .unit = "m",
                        .preset = 0,
                        .min = 0,
                        .max = 1000,
                        .help = {"A cell counts as reached within this distance of its centre; 0 = anywhere in it",
                                 "Una celda cuenta como alcanzada a esta distancia de su centro; 0 = en toda ella"},
                        .ours = true},
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
    .make = [](const Parameters& parameters) -> Result<std::unique_ptr<SensingModule>> {
      auto made = GridCell::make({parameters.real("cell_m"), parameters.real("reach_m")});
      if (!made) return tl::unexpected<Error>(made.error());
      return std::unique_ptr<SensingModule>(std::move(*made));
    }};

}  // namespace ganglion
