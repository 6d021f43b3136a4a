#pragma once

#include "ganglion/config/named_tables.h"
#include "ganglion/sim/robot/robot_model.h"

namespace ganglion::sim {

/// The form of a file that only describes: [[sensation]] and [[command]].
void read_described(config::Table& root, Description& description);

}  // namespace ganglion::sim
