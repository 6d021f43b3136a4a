#include <array>

#include "ganglion/sim/robot/robot_model.h"

namespace ganglion::sim {
namespace {

constexpr std::array<std::string_view, 3> kFaults = {"none", "dead", "stuck"};

constexpr std::array kSensorParameters = {
    ParameterDescriptor{
        .name = "x_m",
        .unit = "m",
        .min = -100,
        .max = 100,
        .help = {"Where it sits, forwards of the body's centre", "Dónde está, hacia adelante del centro"}},
    ParameterDescriptor{
        .name = "y_m",
        .unit = "m",
        .min = -100,
        .max = 100,
        .help = {"Where it sits, to the left of the body's centre", "Dónde está, a la izquierda del centro"}},
    ParameterDescriptor{.name = "yaw_deg",
                        .unit = "deg",
                        .min = -360,
                        .max = 360,
                        .help = {"Where it looks, counter-clockwise from ahead",
                                 "Hacia dónde mira, en sentido antihorario desde el frente"}},
    ParameterDescriptor{
        .name = "period_s",
        .unit = "s",
        .min = 0,
        .max = 3600,
        .help = {"Time between firings; 0 = one for every frame", "Tiempo entre disparos; 0 = uno en cada trama"}},
    ParameterDescriptor{.name = "phase_s",
                        .unit = "s",
                        .min = 0,
                        .max = 3600,
                        .help = {"Time of its first firing, for sensors that fire in turn",
                                 "Momento del primer disparo, para sensores que se turnan"}},
    ParameterDescriptor{.name = "fault",
                        .type = ParameterType::Choice,
                        .choices = kFaults,
                        .help = {"dead: no valid reading any more; stuck: repeats its last one",
                                 "dead: ya no da lecturas válidas; stuck: repite la última"}},
    ParameterDescriptor{.name = "fault_from_s",
                        .unit = "s",
                        .min = 0,
                        .max = 1e9,
                        .help = {"When the fault begins", "Cuándo empieza la avería"}},
};

constexpr std::array kEnergyParameters = {
    ParameterDescriptor{.name = "idle_W",
                        .unit = "W",
                        .preset = 0,
                        .min = 0,
                        .max = 1e6,
                        .help = {"Power taken at rest", "Potencia consumida en reposo"},
                        .ours = true},
    ParameterDescriptor{.name = "drive_W",
                        .unit = "W",
                        .preset = 1,
                        .min = 0,
                        .max = 1e6,
                        .help = {"Power of the drive at full command, whether it moves or stalls",
                                 "Potencia de la tracción a pleno mando, se mueva o no"},
                        .ours = true},
    ParameterDescriptor{.name = "travel_J_per_m",
                        .unit = "J/m",
                        .preset = 0,
                        .min = 0,
                        .max = 1e6,
                        .help = {"Energy of each metre travelled", "Energía de cada metro recorrido"},
                        .ours = true},
    ParameterDescriptor{.name = "contact_J",
                        .unit = "J",
                        .preset = 0,
                        .min = 0,
                        .max = 1e6,
                        .help = {"Added for each contact begun, so that contacts are avoided",
                                 "Se suma en cada contacto que empieza, para que se eviten"},
                        .ours = true},
};

}  // namespace

std::span<const ParameterDescriptor> sensor_parameters() noexcept { return kSensorParameters; }
std::span<const ParameterDescriptor> energy_parameters() noexcept { return kEnergyParameters; }

}  // namespace ganglion::sim
