#include "ganglion/sim/sensor/battery/battery.h"

#include <array>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "voltage",
                   .title = {"voltage", "tensión"},
                   .help = {"At the terminals, under load", "En los bornes, con carga"},
                   .role = PortRole::Output,
                   .unit = "V"},
    PortDescriptor{.name = "charge",
                   .title = {"charge", "carga"},
                   .help = {"Share of the capacity that is left", "Parte de la capacidad que queda"},
                   .role = PortRole::Output},
    PortDescriptor{.name = "current",
                   .title = {"current", "corriente"},
                   .help = {"Mean since the last firing", "Media desde el último disparo"},
                   .role = PortRole::Output,
                   .unit = "A"},
};

constexpr std::array kParameters = {
    parameter<BatteryConfig, &BatteryConfig::noise_V>(
        {.name = "noise_V",
         .title = {"noise", "ruido"},
         .help = {"Standard deviation of one reading", "Desviación típica de una lectura"},
         .unit = "V",
         .min = 0,
         .max = 100,
         .ours = true,
         .live = true}),
    parameter<BatteryConfig, &BatteryConfig::divider>(
        {.name = "divider",
         .title = {"divider error", "error del divisor"},
         .help = {"Read over true voltage: resistors off their value",
                  "Tensión leída entre la real: resistencias fuera de su valor"},
         .min = 0.5,
         .max = 1.5,
         .ours = true,
         .live = true}),
    parameter<BatteryConfig, &BatteryConfig::bits>(
        {.name = "bits",
         .title = {"converter bits", "bits del conversor"},
         .help = {"Of the converter; 0 = not rounded", "Del conversor; 0 = sin redondeo"},
         .min = 0,
         .max = 24,
         .ours = true}),
    parameter<BatteryConfig, &BatteryConfig::reference_V>(
        {.name = "reference_V",
         .title = {"full scale", "fondo de escala"},
         .help = {"Full scale of the converter", "Fondo de escala del conversor"},
         .unit = "V",
         .min = 1e-3,
         .max = 1000,
         .ours = true}),
};

}  // namespace

Limits Battery::limits(std::size_t channel) const noexcept {
  if (channel == 0) return {0, config_.reference_V};
  return channel == 1 ? Limits{0, 1} : Limits{0, 1e6};
}

Result<void> Battery::reset(const Scene& scene, Draws) {
  fired_s_ = scene.time_s;
  taken_J_ = scene.robot.energy_J;
  return {};
}

void Battery::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  const double noise_V = draws.normal() * config_.noise_V;
  if (!(scene.robot.battery_V >= 0)) {  // there is none
    std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
    return;
  }
  const double counts = config_.bits > 0 ? static_cast<double>(1 << config_.bits) : 0;
  const double shown_V = scene.robot.battery_V * config_.divider + noise_V;
  values[0] = std::clamp(shown_V, 0.0, config_.reference_V);
  if (counts > 0) {
    values[0] =
        std::min(std::floor(values[0] / config_.reference_V * counts), counts - 1) * config_.reference_V / counts;
  }
  values[1] = scene.robot.charge;
  const double step_s = scene.time_s - fired_s_;
  const double power_W = step_s > 0 ? (scene.robot.energy_J - taken_J_) / step_s : 0;
  values[2] = scene.robot.battery_V > 0 ? std::clamp(power_W / scene.robot.battery_V, 0.0, limits(2).max) : 0;
  fired_s_ = scene.time_s;
  taken_J_ = scene.robot.energy_J;
}

extern constinit const SensorKind battery_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "Battery",
                   .summary = {"Voltage, charge and current of the robot's battery",
                               "Tensión, carga y corriente de la batería del robot"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "ours"},
    .make = make_bound<Sensor, Battery, BatteryConfig>};

}  // namespace ganglion::sim
