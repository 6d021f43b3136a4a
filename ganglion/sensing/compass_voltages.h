#pragma once

#include "ganglion/descriptor/descriptor.h"

namespace ganglion {

/// What every decoder of a two-voltage compass hears, in this order.
inline constexpr PortDescriptor kCosineVoltage{.name = "va",
                                               .title = {"cosine voltage", "voltaje del coseno"},
                                               .help = {"Cosine voltage", "Voltaje del coseno"},
                                               .unit = "V"};
inline constexpr PortDescriptor kSineVoltage{.name = "vb",
                                             .title = {"sine voltage", "voltaje del seno"},
                                             .help = {"Sine voltage", "Voltaje del seno"},
                                             .unit = "V"};

}  // namespace ganglion
