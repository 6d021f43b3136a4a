#pragma once

#include <memory>

#include "ganglion/application/model.h"
#include "ganglion/sim/simulation/simulation.h"

namespace ganglion::sim {

/// Of all robots in one tick, about a second of work: a run is looked at, and can be ended, between ticks.
inline constexpr double kMostSubsteps = 1e6;

/// Robots as a robot.toml states them, on the ground that [application] names: simulated ones, or such as are only
/// described (no [drive]) and drive elsewhere.
class RobotsModel final : public ApplicationModel {
 public:
  /// Null if there were problems. Of the setting it reads `spawn`.
  static std::shared_ptr<const ApplicationModel> read(const ApplicationSource& source, const SimKinds& kinds,
                                                      Problems& problems);
  /// Asks for the keys that read() would read of a setting.
  static void ask(config::Table& setting);

  const Description& description() const noexcept override { return robot_->tasked; }
  std::span<const TruthChannel> truth() const noexcept override;
  std::span<const LedgerForm> ledgers() const noexcept override { return ledgers_; }
  std::span<const std::string> tasks() const noexcept override { return task_ids_; }
  const Terrain* terrain() const noexcept override { return terrain_.get(); }
  /// TooLarge, at substep_s, above kMostSubsteps.
  Result<void> fits(double step_s) const override;
  Result<std::unique_ptr<Application>> make() const override { return make(ground_, spawn_); }
  /// On open ground, from the same poses.
  Result<std::unique_ptr<Application>> unhindered(const Application& other) const override;
  std::string scene(std::uint64_t seed, std::uint32_t episode) const override;
  /// The longest sub-steps that a step is cut into [s].
  double substep_s() const noexcept { return robot_->substep_s; }

 private:
  Result<std::unique_ptr<Application>> make(std::shared_ptr<const Ground> ground, SpawnRule spawn) const;

  std::shared_ptr<const RobotModel> robot_;
  std::vector<LedgerForm> ledgers_;
  std::vector<std::string> task_ids_;
  std::shared_ptr<const Ground> ground_;  // null where only a description was wanted
  std::unique_ptr<const GroundTerrain> terrain_;
  SpawnRule spawn_ = SpawnRandom{};
  Place substep_place_;
  int robots_ = 1;
};

}  // namespace ganglion::sim
