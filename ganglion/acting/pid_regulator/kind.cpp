#include <array>

#include "ganglion/acting/pid_regulator/pid_regulator.h"

namespace ganglion {
namespace {

using Config = PidRegulatorConfig;

constexpr std::array<std::string_view, 2> kDrives = {"single", "tracks"};
constexpr std::array<ElementDescriptor, 2> kSides = {"left", "right"};

constexpr PortDescriptor kSetpointPort{
    .name = "setpoint",
    .title = {"set-point", "consigna"},
    .help = {"What the value shall be, from now on", "Lo que ha de valer, desde ahora"},
    .role = PortRole::Request,
    .unit = "*",
    .standing = true};
constexpr PortDescriptor kValuePort{
    .name = "value", .title = {"value", "valor"}, .help = {"What is held", "Lo que se mantiene"}, .unit = "*"};
constexpr PortDescriptor kCommandPort{.name = "command",
                                      .title = {"command", "mando"},
                                      .help = {"One value; with drives = \"tracks\" the duties {left, right}",
                                               "Un valor; con drives = \"tracks\" los ciclos de trabajo {left, right}"},
                                      .role = PortRole::Command,
                                      .unit = "*"};

constexpr PortDescriptor part(std::string_view name, Text title, Text help) {
  return {.name = name, .title = title, .help = help, .role = PortRole::Output};
}

constexpr std::array kPorts = {
    kSetpointPort,
    kValuePort,
    kCommandPort,
    part("error", {"error", "error"}, {"Set-point less value", "Consigna menos valor"}),
    part("proportional", {"proportional part", "parte proporcional"},
         {"Its part of the command", "Su parte del mando"}),
    part("integral", {"integral part", "parte integral"}, {"Its part of the command", "Su parte del mando"}),
    part("derivative", {"derivative part", "parte derivativa"}, {"Its part of the command", "Su parte del mando"}),
};

constexpr std::array kParameters = {
    parameter<Config, &Config::drives>(
        {.name = "drives",
         .title = {"what it drives", "qué conduce"},
         .help = {"single: one value; tracks: the duties of two tracks or wheels, which turn by it",
                  "single: un valor; tracks: los ciclos de trabajo de dos orugas o ruedas, que giran con él"},
         .choices = kDrives,
         .ours = true}),
    parameter<Config, &Config::kp>({.name = "kp",
                                    .title = {"proportional gain", "ganancia proporcional"},
                                    .help = {"Command for each unit of error", "Mando por cada unidad de error"},
                                    .min = -1e6,
                                    .max = 1e6,
                                    .live = true}),
    parameter<Config, &Config::ki_per_s>(
        {.name = "ki_per_s",
         .title = {"integral gain", "ganancia integral"},
         .help = {"Command that grows in a second for each unit of error; kp / Ti in the book's form",
                  "Mando que crece en un segundo por cada unidad de error; kp / Ti en la forma del libro"},
         .unit = "1/s",
         .min = -1e6,
         .max = 1e6,
         .live = true}),
    parameter<Config, &Config::kd_s>(
        {.name = "kd_s",
         .title = {"derivative gain", "ganancia derivativa"},
         .help = {"Command against each unit of the value's rate; kp Td in the book's form",
                  "Mando contra cada unidad de la velocidad del valor; kp Td en la forma del libro"},
         .unit = "s",
         .min = -1e6,
         .max = 1e6,
         .live = true}),
    parameter<Config, &Config::setpoint_weight>(
        {.name = "setpoint_weight",
         .title = {"set-point weight", "peso de la consigna"},
         .help = {"Of the set-point in the proportional part: less than 1 overshoots less after a jump",
                  "De la consigna en la parte proporcional: menos de 1 sobrepasa menos tras un salto"},
         .min = 0,
         .max = 1,
         .live = true}),
    parameter<Config, &Config::filter_s>(
        {.name = "filter_s",
         .title = {"derivative filter", "filtro de la derivada"},
         .help = {"Time constant that smooths the derivative", "Constante de tiempo que suaviza la derivada"},
         .unit = "s",
         .min = 0,
         .max = 3600,
         .live = true}),
    parameter<Config, &Config::base>({.name = "base",
                                      .title = {"base", "base"},
                                      .help = {"Commanded where there is no error; of tracks the duty ahead of both",
                                               "Mando sin error; de las orugas, el avance de ambas"},
                                      .min = -1e6,
                                      .max = 1e6,
                                      .live = true}),
    parameter<Config, &Config::min>({.name = "min",
                                     .title = {"lower limit", "límite inferior"},
                                     .help = {"Least command", "Mando mínimo"},
                                     .min = -1e6,
                                     .max = 1e6}),
    parameter<Config, &Config::max>({.name = "max",
                                     .title = {"upper limit", "límite superior"},
                                     .help = {"Largest command", "Mando máximo"},
                                     .min = -1e6,
                                     .max = 1e6}),
    parameter<Config, &Config::tracking_s>(
        {.name = "tracking_s",
         .title = {"tracking time", "tiempo de seguimiento"},
         .help = {"Time in which the integral gives up what the limits cut off; 0 = at once",
                  "Tiempo en que la integral cede lo que cortan los límites; 0 = de inmediato"},
         .unit = "s",
         .min = 0,
         .max = 1e6,
         .live = true}),
    parameter<Config, &Config::circular>({.name = "circular",
                                          .title = {"angle", "ángulo"},
                                          .help = {"Whether the value is an angle, whose errors go round the turn",
                                                   "Si el valor es un ángulo, cuyos errores dan la vuelta"},
                                          .ours = true}),
};

}  // namespace

Result<Ports> PidRegulator::shape(const Parameters& parameters) {
  const Config config = parameters.filled<Config>();
  Ports ports;
  for (PortDescriptor port : kPorts) {
    if (port.name == kValuePort.name && config.circular) port.type = ValueType::Circular;
    if (port.role == PortRole::Command && config.drives == Config::Drives::Tracks) {
      port.size = 2;
      port.elements = kSides;
    }
    ports.add(port);
  }
  return ports;
}

extern constinit const ActingModuleKind pid_regulator_kind{
    .descriptor =
        {.component_class = ComponentClass::Acting,
         .name = "PidRegulator",
         .summary = {"Holds a value at a set-point by its error, the error's sum and the value's rate",
                     "Mantiene un valor en una consigna por su error, la suma del error y la velocidad del valor"},
         .ports = kPorts,
         .parameters = kParameters,
         .source = "Astrom and Hagglund, Advanced PID Control (2006), sections 3.4 and 3.5; standing requests ours"},
    .make = make_bound<ActingModule, PidRegulator, Config>,
    .shape = PidRegulator::shape};

}  // namespace ganglion
