#pragma once

#include "ganglion/descriptor/descriptor.h"

namespace ganglion {

/// The parameters of a goal that always bids alike: Bid::priority_class and Bid::intensity.
inline constexpr ParameterDescriptor kPriorityClass{
    .name = "priority_class",
    .type = ParameterType::Integer,
    .min = 0,
    .max = 100,
    .help = {"A higher class may pre-empt a lower one", "Una clase mayor puede desplazar a una menor"},
    .ours = true};
inline constexpr ParameterDescriptor kIntensity{
    .name = "intensity",
    .preset = 1,
    .min = 0,
    .max = 1,
    .help = {"Within a class the strongest wins", "Dentro de una clase gana la más intensa"},
    .ours = true};

}  // namespace ganglion
