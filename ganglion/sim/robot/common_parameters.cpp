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

constexpr ParameterDescriptor of_battery(std::string_view name, std::string_view unit, double preset, double min,
                                         double max, Text help) {
  return {.name = name, .unit = unit, .preset = preset, .min = min, .max = max, .help = help, .ours = true};
}

constexpr std::array kBatteryParameters = {
    of_battery("capacity_J", "J", 50000, 1e-3, 1e12, {"Energy of a full charge", "Energía de una carga completa"}),
    of_battery("full_V", "V", 8.4, 0.1, 1000,
               {"Open voltage at full charge, which the drive's full speed is stated for",
                "Tensión en vacío a plena carga, a la que corresponde la velocidad máxima"}),
    of_battery("empty_V", "V", 6, 0.1, 1000,
               {"Open voltage at the end of the charge", "Tensión en vacío al acabarse la carga"}),
    of_battery("resistance_ohm", "ohm", 0.1, 0, 1000,
               {"Inner resistance: the voltage sags under load", "Resistencia interna: la tensión cae con la carga"}),
    of_battery("charge", "", 1, 0, 1, {"Share of the capacity at the start", "Parte de la capacidad al comienzo"}),
};

}  // namespace

std::span<const ParameterDescriptor> sensor_parameters() noexcept { return kSensorParameters; }
std::span<const ParameterDescriptor> energy_parameters() noexcept { return kEnergyParameters; }
std::span<const ParameterDescriptor> battery_parameters() noexcept { return kBatteryParameters; }

}  // namespace ganglion::sim
