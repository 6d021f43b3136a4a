#include "ganglion/sim/drive/tracked/tracked.h"

#include <array>

namespace ganglion::sim {
namespace {

constexpr std::array<ElementDescriptor, 2> kSides = {"left", "right"};
constexpr std::array kPorts = {
    PortDescriptor{.name = "drive",
                   .role = PortRole::Command,
                   .size = 2,
                   .elements = kSides,
                   .help = {"Duties of the tracks in [-1, 1]", "Ciclos de trabajo de las orugas en [-1, 1]"}},
};
constexpr std::array kParameters = {
    kFullScaleParameter,
    kTrackParameter,
    kDeadZoneParameter,
    kLeftGainParameter,
    kRightGainParameter,
    kMotorLagParameter,
    ParameterDescriptor{.name = "skid_factor",
                        .preset = 1,
                        .min = 1,
                        .max = 10,
                        .help = {"Effective track width in turns over the true one; 1 = no skidding",
                                 "Ancho de vía efectivo al girar entre el real; 1 = sin derrape"},
                        .ours = true},
};

Result<std::unique_ptr<Drive>> make(const Parameters& parameters) {
  return std::make_unique<Tracked>(wheel_pair_config(parameters), parameters.real("skid_factor"));
}

}  // namespace

extern constinit const DriveKind tracked_kind{
    .descriptor = {.component_class = ComponentClass::Drive,
                   .name = "Tracked",
                   .summary = {"Two tracks, which skid in turns", "Dos orugas, que derrapan al girar"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "kinematics of the differential drive with an effective track width; defaults ours"},
    .make = make};

}  // namespace ganglion::sim
