#pragma once

#include "ganglion/descriptor/descriptor.h"

namespace ganglion::sim {

/// The parameter of compasses that show bearings from magnetic north: where that lies in the world, Config::north.
template <class Config>
consteval ParameterDescriptor magnetic_north_parameter() {
  return parameter<Config, &Config::north>(
      {.name = "north_deg",
       .title = {"magnetic north", "norte magnético"},
       .help = {"Direction of magnetic north in the world, counter-clockwise from x",
                "Dirección del norte magnético en el mundo, antihorario desde x"},
       .unit = "deg",
       .min = -360,
       .max = 360,
       .ours = true});
}

}  // namespace ganglion::sim
