#include "ganglion/sim/drive/differential/differential.h"

#include <array>

namespace ganglion::sim {
namespace {

constexpr std::array<ElementDescriptor, 2> kSides = {"left", "right"};
constexpr std::array kPorts = {
    PortDescriptor{.name = "drive",
                   .role = PortRole::Command,
                   .size = 2,
                   .elements = kSides,
                   .help = {"Duties of the wheels in [-1, 1]", "Ciclos de trabajo de las ruedas en [-1, 1]"}},
};
constexpr std::array kParameters = {kFullScaleParameter, kTrackParameter,     kDeadZoneParameter,
                                    kLeftGainParameter,  kRightGainParameter, kMotorLagParameter};

Result<std::unique_ptr<Drive>> make(const Parameters& parameters) {
  return std::make_unique<Differential>(wheel_pair_config(parameters));
}

}  // namespace

extern constinit const DriveKind differential_kind{
    .descriptor = {.component_class = ComponentClass::Drive,
                   .name = "Differential",
                   .summary = {"Two driven wheels on one axle", "Dos ruedas motrices en un eje"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "kinematics of the differential drive; lag and dead zone ours"},
    .make = make};

}  // namespace ganglion::sim
