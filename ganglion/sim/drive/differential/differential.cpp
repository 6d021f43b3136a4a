#include "ganglion/sim/drive/differential/differential.h"

#include <array>

namespace ganglion::sim {
namespace {

constexpr std::array<ElementDescriptor, 2> kSides = {"left", "right"};
constexpr std::array kPorts = {
    PortDescriptor{.name = "drive",
                   .title = {"drive", "tracción"},
                   .help = {"Duties of the wheels in [-1, 1]", "Ciclos de trabajo de las ruedas en [-1, 1]"},
                   .role = PortRole::Command,
                   .size = 2,
                   .elements = kSides},
};
constexpr std::array kParameters = {full_scale_parameter<WheelPairConfig>(), track_parameter<WheelPairConfig>(),
                                    dead_zone_parameter<WheelPairConfig>(),  left_gain_parameter<WheelPairConfig>(),
                                    right_gain_parameter<WheelPairConfig>(), motor_lag_parameter<WheelPairConfig>()};

}  // namespace

extern constinit const DriveKind differential_kind{
    .descriptor = {.component_class = ComponentClass::Drive,
                   .name = "Differential",
                   .summary = {"Two driven wheels on one axle", "Dos ruedas motrices en un eje"},
                   .ports = kPorts,
                   .parameters = kParameters,
                   .source = "kinematics of the differential drive; lag and dead zone ours"},
    .make = make_bound<Drive, Differential, WheelPairConfig>};

}  // namespace ganglion::sim
