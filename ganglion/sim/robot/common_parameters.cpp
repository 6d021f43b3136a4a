#include <array>

#include "ganglion/sim/robot/robot_model.h"

namespace ganglion::sim {
namespace {

constexpr std::array<std::string_view, 3> kFaults = {"none", "dead", "stuck"};

constexpr std::array kSensorParameters = {
    parameter<SensorCommon, &SensorCommon::x_m>(
        {.name = "x_m",
         .title = {"x position", "posición x"},
         .help = {"Where it sits, forwards of the body's centre", "Dónde está, hacia adelante del centro"},
         .unit = "m",
         .min = -100,
         .max = 100}),
    parameter<SensorCommon, &SensorCommon::y_m>(
        {.name = "y_m",
         .title = {"y position", "posición y"},
         .help = {"Where it sits, to the left of the body's centre", "Dónde está, a la izquierda del centro"},
         .unit = "m",
         .min = -100,
         .max = 100}),
    parameter<SensorCommon, &SensorCommon::yaw>({.name = "yaw_deg",
                                                 .title = {"direction", "orientación"},
                                                 .help = {"Where it looks, counter-clockwise from ahead",
                                                          "Hacia dónde mira, en sentido antihorario desde el frente"},
                                                 .unit = "deg",
                                                 .min = -360,
                                                 .max = 360}),
    parameter<SensorCommon, &SensorCommon::period_s>(
        {.name = "period_s",
         .title = {"period", "período"},
         .help = {"Time between firings; 0 = one for every frame", "Tiempo entre disparos; 0 = uno en cada trama"},
         .unit = "s",
         .min = 0,
         .max = 3600}),
    parameter<SensorCommon, &SensorCommon::phase_s>(
        {.name = "phase_s",
         .title = {"phase", "fase"},
         .help = {"Time of its first firing, for sensors that fire in turn",
                  "Momento del primer disparo, para sensores que se turnan"},
         .unit = "s",
         .min = 0,
         .max = 3600}),
    parameter<SensorCommon, &SensorCommon::fault>(
        {.name = "fault",
         .title = {"fault", "avería"},
         .help = {"dead: no valid reading any more; stuck: repeats its last one",
                  "dead: ya no da lecturas válidas; stuck: repite la última"},
         .choices = kFaults}),
    parameter<SensorCommon, &SensorCommon::fault_from_s>({.name = "fault_from_s",
                                                          .title = {"fault from", "avería desde"},
                                                          .help = {"When the fault begins", "Cuándo empieza la avería"},
                                                          .unit = "s",
                                                          .min = 0,
                                                          .max = 1e9}),
};

constexpr std::array kEnergyParameters = {
    parameter<EnergyModel, &EnergyModel::idle_W>({.name = "idle_W",
                                                  .title = {"idle power", "potencia en reposo"},
                                                  .help = {"Power taken at rest", "Potencia consumida en reposo"},
                                                  .unit = "W",
                                                  .min = 0,
                                                  .max = 1e6,
                                                  .ours = true}),
    parameter<EnergyModel, &EnergyModel::drive_W>(
        {.name = "drive_W",
         .title = {"drive power", "potencia de tracción"},
         .help = {"Power of the drive at full command, whether it moves or stalls",
                  "Potencia de la tracción a pleno mando, se mueva o no"},
         .unit = "W",
         .min = 0,
         .max = 1e6,
         .ours = true}),
    parameter<EnergyModel, &EnergyModel::travel_J_per_m>(
        {.name = "travel_J_per_m",
         .title = {"travel energy", "energía por metro"},
         .help = {"Energy of each metre travelled", "Energía de cada metro recorrido"},
         .unit = "J/m",
         .min = 0,
         .max = 1e6,
         .ours = true}),
    parameter<EnergyModel, &EnergyModel::contact_J>(
        {.name = "contact_J",
         .title = {"contact energy", "energía por contacto"},
         .help = {"Added for each contact begun, so that contacts are avoided",
                  "Se suma en cada contacto que empieza, para que se eviten"},
         .unit = "J",
         .min = 0,
         .max = 1e6,
         .ours = true}),
};

constexpr std::array kBatteryParameters = {
    parameter<BatteryModel, &BatteryModel::capacity_J>(
        {.name = "capacity_J",
         .title = {"capacity", "capacidad"},
         .help = {"Energy of a full charge", "Energía de una carga completa"},
         .unit = "J",
         .min = 1e-3,
         .max = 1e12,
         .ours = true}),
    parameter<BatteryModel, &BatteryModel::full_V>(
        {.name = "full_V",
         .title = {"full voltage", "tensión a plena carga"},
         .help = {"Open voltage at full charge, which the drive's full speed is stated for",
                  "Tensión en vacío a plena carga, a la que corresponde la velocidad máxima"},
         .unit = "V",
         .min = 0.1,
         .max = 1000,
         .ours = true}),
    parameter<BatteryModel, &BatteryModel::empty_V>(
        {.name = "empty_V",
         .title = {"empty voltage", "tensión sin carga"},
         .help = {"Open voltage at the end of the charge", "Tensión en vacío al acabarse la carga"},
         .unit = "V",
         .min = 0.1,
         .max = 1000,
         .ours = true}),
    parameter<BatteryModel, &BatteryModel::resistance_ohm>(
        {.name = "resistance_ohm",
         .title = {"inner resistance", "resistencia interna"},
         .help = {"Inner resistance: the voltage sags under load", "Resistencia interna: la tensión cae con la carga"},
         .unit = "ohm",
         .min = 0,
         .max = 1000,
         .ours = true}),
    parameter<BatteryModel, &BatteryModel::charge>(
        {.name = "charge",
         .title = {"charge", "carga"},
         .help = {"Share of the capacity at the start", "Parte de la capacidad al comienzo"},
         .min = 0,
         .max = 1,
         .ours = true}),
};

}  // namespace

std::span<const ParameterDescriptor> sensor_parameters() noexcept { return kSensorParameters; }
std::span<const ParameterDescriptor> energy_parameters() noexcept { return kEnergyParameters; }
std::span<const ParameterDescriptor> battery_parameters() noexcept { return kBatteryParameters; }

}  // namespace ganglion::sim
