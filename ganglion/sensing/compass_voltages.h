#pragma once

#include "ganglion/descriptor/descriptor.h"

namespace ganglion {

/// What every decoder of a two-voltage compass hears, in this order.
inline constexpr PortDescriptor kCosineVoltage{
    .name = "va", .unit = "V", .help = {"Cosine voltage", "Voltaje del coseno"}};
inline constexpr PortDescriptor kSineVoltage{.name = "vb", .unit = "V", .help = {"Sine voltage", "Voltaje del seno"}};

}  // namespace ganglion
