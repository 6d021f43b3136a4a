#pragma once

#include "ganglion/descriptor/descriptor.h"

namespace ganglion::sim {

/// The parameter of compasses that show bearings from magnetic north: where that lies in the world.
inline constexpr ParameterDescriptor kMagneticNorth{
    .name = "north_deg",
    .unit = "deg",
    .preset = 90,
    .min = -360,
    .max = 360,
    .help = {"Direction of magnetic north in the world, counter-clockwise from x",
             "Dirección del norte magnético en el mundo, antihorario desde x"},
    .ours = true};

}  // namespace ganglion::sim
