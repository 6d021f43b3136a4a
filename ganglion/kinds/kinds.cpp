#include "ganglion/kinds/kinds.h"

#include "ganglion/kinds/lists.h"

namespace ganglion {

KindList controller_kinds() noexcept { return {k_sensing, k_goal, k_acting, k_coordination}; }

std::span<const PlantKind* const> plant_kinds() noexcept { return k_plant; }

std::span<const TaskKind* const> task_kinds() noexcept { return k_task; }

sim::SimKinds sim_kinds() noexcept { return {k_sim_drive, k_sim_sensor, k_task}; }

std::span<const MeasureKind* const> measure_kinds() noexcept { return k_measure; }

std::vector<const Descriptor*> all_descriptors() {
  std::vector<const Descriptor*> all;
  auto append = [&](const auto& kinds) {
    for (const auto* kind : kinds) all.push_back(&kind->descriptor);
  };
  append(k_sensing);
  append(k_goal);
  append(k_acting);
  append(k_coordination);
  append(k_sim_drive);
  append(k_sim_sensor);
  append(k_plant);
  append(k_task);
  append(k_measure);
  return all;
}

}  // namespace ganglion
