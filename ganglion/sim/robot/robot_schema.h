#pragma once

#include <list>
#include <string>

#include "ganglion/sim/robot/robot_model.h"

namespace ganglion::sim {

/// What the reader of robot.toml asks, form by form: simulated with each of the kinds, or only described.
std::list<config::Outline> robot_outlines(const SimKinds& kinds);

/// JSON Schema (2020-12) of robot.toml with these kinds, for editors that complete and check while one types. It knows
/// keys, types, ranges and choices; whether they agree with each other is for load_robot().
std::string robot_schema(const SimKinds& kinds);

}  // namespace ganglion::sim
