#include "ganglion/sim/application/simulated_robots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ganglion/base/text.h"
#include "ganglion/sim/world/scene.h"
#include "ganglion/task/tasked_application.h"

namespace ganglion::sim {
namespace {

std::shared_ptr<const Ground> open_ground(Problems& problems) {
  auto ground = Ground::make(GroundPlan{.name = "open ground"}, problems);
  return ground ? std::make_shared<const Ground>(std::move(*ground)) : nullptr;
}

/// Where robots start: at a pose, at a spawn of the world, or somewhere with room around it.
SpawnRule read_spawn(config::Table table) {
  const std::string id = table.text("id", "");
  const std::vector<double> pose = table.numbers("pose", {}, 3);
  SpawnRandom random;
  random.clearance_m = table.number("clearance_m", 0.3, config::Range{0, 100});
  const double yaw_deg = table.number("yaw_deg", std::numeric_limits<double>::quiet_NaN());
  if (!std::isnan(yaw_deg)) random.yaw = Angle::from_deg(yaw_deg);
  if (!pose.empty() && !id.empty())
    table.problem("id", ErrorCode::BadParameter, {"give either a pose or an id", "dé una pose o un id, no ambos"});
  if (!pose.empty()) return SpawnPoses{{Pose2{{pose[0], pose[1]}, Angle::from_deg(pose[2])}}};
  if (!id.empty()) return SpawnNamed{id};
  return random;
}

std::shared_ptr<const Ground> read_ground(const ApplicationSource& source, Problems& problems) {
  if (source.world < 0 || source.files == nullptr) return open_ground(problems);
  auto ground = Ground::load(*source.files, source.world, problems, source.world_overrides);
  return ground ? std::make_shared<const Ground>(std::move(*ground)) : nullptr;
}

}  // namespace

void RobotsModel::ask(config::Table& setting) { static_cast<void>(read_spawn(setting.table("spawn"))); }

std::shared_ptr<const ApplicationModel> RobotsModel::read(const ApplicationSource& source, const SimKinds& kinds,
                                                          Problems& problems) {
  const std::size_t before = problems.size();
  auto model = std::make_shared<RobotsModel>();
  model->robot_ = read_robot(source.file, kinds, problems, source.files, source.outline);
  model->robots_ = source.robots;
  const config::Value* substep = source.file.find("substep_s");
  model->substep_place_ = substep != nullptr ? substep->place() : Place{source.file.place().file, 1, 1};
  if (model->robot_ != nullptr) {
    model->ledgers_ = ledgers_of(model->robot_->tasks);
    model->task_ids_ = ids_of(model->robot_->tasks);
  }
  if (model->robot_ != nullptr && !model->robot_->simulated() && source.here && source.setting != nullptr) {
    problems.add({source.file.place().file, 1, 1}, ErrorCode::MissingKey,
                 {"describes a robot without [drive]: it cannot be simulated; where is it? Give application.address",
                  "describe un robot sin [drive]: no se puede simular; ¿dónde está? Dé application.address"});
  }
  if (source.setting != nullptr) {
    model->spawn_ = read_spawn(source.setting->table("spawn"));
    model->ground_ = read_ground(source, problems);
    model->terrain_ = std::make_unique<const GroundTerrain>(model->ground_);
  }
  return problems.size() == before ? model : nullptr;
}

std::span<const TruthChannel> RobotsModel::truth() const noexcept {
  return robot_->simulated() ? truth_channels() : std::span<const TruthChannel>();
}

Result<void> RobotsModel::fits(double step_s) const {
  if (!robot_->simulated()) return {};
  const double each = std::max(1.0, std::ceil(step_s / robot_->substep_s));
  if (each * robots_ <= kMostSubsteps) return {};
  return fail_at(substep_place_, ErrorCode::TooLarge,
                 {"a tick of {} s in sub-steps of at most {} s are {:.0f} for {} robot{}; the limit is {:.0f}",
                  "un ciclo de {} s en subpasos de {} s como máximo son {:.0f} para {} robot{}; el límite es {:.0f}"},
                 shortest(step_s), shortest(robot_->substep_s), each * robots_, robots_, robots_ == 1 ? "" : "s",
                 kMostSubsteps);
}

Result<std::unique_ptr<Application>> RobotsModel::make(std::shared_ptr<const Ground> ground, SpawnRule spawn) const {
  auto simulation =
      Simulation::make({.ground = std::move(ground), .model = robot_, .robots = robots_, .spawn = std::move(spawn)});
  if (!simulation) return tl::unexpected<Error>(simulation.error());
  return TaskedApplication::make(std::move(*simulation), robot_->tasked, robot_->tasks);
}

Result<std::unique_ptr<Application>> RobotsModel::unhindered(const Application& other) const {
  const Witness* witness = other.witness();
  const auto x = index_of(truth(), "x_m"), y = index_of(truth(), "y_m"), yaw = index_of(truth(), "yaw_rad");
  if (witness == nullptr || !x || !y || !yaw) return std::unique_ptr<Application>();
  SpawnPoses starts;
  for (int n = 0; n < other.robots(); ++n) {
    const auto row = witness->truth_of(n);
    starts.poses.push_back({{row[*x], row[*y]}, Angle::from_rad(row[*yaw])});
  }
  Problems problems;
  auto ground = open_ground(problems);
  if (ground == nullptr) return tl::unexpected<Error>(problems.sorted().front());
  return make(std::move(ground), std::move(starts));
}

std::string RobotsModel::scene(std::uint64_t seed, std::uint32_t episode) const {
  if (ground_ == nullptr) return {};
  World world(ground_);
  world.reset(seed, episode);
  return scene_json(world);
}

}  // namespace ganglion::sim
