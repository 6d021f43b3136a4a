#pragma once

#include <string_view>
#include <unordered_map>

#include "ganglion/graph/model.h"

namespace ganglion {

/// Components by id, the first of each; for look-ups only, as its order is one of luck.
using ComponentIndex = std::unordered_map<std::string_view, int>;
ComponentIndex ids_of(const ControllerModel& model);
/// -1 = no such component.
int find(const ComponentIndex& ids, std::string_view id) noexcept;

/// Lays out the outputs of all components: what their descriptors say, the robot's channels, and where a descriptor
/// leaves unit or size open, those of the wire on the component's first open input. False beyond kMaxValues, which is
/// reported as TooLarge: nothing more can be said of the wires then.
bool shape_outputs(ControllerModel& model, const Description& robot, const ComponentIndex& ids, Problems& problems);

}  // namespace ganglion
