#include "ganglion/sim/sensor/bumper/bumper.h"

#include <array>

namespace ganglion::sim {
namespace {

constexpr std::array kPorts = {
    PortDescriptor{.name = "contact",
                   .title = {"contact", "contacto"},
                   .help = {"1 if the robot touched anything since the last firing",
                            "1 si el robot tocó algo desde el último disparo"},
                   .role = PortRole::Output,
                   .type = ValueType::Discrete},
};

Result<std::unique_ptr<Sensor>> make(const Parameters&) { return std::make_unique<Bumper>(); }

}  // namespace

Result<void> Bumper::reset(const Scene&, Draws) {
  touched_ = false;
  return {};
}

void Bumper::follow(const Scene& scene, double) noexcept { touched_ = touched_ || scene.robot.touching; }

void Bumper::measure(const Scene&, Draws&, std::span<double> values) noexcept {
  values[0] = touched_ ? 1 : 0;
  touched_ = false;
}

extern constinit const SensorKind bumper_kind{
    .descriptor = {.component_class = ComponentClass::Sensor,
                   .name = "Bumper",
                   .summary = {"Contact ring round the body", "Anillo de contacto alrededor del cuerpo"},
                   .ports = kPorts,
                   .source = "ours"},
    .make = make};

}  // namespace ganglion::sim
