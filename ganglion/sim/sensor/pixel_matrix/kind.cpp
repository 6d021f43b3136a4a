#include "ganglion/sim/sensor/pixel_matrix/pixel_matrix.h"

namespace ganglion::sim {
namespace {

// Row from the top and column from the left.
constexpr std::array<ElementDescriptor, 64> kPixels = {
    "r0c0", "r0c1", "r0c2", "r0c3", "r0c4", "r0c5", "r0c6", "r0c7", "r1c0", "r1c1", "r1c2", "r1c3", "r1c4",
    "r1c5", "r1c6", "r1c7", "r2c0", "r2c1", "r2c2", "r2c3", "r2c4", "r2c5", "r2c6", "r2c7", "r3c0", "r3c1",
    "r3c2", "r3c3", "r3c4", "r3c5", "r3c6", "r3c7", "r4c0", "r4c1", "r4c2", "r4c3", "r4c4", "r4c5", "r4c6",
    "r4c7", "r5c0", "r5c1", "r5c2", "r5c3", "r5c4", "r5c5", "r5c6", "r5c7", "r6c0", "r6c1", "r6c2", "r6c3",
    "r6c4", "r6c5", "r6c6", "r6c7", "r7c0", "r7c1", "r7c2", "r7c3", "r7c4", "r7c5", "r7c6", "r7c7"};

constexpr std::array kPorts = {
    PortDescriptor{.name = "pixels",
                   .title = {"pixels", "píxeles"},
                   .help = {"Brightness, 0 black to 1, rows from the top, from left to right",
                            "Brillo, 0 negro a 1, filas desde arriba, de izquierda a derecha"},
                   .role = PortRole::Output,
                   .size = 64,
                   .elements = kPixels},
};

constexpr std::array<std::string_view, 4> kFilters = {"grey", "red", "green", "blue"};

using Config = PixelMatrixConfig;

constexpr std::array kParameters = {
    parameter<Config, &Config::width>({.name = "width_deg",
                                       .title = {"horizontal field", "campo horizontal"},
                                       .help = {"Field of view across", "Campo de visión horizontal"},
                                       .unit = "deg",
                                       .min = 1,
                                       .max = 170,
                                       .ours = true}),
    parameter<Config, &Config::height>({.name = "height_deg",
                                        .title = {"vertical field", "campo vertical"},
                                        .help = {"Field of view up and down", "Campo de visión vertical"},
                                        .unit = "deg",
                                        .min = 1,
                                        .max = 90,
                                        .ours = true}),
    parameter<Config, &Config::down>({.name = "down_deg",
                                      .title = {"depression angle", "ángulo de depresión"},
                                      .help = {"How far the middle of the picture lies below the horizon",
                                               "Cuánto queda el centro de la imagen bajo el horizonte"},
                                      .unit = "deg",
                                      .min = -40,
                                      .max = 40,
                                      .ours = true}),
    parameter<Config, &Config::height_m>({.name = "height_m",
                                          .title = {"lens height", "altura de la lente"},
                                          .help = {"Of the lens above the floor", "De la lente sobre el suelo"},
                                          .unit = "m",
                                          .min = 0.001,
                                          .max = 100,
                                          .ours = true}),
    parameter<Config, &Config::reach_m>({.name = "reach_m",
                                         .title = {"reach", "alcance"},
                                         .help = {"Farther off there is only background", "Más lejos solo hay fondo"},
                                         .unit = "m",
                                         .min = 0.01,
                                         .max = 1000,
                                         .ours = true}),
    parameter<Config, &Config::wall_height_m>(
        {.name = "wall_height_m",
         .title = {"wall height", "altura de paredes"},
         .help = {"How high walls and robots stand", "Altura de paredes y robots"},
         .unit = "m",
         .min = 0,
         .max = 100,
         .ours = true}),
    parameter<Config, &Config::filter>({.name = "filter",
                                        .title = {"filter", "filtro"},
                                        .help = {"The part of the light it takes", "La parte de la luz que toma"},
                                        .choices = kFilters,
                                        .ours = true}),
    parameter<Config, &Config::noise>({.name = "noise",
                                       .title = {"noise", "ruido"},
                                       .help = {"Standard deviation of one pixel", "Desviación típica de un píxel"},
                                       .min = 0,
                                       .max = 1,
                                       .ours = true,
                                       .live = true}),
    parameter<Config, &Config::levels>({.name = "levels",
                                        .title = {"levels", "niveles"},
                                        .help = {"Pixels take that many values; 0 = not rounded",
                                                 "Los píxeles toman tantos valores; 0 = sin redondeo"},
                                        .min = 0,
                                        .max = 65536,
                                        .ours = true}),
};

}  // namespace

extern constinit const SensorKind pixel_matrix_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "PixelMatrix",
                   .summary = {"Coarse camera of 8 x 8 pixels: floor colours, walls, beacons",
                               "Cámara de 8 x 8 píxeles: colores del suelo, paredes, balizas"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "the 8 x 8 pixel matrix of the GFM papers' feedback; optics ours"},
    .make = make_bound<Sensor, PixelMatrix, PixelMatrixConfig>};

}  // namespace ganglion::sim
