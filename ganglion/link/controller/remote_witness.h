#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/link/wire/link.pb.h"
#include "ganglion/sim/robot/witness.h"

namespace ganglion::link {

/// The truth about simulated robots as it came over the link.
class RemoteWitness final : public sim::Witness {
 public:
  explicit RemoteWitness(const wire::Describe& describe);
  /// Takes the truth of a frame; the first one of an episode tells where it starts. Fails with BadParameter where it is
  /// not that of these robots.
  Result<void> take(const wire::Sense& sense, bool first);

  const sim::Truth& truth(int robot) const noexcept override { return truths_[static_cast<std::size_t>(robot)]; }
  const sim::TrainerLog* trainer_log(int robot) const noexcept override;
  std::span<const sim::MoverState> movers() const noexcept override { return movers_; }

 private:
  struct Log final : sim::TrainerLog {
    std::span<const sim::GoalRecord> records() const noexcept override { return goals; }
    bool done() const noexcept override { return all_done; }
    std::vector<sim::GoalRecord> goals;
    bool all_done = false;
    bool trained = false;
  };
  static Result<void> take_goals(const wire::Truth& message, Log& log);

  std::vector<sim::Truth> truths_;
  std::vector<Log> logs_;
  std::vector<std::string> mover_ids_;
  std::vector<sim::MoverState> movers_;
};

}  // namespace ganglion::link
