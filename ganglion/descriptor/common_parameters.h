#pragma once

#include <span>
#include <vector>

#include "ganglion/descriptor/descriptor.h"

namespace ganglion {

/// What every acting module takes besides its kind's own parameters.
struct ActingCommon {
  std::vector<double>
      tolerance;  ///< One number, or one for each value of the first Feedback port; empty = by its unit.
  bool preemption = true;
};

/// What every goal takes.
struct GoalCommon {
  int priority_class = 0;
};

/// The parameters that every component of a class has besides its kind's own: the loader, schema, manual and forms read
/// them here.
std::span<const ParameterDescriptor> common_parameters(ComponentClass) noexcept;

}  // namespace ganglion
