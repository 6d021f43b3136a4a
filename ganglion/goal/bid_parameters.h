#pragma once

#include "ganglion/descriptor/descriptor.h"

namespace ganglion {

/// Bid::intensity of a goal that always bids alike; its Config has a member `double intensity`.
template <class Config>
consteval ParameterDescriptor intensity_parameter() {
  return parameter<Config, &Config::intensity>(
      {.name = "intensity",
       .title = {"intensity", "intensidad"},
       .help = {"Within a class the strongest wins", "Dentro de una clase gana la más intensa"},
       .min = 0,
       .max = 1,
       .ours = true,
       .live = true});
}

}  // namespace ganglion
