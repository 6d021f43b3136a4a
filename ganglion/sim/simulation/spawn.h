#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ganglion/sim/world/way/free_space.h"
#include "ganglion/sim/world/world.h"

namespace ganglion::sim {

/// One pose for each robot.
struct SpawnPoses {
  std::vector<Pose2> poses;
};
/// A [[spawn]] of the world, for one robot.
struct SpawnNamed {
  std::string id;
};
/// Drawn anew in each episode, within the largest connected part of the free ground.
struct SpawnRandom {
  double clearance_m = 0.05;   ///< Between the robot's disc and whatever stands there.
  std::optional<Angle> yaw{};  ///< None = drawn as well.
};
using SpawnRule = std::variant<SpawnPoses, SpawnNamed, SpawnRandom>;

/// Puts robots, discs of radius_m, onto a ground.
class Spawner {
 public:
  /// Fails with BadParameter where the rule cannot hold: too few poses, an unknown spawn, no free ground.
  static Result<Spawner> make(std::shared_ptr<const Ground> ground, SpawnRule rule, int robots, double radius_m);
  /// Draws depend on (seed, episode, robot), and on the robots before it only where they are in its way.
  /// Fails with BadParameter where a robot would stand in a solid or in another robot.
  Result<void> place(const World& world, std::uint64_t seed, std::uint32_t episode, std::span<Pose2> poses);

 private:
  Spawner(SpawnRule rule, double radius_m) : rule_(std::move(rule)), radius_m_(radius_m) {}
  Result<Pose2> draw(const World& world, const StreamId& stream, std::span<const Pose2> before);
  bool is_free(const World& world, Vector2 position, double clearance_m, std::span<const Pose2> before) const noexcept;

  SpawnRule rule_;
  double radius_m_;
  std::unique_ptr<FreeSpace> free_space_;  // for SpawnRandom
};

}  // namespace ganglion::sim
