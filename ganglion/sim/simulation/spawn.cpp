#include "ganglion/sim/simulation/spawn.h"

#include "ganglion/base/hash.h"
#include "ganglion/base/text.h"

namespace ganglion::sim {
namespace {

constexpr int kTries = 1000;
constexpr double kTolerance_m = 1e-9;  // a robot may start exactly at a wall

/// The poses a rule gives without drawing; empty for random ones.
Result<std::vector<Pose2>> stated_poses(const Ground& ground, const SpawnRule& rule, int robots) {
  if (const auto* stated = std::get_if<SpawnPoses>(&rule)) {
    if (stated->poses.size() == static_cast<std::size_t>(robots)) return stated->poses;
    return fail(ErrorCode::BadParameter,
                {"there are {} start poses for {} robots", "hay {} poses de salida para {} robots"},
                stated->poses.size(), robots);
  }
  if (const auto* named = std::get_if<SpawnNamed>(&rule)) {
    const Spawn* spawn = ground.spawn(named->id);
    if (spawn == nullptr) {
      std::vector<std::string> ids;
      for (const Spawn& other : ground.spawns()) ids.push_back(other.id);
      const Sentence what = say({"the world has no spawn \"{}\"{}", "el mundo no tiene el punto de salida \"{}\"{}"},
                                named->id, suggestion(named->id, ids));
      return tl::unexpected<Error>(Error{ErrorCode::BadParameter, what, {}, {.found = named->id, .choices = ids}});
    }
    if (robots != 1)
      return fail(ErrorCode::BadParameter,
                  {"spawn \"{}\" is one place, not {}", "el punto de salida \"{}\" es un solo lugar, no {}"}, named->id,
                  robots);
    return std::vector<Pose2>{spawn->pose};
  }
  return std::vector<Pose2>{};
}

}  // namespace

Result<Spawner> Spawner::make(std::shared_ptr<const Ground> ground, SpawnRule rule, int robots, double radius_m) {
  auto poses = stated_poses(*ground, rule, robots);
  if (!poses) return tl::unexpected<Error>(poses.error());
  const auto* random = std::get_if<SpawnRandom>(&rule);
  if (random == nullptr) return Spawner(SpawnPoses{std::move(*poses)}, radius_m);
  Spawner spawner(rule, radius_m);
  spawner.free_space_ = std::make_unique<FreeSpace>(std::move(ground));
  if (!(spawner.free_space_->largest_part_area_m2(radius_m + random->clearance_m) > 0)) {
    return fail(ErrorCode::BadParameter,
                {"nowhere on the ground is a robot of radius {:.3g} m {:.3g} m clear",
                 "en ningún lugar del terreno tiene un robot de {:.3g} m de radio {:.3g} m libres"},
                radius_m, random->clearance_m);
  }
  return spawner;
}

bool Spawner::is_free(const World& world, Vector2 position, double clearance_m,
                      std::span<const Pose2> before) const noexcept {
  const double needed_m = radius_m_ + clearance_m;
  if (world.clearance(position, needed_m) < needed_m - kTolerance_m) return false;
  for (const Pose2& other : before) {
    if ((other.position - position).length() < needed_m + radius_m_ - kTolerance_m) return false;
  }
  return true;
}

Result<Pose2> Spawner::draw(const World& world, const StreamId& stream, std::span<const Pose2> before) {
  const auto& random = std::get<SpawnRandom>(rule_);
  Draws draws(stream, 0);
  const Angle yaw = random.yaw.value_or(Angle::from_rad(draws.uniform(-kPi, kPi)));
  for (int n = 0; n < kTries; ++n) {
    const Vector2 position = free_space_->sample(radius_m_ + random.clearance_m, draws);
    if (is_free(world, position, random.clearance_m, before)) return Pose2{position, yaw.wrapped()};
  }
  return fail(ErrorCode::BadParameter,
              {"no free place was found in {} draws for robot {}: too many robots?",
               "no se halló un lugar libre en {} intentos para el robot {}: ¿demasiados robots?"},
              kTries, stream.robot);
}

Result<void> Spawner::place(const World& world, std::uint64_t seed, std::uint32_t episode, std::span<Pose2> poses) {
  const auto* stated = std::get_if<SpawnPoses>(&rule_);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto before = std::span<const Pose2>(poses).first(i);
    if (stated == nullptr) {
      auto drawn = draw(world, {seed, episode, static_cast<std::uint32_t>(i), hash_name("spawn")}, before);
      if (!drawn) return tl::unexpected<Error>(drawn.error());
      poses[i] = *drawn;
      continue;
    }
    poses[i] = {stated->poses[i].position, stated->poses[i].yaw.wrapped()};
    if (!is_free(world, poses[i].position, 0, before)) {
      return fail(ErrorCode::BadParameter,
                  {"robot {} of radius {:.3g} m cannot start at ({:.3f}, {:.3f}): something stands there",
                   "el robot {}, de {:.3g} m de radio, no puede salir de ({:.3f}, {:.3f}): hay algo allí"},
                  i, radius_m_, poses[i].position.x, poses[i].position.y);
    }
  }
  return {};
}

}  // namespace ganglion::sim
