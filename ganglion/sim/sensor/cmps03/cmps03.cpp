#include "ganglion/sim/sensor/cmps03/cmps03.h"

#include <array>
#include <cmath>

#include "ganglion/math/functions.h"
#include "ganglion/sim/sensor/magnetic_north.h"

namespace ganglion::sim {
namespace {

constexpr double kSteps = 3600;  // of a full turn

constexpr std::array kPorts = {
    PortDescriptor{.name = "heading",
                   .title = {"heading", "rumbo"},
                   .help = {"Yaw in the world, counter-clockwise from x", "Rumbo en el mundo, antihorario desde x"},
                   .role = PortRole::Output,
                   .unit = "rad",
                   .type = ValueType::Circular},
    PortDescriptor{.name = "bearing",
                   .title = {"compass bearing", "rumbo de brújula"},
                   .help = {"Tenths of a degree clockwise from north, 0 to 3599",
                            "Décimas de grado en sentido horario desde el norte, 0 a 3599"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
};

constexpr std::array kParameters = {
    parameter<Cmps03Config, &Cmps03Config::accuracy>({.name = "accuracy_deg",
                                                      .title = {"accuracy", "exactitud"},
                                                      .help = {"Largest bias of a place", "Mayor sesgo de un lugar"},
                                                      .unit = "deg",
                                                      .min = 0,
                                                      .max = 180}),
    parameter<Cmps03Config, &Cmps03Config::local_length_m>(
        {.name = "local_length_m",
         .title = {"bias period", "período del sesgo"},
         .help = {"Way over which the bias goes through one period", "Distancia en que el sesgo recorre un período"},
         .unit = "m",
         .min = 0.01,
         .max = 10000,
         .ours = true}),
    parameter<Cmps03Config, &Cmps03Config::noise>(
        {.name = "noise_deg",
         .title = {"noise", "ruido"},
         .help = {"Standard deviation of one reading", "Desviación típica de una lectura"},
         .unit = "deg",
         .min = 0,
         .max = 180,
         .ours = true,
         .live = true}),
    magnetic_north_parameter<Cmps03Config>(),
};

}  // namespace

Result<void> Cmps03::reset(const Scene&, Draws draws) {
  phase_x_rad_ = draws.uniform(0, 2 * kPi);
  phase_y_rad_ = draws.uniform(0, 2 * kPi);
  return {};
}

double Cmps03::bias_rad(Vector2 place) const noexcept {
  const double wave_radpm = 2 * kPi / config_.local_length_m;
  return config_.accuracy.rad() / 2 *
         (math::sin(wave_radpm * place.x + phase_x_rad_) + math::sin(wave_radpm * place.y + phase_y_rad_));
}

void Cmps03::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  const double yaw_rad =
      scene.mount().yaw.rad() + bias_rad(scene.mount().position) + draws.normal() * config_.noise.rad();
  const double turns = wrap_rad(config_.north.rad() - yaw_rad) / (2 * kPi);
  double steps = std::floor(turns * kSteps + 0.5);
  if (steps < 0) steps += kSteps;
  if (steps >= kSteps) steps -= kSteps;
  values[0] = wrap_rad(config_.north.rad() - steps / kSteps * 2 * kPi);
  values[1] = steps;
}

extern constinit const SensorKind cmps03_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "Cmps03",
                   .summary = {"Digital compass with a bias that varies with the place, Devantech CMPS03",
                               "Brújula digital con un sesgo que varía con el lugar, Devantech CMPS03"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "Devantech CMPS03 documentation; form of the bias ours"},
    .make = make_bound<Sensor, Cmps03, Cmps03Config>};

}  // namespace ganglion::sim
