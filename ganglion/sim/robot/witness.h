#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "ganglion/application/witness.h"
#include "ganglion/sim/robot/trainer_ledger.h"
#include "ganglion/sim/robot/trainer_log.h"
#include "ganglion/sim/robot/truth.h"
#include "ganglion/sim/world/world.h"

namespace ganglion::sim {

/// What is known of simulated robots besides what their sensors say, for pictures; measures and digests take it as the
/// channels and ledgers of a ganglion::Witness. A simulation is one; a link carries it on; a real robot has none.
class Witness : public ganglion::Witness {
 public:
  virtual const Truth& truth(int robot) const noexcept = 0;
  /// Of the robot's first trainer; null if it has none.
  virtual const TrainerLog* trainer_log(int robot) const noexcept = 0;
  virtual std::span<const MoverState> movers() const noexcept = 0;

  std::span<const TruthChannel> truth_channels() const noexcept override;
  std::span<const double> truth_of(int robot) const noexcept override;
  const Ledger* goals_of(int robot) const noexcept override;

 private:
  mutable std::vector<std::vector<double>> rows_;             // of each robot that was asked for
  mutable std::deque<std::optional<TrainerLedger>> ledgers_;  // the same
};

}  // namespace ganglion::sim
