#include <array>
#include <cmath>

#include "ganglion/task/go_to/go_to.h"

namespace ganglion {
namespace {

constexpr std::array kTurns_deg = {45.0, 90.0, 180.0};

constexpr std::array<ElementDescriptor, 2> kCell = {"column", "row"};
constexpr std::array kPorts = {
    PortDescriptor{.name = "goal",
                   .title = {"goal", "objetivo"},
                   .help = {"The cell wanted", "La celda deseada"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete,
                   .size = 2,
                   .elements = kCell},
    PortDescriptor{.name = "direction",
                   .title = {"goal bearing", "dirección del objetivo"},
                   .help = {"Bearing of the goal from the robot, in the world",
                            "Dirección del objetivo desde el robot, en el mundo"},
                   .role = PortRole::Output,
                   .unit = "rad",
                   .type = ValueType::Circular},
};
constexpr std::array kParameters = {
    parameter<GoToConfig, &GoToConfig::cell_m>({.name = "cell_m",
                                                .title = {"cell size", "tamaño de celda"},
                                                .help = {"Side of a cell", "Lado de una celda"},
                                                .unit = "m",
                                                .min = 1e-3,
                                                .max = 1000}),
    parameter<GoToConfig, &GoToConfig::goals>({.name = "goals",
                                               .title = {"number of goals", "número de objetivos"},
                                               .help = {"How many goals to draw, where `cells` gives none",
                                                        "Cuántos objetivos sortear, si `cells` no da ninguno"},
                                               .min = 1,
                                               .max = static_cast<double>(GoTo::kMaxGoals),
                                               .ours = true}),
    parameter<GoToConfig, &GoToConfig::sealed_share>(
        {.name = "sealed_share",
         .title = {"unreachable share", "parte inalcanzable"},
         .help = {"Share of the drawn goals that are free but out of reach",
                  "Parte de los objetivos sorteados libres pero inalcanzables"},
         .min = 0,
         .max = 1,
         .ours = true}),
    parameter<GoToConfig, &GoToConfig::patience_s>(
        {.name = "patience_s",
         .title = {"patience", "paciencia"},
         .help = {"A goal is given up after that; 0 = never", "Un objetivo se abandona tras ese tiempo; 0 = nunca"},
         .unit = "s",
         .min = 0,
         .max = 1e6,
         .ours = true,
         .live = true}),
    parameter<GoToConfig, &GoToConfig::max_turn_deg>(
        {.name = "max_turn_deg",
         .title = {"maximum turn", "giro máximo"},
         .help = {"How far the robot turns in one step (45, 90 or 180), for the shortest way it is measured against",
                  "Cuánto gira el robot en un paso (45, 90 o 180), para el camino más corto con que se compara"},
         .unit = "deg",
         .allowed = kTurns_deg,
         .ours = true}),
    parameter<GoToConfig, &GoToConfig::cell_numbers>(
        {.name = "cells",
         .title = {"goal cells", "celdas objetivo"},
         .help = {"Goals in order: column, row, column, row...", "Objetivos en orden: columna, fila, columna, fila..."},
         .min = -1e9,
         .max = 1e9,
         .ours = true}),
};

}  // namespace

Result<void> GoTo::judge(GoToConfig& config) {
  const std::vector<double>& numbers = config.cell_numbers;
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
  config.cells.clear();
  for (std::size_t n = 0; n < numbers.size(); n += 2) {
    if (std::floor(numbers[n]) != numbers[n] || std::floor(numbers[n + 1]) != numbers[n + 1]) {
      return fail(ErrorCode::BadParameter,
                  {"cells has ({}, {}), must be whole numbers", "cells tiene ({}, {}), deben ser números enteros"},
                  numbers[n], numbers[n + 1]);
    }
    config.cells.push_back({static_cast<std::int32_t>(numbers[n]), static_cast<std::int32_t>(numbers[n + 1])});
  }
  return {};
}

extern constinit const TaskKind go_to_kind{
    .descriptor = {.component_class = ComponentClass::Task,
                   .name = "GoTo",
                   .paper_name = "Trainer",
                   .summary = {"Sets cells for the robot to go to, one after the other",
                               "Fija celdas a las que debe ir el robot, una tras otra"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "A growing functional modules locomotion subsystem, section 5; drawing and ledger ours"},
    .make = make_bound<Task, GoTo, GoToConfig>};

}  // namespace ganglion
