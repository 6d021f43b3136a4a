#pragma once

#include <span>

#include "ganglion/sim/robot/trainer_log.h"
#include "ganglion/sim/robot/truth.h"
#include "ganglion/sim/world/world.h"

namespace ganglion::sim {

/// What is known of simulated robots besides what their sensors say, for measures and pictures. A simulation is one; a
/// link carries it on; a real robot has none.
class Witness {
 public:
  virtual ~Witness() = default;
  virtual const Truth& truth(int robot) const noexcept = 0;
  /// Of the robot's first trainer; null if it has none.
  virtual const TrainerLog* trainer_log(int robot) const noexcept = 0;
  virtual std::span<const MoverState> movers() const noexcept = 0;
};

}  // namespace ganglion::sim
