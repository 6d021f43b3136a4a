#pragma once

#include "ganglion/graph/model.h"

namespace ganglion {

/// Whether a component's result is a command: acting modules and coordinators.
bool makes_commands(const ComponentModel& component) noexcept;

/// Adds a BadWire problem that opens with the component's id.
void report_wire(Problems& problems, const ComponentModel& component, const Place& place, const Sentence& what,
                 Subject subject = {});

/// Finds the robot's command that each component drives, and holds their elements against each other.
void bind_commands(ControllerModel& model, const Description& robot, Problems& problems);

/// Of wires that are understood: each command goes to one place, and each command of the robot has one writer.
void check_commands(const ControllerModel& model, const Description& robot, Problems& problems);

}  // namespace ganglion
