#pragma once

#include <span>

#include "ganglion/application/witness.h"
#include "ganglion/sim/robot/truth.h"

namespace ganglion::sim {

/// What is told of every simulated robot's Truth: pose and energy are in the digest.
std::span<const TruthChannel> truth_channels() noexcept;
/// One value for each of them.
void write_truth(const Truth& truth, std::span<double> row) noexcept;

}  // namespace ganglion::sim
