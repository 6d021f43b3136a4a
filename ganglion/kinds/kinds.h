#pragma once

#include "ganglion/graph/kind_list.h"
#include "ganglion/measure/measure.h"
#include "ganglion/plant/plant.h"
#include "ganglion/sim/robot/robot_model.h"
#include "ganglion/task/task.h"

namespace ganglion {

/// Every kind a controller may use; written by the build from the folders that hold one.
KindList controller_kinds() noexcept;

/// Every kind a simulated robot may use.
sim::SimKinds sim_kinds() noexcept;

/// Every kind of plant, and of task.
std::span<const PlantKind* const> plant_kinds() noexcept;
std::span<const TaskKind* const> task_kinds() noexcept;

/// Every kind of measure.
std::span<const MeasureKind* const> measure_kinds() noexcept;

/// The descriptors of all of them, by class, in order of their folders' names.
std::vector<const Descriptor*> all_descriptors();

}  // namespace ganglion
