#pragma once

#include <vector>

#include "ganglion/graph/model.h"

namespace ganglion {

/// For each component of a resolved model a number that it shares with those it can reach and be reached from along
/// wires of values, @previous ones included. Time is linear in components and wires.
/// Source: Tarjan, "Depth-first search and linear graph algorithms" (1972), without recursion.
std::vector<int> loops_of(const ControllerModel& model);

}  // namespace ganglion
