#include "ganglion/sim/simulation/simulation.h"

#include <cmath>

#include "ganglion/base/hash.h"

namespace ganglion::sim {

Simulation::Simulation(SimulationConfig config, Spawner spawner)
    : config_(std::move(config)), spawner_(std::move(spawner)), world_(config_.ground) {}

Result<std::unique_ptr<Simulation>> Simulation::make(SimulationConfig config) {
  if (config.ground == nullptr) return fail(ErrorCode::BadParameter, "a simulation needs a ground");
  if (config.robots < 1) return fail(ErrorCode::BadParameter, "robots is {}, must be >= 1", config.robots);
  if (config.model == nullptr || !config.model->simulated()) {
    return fail(ErrorCode::BadParameter, "the robot has no [drive]: it is described, not simulated");
  }
  auto spawner = Spawner::make(config.ground, config.spawn, config.robots, config.model->radius_m);
  if (!spawner) return tl::unexpected<Error>(spawner.error());
  std::unique_ptr<Simulation> simulation(new Simulation(std::move(config), std::move(*spawner)));
  const int robots = simulation->robots();
  simulation->robots_.reserve(static_cast<std::size_t>(robots));  // devices point into their robot
  for (int i = 0; i < robots; ++i) {
    if (auto added = simulation->add_robot(); !added) return tl::unexpected<Error>(added.error());
  }
  return simulation;
}

Result<void> Simulation::add_robot() {
  const RobotModel& model = *config_.model;
  auto drive = model.drive->make(model.drive_parameters);
  if (!drive) return tl::unexpected<Error>(drive.error());
  robots_.push_back({Body(model, std::move(*drive)), {}, {}});
  Robot& robot = robots_.back();
  robot.body.make_room(static_cast<std::size_t>(config_.robots));
  robot.values.resize(static_cast<std::size_t>(model.description.sensation_values()));
  std::size_t offset = 0;
  for (const SensorModel& sensor : model.sensors) {
    auto made = sensor.kind->make(sensor.parameters);
    if (!made) return tl::unexpected<Error>(made.error());
    std::size_t size = 0;
    for (const PortDescriptor& port : sensor.kind->descriptor.ports) size += static_cast<std::size_t>(port.size);
    robot.devices.emplace_back(sensor, std::move(*made), std::span<double>(robot.values).subspan(offset, size));
    offset += size;
    reach_m_ = std::max(reach_m_, robot.devices.back().sensor().reach_m());
  }
  expects(offset == robot.values.size());
  return {};
}

void Simulation::look_round(std::size_t robot) noexcept {
  others_.clear();
  if (!(reach_m_ > 0)) return;
  const Vector2 here = discs_[robot].position;
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    const double far_m = reach_m_ + discs_[i].radius_m + config_.model->radius_m;
    if (i != robot && (discs_[i].position - here).squared() <= far_m * far_m) others_.push_back(discs_[i]);
  }
}

Scene Simulation::scene(std::size_t robot, const Device& device, std::uint32_t tick, double time_s) const noexcept {
  const Truth& truth = robots_[robot].body.truth();
  return {.world = world_,
          .robot = truth,
          .mount = truth.pose.then(device.model().mount),
          .others = others_,
          .radius_m = config_.model->radius_m,
          .tick = tick,
          .time_s = time_s};
}

Result<void> Simulation::reset(std::uint64_t seed, std::uint32_t episode) {
  tick_ = substeps_ = pace_steps_ = 0;
  time_s_ = pace_s_ = pace_began_s_ = 0;
  world_.reset(seed, episode);
  std::vector<Pose2> poses(robots_.size());
  if (auto placed = spawner_.place(world_, seed, episode, poses); !placed) return placed;
  discs_.clear();
  others_.reserve(robots_.size());
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    robots_[i].body.reset(poses[i], {seed, episode, static_cast<std::uint32_t>(i), hash_name("floor")});
    discs_.push_back(robots_[i].body.disc());
  }
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    look_round(i);
    for (Device& device : robots_[i].devices) {
      const StreamId stream{seed, episode, static_cast<std::uint32_t>(i), hash_name(device.model().id)};
      if (auto ready = device.reset(scene(i, device, 0, 0), stream); !ready) return ready;
    }
  }
  return {};
}

void Simulation::sense(std::span<SenseFrame> frames) noexcept {
  expects(frames.size() == robots_.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Robot& robot = robots_[i];
    SenseFrame& frame = frames[i];
    frame.tick = tick_;
    frame.time_s = time_s_;
    frame.cost = tick_ == 0 ? std::nullopt : std::optional(robot.body.truth().step_energy_J);
    std::copy(robot.values.begin(), robot.values.end(), frame.values.begin());
    std::size_t channel = 0;
    for (const Device& device : robot.devices) {
      for (std::size_t n = 0; n < device.model().kind->descriptor.ports.size(); ++n) {
        frame.ages_s[channel++] = device.age_s(time_s_);
      }
    }
  }
}

void Simulation::step(std::span<const ActFrame> frames, double step_s) noexcept {
  expects(frames.size() == robots_.size() && step_s > 0);
  if (step_s != pace_s_) {
    pace_s_ = step_s;
    pace_began_s_ = time_s_;
    pace_steps_ = 0;
  }
  const double end_s = pace_began_s_ + step_s * (pace_steps_ + 1);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    robots_[i].body.begin(frames[i], step_s);
    for (Device& device : robots_[i].devices) device.hear(frames[i]);
  }
  const int count = std::max(1, static_cast<int>(std::ceil(step_s / config_.model->substep_s - 1e-9)));
  for (int n = 0; n < count; ++n) substep(n, count, step_s, end_s);
  ++pace_steps_;
  ++tick_;
  time_s_ = end_s;
}

void Simulation::substep(int n, int count, double step_s, double end_s) noexcept {
  const double length_s = step_s / count;
  const double begin_s = time_s_ + length_s * n;
  const double now_s = n + 1 == count ? end_s : time_s_ + length_s * (n + 1);
  world_.advance(substeps_++, begin_s, length_s, discs_);
  move_robots(length_s * n, length_s);
  run_devices(begin_s, now_s, end_s);
}

void Simulation::move_robots(double elapsed_s, double step_s) noexcept {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    robots_[i].body.advance(world_, discs_, i, elapsed_s, time_s_ + elapsed_s, step_s);
    discs_[i] = robots_[i].body.disc();
    tell_bumps(i, time_s_ + elapsed_s);
  }
}

void Simulation::tell_bumps(std::size_t robot, double time_s) noexcept {
  for (const Body::Bump& bump : robots_[robot].body.bumps()) {
    robots_[bump.robot].body.bumped(-bump.normal, bump.speed_mps, time_s);
  }
}

void Simulation::run_devices(double begin_s, double now_s, double end_s) noexcept {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    bool looked = false;
    for (Device& device : robots_[i].devices) {
      if (!device.wants(begin_s, now_s, end_s)) continue;
      if (!looked) look_round(i);
      looked = true;
      device.follow(scene(i, device, tick_ + 1, now_s), begin_s, end_s);
    }
  }
}

const TrainerLog* Simulation::trainer_log(int robot) const noexcept {
  for (const Device& device : robot_at(robot).devices) {
    if (const TrainerLog* log = device.sensor().trainer_log()) return log;
  }
  return nullptr;
}

bool Simulation::trainer_done() const noexcept {
  bool any = false;
  for (int i = 0; i < robots(); ++i) {
    const TrainerLog* log = trainer_log(i);
    if (log != nullptr && !log->done()) return false;
    any = any || log != nullptr;
  }
  return any;
}

}  // namespace ganglion::sim
