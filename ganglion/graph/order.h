#pragma once

#include <vector>

#include "ganglion/graph/model.h"

namespace ganglion {

/// The order in which components run within a tick: indices into ControllerModel::components.
struct Schedule {
  std::vector<int> sensing;
  std::vector<int> goals;
  std::vector<int> acting;  ///< Acting modules and coordinators, upper and competing ones first: the downward sweep.
  std::vector<int> upward;  ///< Acting modules only, lowest first.
};

/// Orders a resolved model; among equals the file's order counts. Reports cycles of wires within a tick.
Schedule order(const ControllerModel& model, Problems& problems);

}  // namespace ganglion
