#include <array>
#include <cmath>

#include "ganglion/sim/sensor/trainer/trainer.h"

namespace ganglion::sim {
namespace {

constexpr std::size_t kMaxGoals = 10000;

constexpr std::array<ElementDescriptor, 2> kCell = {"column", "row"};
constexpr std::array kPorts = {
    PortDescriptor{.name = "goal",
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .size = 2,
                   .elements = kCell,
                   .help = {"The cell wanted", "La celda deseada"}},
    PortDescriptor{.name = "direction",
                   .role = PortRole::Output,
                   .unit = "rad",
                   .type = ValueType::Circular,
                   .help = {"Bearing of the goal from the robot, in the world",
                            "Dirección del objetivo desde el robot, en el mundo"}},
};
constexpr std::array kParameters = {
    ParameterDescriptor{.name = "cell_m",
                        .unit = "m",
                        .preset = 0.5,
                        .min = 1e-3,
                        .max = 1000,
                        .help = {"Side of a cell", "Lado de una celda"}},
    ParameterDescriptor{.name = "goals",
                        .type = ParameterType::Integer,
                        .preset = 20,
                        .min = 1,
                        .max = static_cast<double>(kMaxGoals),
                        .help = {"How many goals to draw, where `cells` gives none",
                                 "Cuántos objetivos sortear, si `cells` no da ninguno"},
                        .ours = true},
    ParameterDescriptor{.name = "sealed_share",
                        .preset = 0,
                        .min = 0,
                        .max = 1,
                        .help = {"Share of the drawn goals that are free but out of reach",
                                 "Parte de los objetivos sorteados libres pero inalcanzables"},
                        .ours = true},
    ParameterDescriptor{
        .name = "patience_s",
        .unit = "s",
        .preset = 0,
        .min = 0,
        .max = 1e6,
        .help = {"A goal is given up after that; 0 = never", "Un objetivo se abandona tras ese tiempo; 0 = nunca"},
        .ours = true},
    ParameterDescriptor{
        .name = "max_turn_deg",
        .type = ParameterType::Integer,
        .unit = "deg",
        .preset = 180,
        .min = 45,
        .max = 180,
        .help = {"How far the robot turns in one step (45, 90 or 180), for the shortest way it is measured against",
                 "Cuánto gira el robot en un paso (45, 90 o 180), para el camino más corto con que se compara"},
        .ours = true},
    ParameterDescriptor{
        .name = "cells",
        .type = ParameterType::Reals,
        .min = -1e9,
        .max = 1e9,
        .help = {"Goals in order: column, row, column, row...", "Objetivos en orden: columna, fila, columna, fila..."},
        .ours = true},
};

Result<std::vector<CellGrid::Cell>> cells_of(std::span<const double> numbers) {
  std::vector<CellGrid::Cell> cells;
  if (numbers.size() % 2 != 0) {
    return fail(ErrorCode::BadParameter,
                {"cells has {} numbers, must be pairs of column and row",
                 "cells tiene {} números, deben ser pares de columna y fila"},
                numbers.size());
  }
  if (numbers.size() / 2 > kMaxGoals) {
    return fail(ErrorCode::TooLarge,
                {"cells has {} goals; the limit is {}", "cells tiene {} objetivos; el límite es {}"},
                numbers.size() / 2, kMaxGoals);
  }
  for (std::size_t n = 0; n < numbers.size(); n += 2) {
    if (std::floor(numbers[n]) != numbers[n] || std::floor(numbers[n + 1]) != numbers[n + 1]) {
      return fail(ErrorCode::BadParameter,
                  {"cells has ({}, {}), must be whole numbers", "cells tiene ({}, {}), deben ser números enteros"},
                  numbers[n], numbers[n + 1]);
    }
    cells.push_back({static_cast<std::int32_t>(numbers[n]), static_cast<std::int32_t>(numbers[n + 1])});
  }
  return cells;
}

Result<std::unique_ptr<Sensor>> make(const Parameters& parameters) {
  const int turn_deg = parameters.integer("max_turn_deg");
  if (turn_deg != 45 && turn_deg != 90 && turn_deg != 180) {
    return fail(ErrorCode::BadParameter,
                {"max_turn_deg is {}, must be 45, 90 or 180", "max_turn_deg es {}, debe ser 45, 90 o 180"}, turn_deg);
  }
  auto cells = cells_of(parameters.reals("cells"));
  if (!cells) return tl::unexpected<Error>(cells.error());
  return std::make_unique<Trainer>(TrainerConfig{.cell_m = parameters.real("cell_m"),
                                                 .goals = parameters.integer("goals"),
                                                 .sealed_share = parameters.real("sealed_share"),
                                                 .patience_s = parameters.real("patience_s"),
                                                 .max_turn_deg = turn_deg,
                                                 .cells = std::move(*cells)});
}

}  // namespace

extern constinit const SensorKind trainer_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "Trainer",
                   .summary = {"Sets goals for the robot, one after the other",
                               "Fija objetivos al robot, uno tras otro"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "A growing functional modules locomotion subsystem, section 5; drawing and log ours"},
    .make = make};

}  // namespace ganglion::sim
