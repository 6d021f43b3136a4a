#pragma once

#include <vector>

#include "ganglion/link/wire/link.pb.h"
#include "ganglion/sim/robot/witness.h"

namespace ganglion::link {

/// What one listener was told of a trainer's goals, so that a frame carries only those that changed.
class GoalsTold {
 public:
  /// Adds the goals of which the listener does not know the present state.
  void tell(const sim::TrainerLog& log, wire::Truth& out);

 private:
  std::vector<sim::GoalOutcome> outcomes_;
};

/// All but the goals.
void write_truth(const sim::Truth& truth, wire::Truth& out);

/// Of each mover x_m, y_m, yaw_rad.
void write_movers(std::span<const sim::MoverState> movers, wire::Sense& out);

}  // namespace ganglion::link
