#include "ganglion/sim/drive/tracked/tracked.h"

#include <array>

namespace ganglion::sim {
namespace {

constexpr std::array<ElementDescriptor, 2> kSides = {"left", "right"};
constexpr std::array kPorts = {
    PortDescriptor{.name = "drive",
                   .title = {"drive", "tracción"},
                   .help = {"Duties of the tracks in [-1, 1]", "Ciclos de trabajo de las orugas en [-1, 1]"},
                   .role = PortRole::Command,
                   .size = 2,
                   .elements = kSides},
};
constexpr std::array kParameters = {
    full_scale_parameter<TrackedConfig>(),
    track_parameter<TrackedConfig>(),
    dead_zone_parameter<TrackedConfig>(),
    left_gain_parameter<TrackedConfig>(),
    right_gain_parameter<TrackedConfig>(),
    motor_lag_parameter<TrackedConfig>(),
    parameter<TrackedConfig, &TrackedConfig::skid_factor>(
        {.name = "skid_factor",
         .title = {"skid factor", "factor de derrape"},
         .help = {"Effective track width in turns over the true one; 1 = no skidding",
                  "Ancho de vía efectivo al girar entre el real; 1 = sin derrape"},
         .min = 1,
         .max = 10,
         .ours = true}),
};

}  // namespace

extern constinit const DriveKind tracked_kind{
    .descriptor = {.component_class = ComponentClass::Drive,
                   .name = "Tracked",
                   .summary = {"Two tracks, which skid in turns", "Dos orugas, que derrapan al girar"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "kinematics of the differential drive with an effective track width; defaults ours"},
    .make = make_bound<Drive, Tracked, TrackedConfig>};

}  // namespace ganglion::sim
