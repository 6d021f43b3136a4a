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
                   .role = PortRole::Output,
                   .size = 64,
                   .elements = kPixels,
                   .help = {"Brightness, 0 black to 1, rows from the top, from left to right",
                            "Brillo, 0 negro a 1, filas desde arriba, de izquierda a derecha"}},
};

constexpr std::array<std::string_view, 4> kFilters = {"grey", "red", "green", "blue"};

constexpr ParameterDescriptor real(std::string_view name, std::string_view unit, double preset, double min, double max,
                                   Text help) {
  return {.name = name, .unit = unit, .preset = preset, .min = min, .max = max, .help = help, .ours = true};
}

constexpr std::array kParameters = {
    real("width_deg", "deg", 64, 1, 170, {"Field of view across", "Campo de visión horizontal"}),
    real("height_deg", "deg", 64, 1, 90, {"Field of view up and down", "Campo de visión vertical"}),
    real("down_deg", "deg", 20, -40, 40,
         {"How far the middle of the picture lies below the horizon",
          "Cuánto queda el centro de la imagen bajo el horizonte"}),
    real("height_m", "m", 0.2, 0.001, 100, {"Of the lens above the floor", "De la lente sobre el suelo"}),
    real("reach_m", "m", 10, 0.01, 1000, {"Farther off there is only background", "Más lejos solo hay fondo"}),
    real("wall_height_m", "m", 2, 0, 100, {"How high walls and robots stand", "Altura de paredes y robots"}),
    ParameterDescriptor{.name = "filter",
                        .type = ParameterType::Choice,
                        .choices = kFilters,
                        .help = {"The part of the light it takes", "La parte de la luz que toma"},
                        .ours = true},
    real("noise", "", 0.02, 0, 1, {"Standard deviation of one pixel", "Desviación típica de un píxel"}),
    ParameterDescriptor{
        .name = "levels",
        .type = ParameterType::Integer,
        .preset = 64,
        .min = 0,
        .max = 65536,
        .help = {"Pixels take that many values; 0 = not rounded", "Los píxeles toman tantos valores; 0 = sin redondeo"},
        .ours = true},
};

Result<std::unique_ptr<Sensor>> make(const Parameters& parameters) {
  const auto degrees = [&](std::string_view name) { return Angle::from_deg(parameters.real(name)); };
  return std::make_unique<PixelMatrix>(
      PixelMatrixConfig{.width = degrees("width_deg"),
                        .height = degrees("height_deg"),
                        .down = degrees("down_deg"),
                        .height_m = parameters.real("height_m"),
                        .reach_m = parameters.real("reach_m"),
                        .wall_height_m = parameters.real("wall_height_m"),
                        .filter = static_cast<Filter>(parameters.choice_index("filter")),
                        .noise = parameters.real("noise"),
                        .levels = parameters.integer("levels")});
}

}  // namespace

extern constinit const SensorKind pixel_matrix_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "PixelMatrix",
                   .summary = {"Coarse camera of 8 x 8 pixels: floor colours, walls, beacons",
                               "Cámara de 8 x 8 píxeles: colores del suelo, paredes, balizas"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "the 8 x 8 pixel matrix of the GFM papers' feedback; optics ours"},
    .make = make};

}  // namespace ganglion::sim
