#include <array>

#include "ganglion/plant/process/process.h"

namespace ganglion {
namespace {

constexpr std::array<ElementDescriptor, 1> kCommand = {"command"};
constexpr std::array kPorts = {
    PortDescriptor{
        .name = "value",
        .title = {"value", "valor"},
        .help = {"The value that is controlled, as it is measured", "El valor que se controla, tal como se mide"},
        .role = PortRole::Output},
    PortDescriptor{.name = "command",
                   .title = {"command", "mando"},
                   .help = {"What drives the process", "Lo que impulsa el proceso"},
                   .role = PortRole::Command,
                   .elements = kCommand},
};
using C = ProcessConfig;
constexpr std::array kParameters = {
    parameter<C, &C::gain>(
        {.name = "gain",
         .title = {"gain", "ganancia"},
         .help = {"Value that a lasting command of 1 leads to", "Valor al que lleva un mando constante de 1"},
         .min = -1e6,
         .max = 1e6}),
    parameter<C, &C::lag_s>({.name = "lag_s",
                             .title = {"lag", "retardo"},
                             .help = {"Time constant of the first lag", "Constante de tiempo del primer retardo"},
                             .unit = "s",
                             .min = 1e-3,
                             .max = 1e5}),
    parameter<C, &C::second_lag_s>({.name = "second_lag_s",
                                    .title = {"second lag", "segundo retardo"},
                                    .help = {"Time constant of the second lag; 0 = there is none",
                                             "Constante de tiempo del segundo retardo; 0 = no hay"},
                                    .unit = "s",
                                    .min = 0,
                                    .max = 1e5}),
    parameter<C, &C::dead_time_s>({.name = "dead_time_s",
                                   .title = {"dead time", "tiempo muerto"},
                                   .help = {"Time until a command acts", "Tiempo hasta que actúa un mando"},
                                   .unit = "s",
                                   .min = 0,
                                   .max = 60}),
    parameter<C, &C::start>(
        {.name = "start",
         .title = {"start", "inicio"},
         .help = {"The value as a trial begins, at rest", "El valor al empezar una prueba, en reposo"},
         .min = -1e6,
         .max = 1e6}),
    parameter<C, &C::min>({.name = "min",
                           .title = {"least command", "mando mínimo"},
                           .help = {"What is commanded lies above it", "Lo que se manda está por encima"},
                           .min = -1e6,
                           .max = 1e6}),
    parameter<C, &C::max>({.name = "max",
                           .title = {"greatest command", "mando máximo"},
                           .help = {"What is commanded lies below it", "Lo que se manda está por debajo"},
                           .min = -1e6,
                           .max = 1e6}),
    parameter<C, &C::noise>({.name = "noise",
                             .title = {"noise", "ruido"},
                             .help = {"Standard deviation of the measured value", "Desviación típica del valor medido"},
                             .min = 0,
                             .max = 1e6}),
    parameter<C, &C::trip>({.name = "trip",
                            .title = {"trip", "disparo"},
                            .help = {"The process fails, and begins anew, where its value is farther from 0; 0 = never",
                                     "El proceso falla, y vuelve a empezar, si su valor se aleja más de 0; 0 = nunca"},
                            .min = 0,
                            .max = 1e9,
                            .ours = true}),
    parameter<C, &C::loads>({.name = "loads",
                             .title = {"loads", "cargas"},
                             .help = {"Added to the command where it acts, each from its time on",
                                      "Se suman al mando donde actúa, cada una desde su tiempo"},
                             .min = -1e6,
                             .max = 1e6}),
    parameter<C, &C::load_s>({.name = "load_s",
                              .title = {"times of loads", "tiempos de las cargas"},
                              .help = {"When each load begins, from the start of a trial",
                                       "Cuándo empieza cada carga, desde el inicio de una prueba"},
                              .unit = "s",
                              .min = 0,
                              .max = 1e6}),
};

}  // namespace

extern constinit const PlantKind process_kind{
    .descriptor = {.component_class = ComponentClass::Plant,
                   .name = "Process",
                   .summary = {"A process of first or second order with dead time and loads",
                               "Un proceso de primer o segundo orden con tiempo muerto y cargas"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "the standard model of process control; trip ours"},
    .make = make_bound<Plant, Process, ProcessConfig>};

}  // namespace ganglion
