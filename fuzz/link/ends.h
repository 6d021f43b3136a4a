#pragma once

#include "fuzz/link/script.h"

namespace ganglion::fuzz {

/// Lets a robot's end hear a script; whatever is said, its robot keeps the rules of time (WatchedRobot).
void talk_to_robot(const Script& script, const Dialect& dialect);

/// Lets a controller hear a script; whatever is said, no call lasts longer than its patience, no tick is sensed twice,
/// and it says to the robot only what it was told to.
void talk_to_controller(const Script& script, const Dialect& dialect);

}  // namespace ganglion::fuzz
