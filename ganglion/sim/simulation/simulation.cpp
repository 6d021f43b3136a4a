#include "ganglion/sim/simulation/simulation.h"

#include <algorithm>
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
  simulation->prepare();
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
  }
  expects(offset == robot.values.size());
  return {};
}

/// What depends on all robots and their devices.
void Simulation::prepare() {
  way_m_.resize(robots_.size());
  alone_m_.resize(robots_.size());
  busy_.reserve(robots_.size());
  draws_.reserve(robots_.front().devices.size());
  lookout_ = std::make_unique<Lookout>(world_, neighbours_, robots_.size(), *config_.model, robots_.front().devices);
}

Result<void> Simulation::reset(std::uint64_t seed, std::uint32_t episode) {
  tick_ = substeps_ = pace_steps_ = 0;
  time_s_ = pace_s_ = pace_began_s_ = 0;
  world_.reset(seed, episode);
  std::vector<Pose2> poses(robots_.size());
  if (auto placed = spawner_.place(world_, seed, episode, poses); !placed) return placed;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    robots_[i].body.reset(poses[i], {seed, episode, static_cast<std::uint32_t>(i), hash_name("floor")});
    neighbours_.put(i, robots_[i].body.disc());
  }
  neighbours_.sort();
  std::fill(alone_m_.begin(), alone_m_.end(), 0);
  lookout_->call_first(robots_.front().devices);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    std::vector<Device>& devices = robots_[i].devices;
    lookout_->begin(i, robots_[i].body.truth(), 0, 0);
    for (std::size_t n = 0; n < devices.size(); ++n) {
      const StreamId stream{seed, episode, static_cast<std::uint32_t>(i), devices[n].name_hash()};
      if (auto ready = devices[n].reset(lookout_->scene(n), stream); !ready) return ready;
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
      const double age_s = device.age_s(time_s_);
      for (std::size_t n = 0; n < device.channels(); ++n) frame.ages_s[channel++] = age_s;
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
  const double length_s = step_s / count, last_s = time_s_ + length_s * (count - 1);
  const bool plain = world_.movers().empty() && world_.ground().plan().floor.plain();
  const bool at_once = plain && devices_wait(last_s, end_s);
  neighbours_.sort_if_needed();
  busy_.clear();
  for (std::size_t i = 0; i < frames.size(); ++i) busy_.push_back(i);
  if (at_once) move_free_robots(step_s);
  for (int n = 0; n < count && !(at_once && busy_.empty()); ++n) {
    const double begin_s = time_s_ + length_s * n;
    world_.advance(substeps_ + static_cast<std::uint32_t>(n), begin_s, length_s, neighbours_.discs());
    move_busy_robots(length_s * n, length_s);
    if (!at_once && n + 1 < count) run_devices(begin_s, time_s_ + length_s * (n + 1), end_s);
  }
  run_devices(last_s, end_s, end_s);
  substeps_ += static_cast<std::uint32_t>(count);
  ++pace_steps_;
  ++tick_;
  time_s_ = end_s;
}

bool Simulation::devices_wait(double last_s, double end_s) const noexcept {
  for (const Device& device : robots_.front().devices) {  // all robots have the same
    if (device.wants_before(time_s_, last_s, end_s)) return false;
  }
  return true;
}

void Simulation::move_free_robots(double step_s) noexcept {
  double longest_m = 0;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    way_m_[i] = robots_[i].body.steady_way_m(step_s);
    longest_m = std::max(longest_m, std::min(way_m_[i], config_.model->radius_m));
  }
  busy_.clear();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Body& body = robots_[i].body;
    const double apart_m = 2 * config_.model->radius_m + way_m_[i] + longest_m;
    // Who goes farther than its own radius is never sure: then the others need not look far for it.
    const bool free = way_m_[i] <= config_.model->radius_m && body.off_ground(world_.ground(), way_m_[i]) &&
                      (alone_m_[i] > apart_m || neighbours_.within(body.truth().pose.position, apart_m, i).empty());
    if (!free) busy_.push_back(i);
  }
  std::size_t busy = 0;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (busy < busy_.size() && busy_[busy] == i) {
      ++busy;
      continue;
    }
    robots_[i].body.advance_freely(step_s);
    neighbours_.put(i, robots_[i].body.disc());
  }
}

void Simulation::move_busy_robots(double elapsed_s, double step_s) noexcept {
  for (const std::size_t i : busy_) {
    robots_[i].body.advance(world_, neighbours_, i, elapsed_s, time_s_ + elapsed_s, step_s);
    neighbours_.put(i, robots_[i].body.disc());
    tell_bumps(i, time_s_ + elapsed_s);
  }
}

void Simulation::tell_bumps(std::size_t robot, double time_s) noexcept {
  for (const Body::Bump& bump : robots_[robot].body.bumps()) {
    robots_[bump.robot].body.bumped(-bump.normal, bump.speed_mps, time_s);
  }
}

void Simulation::run_devices(double begin_s, double now_s, double end_s) noexcept {
  std::fill(alone_m_.begin(), alone_m_.end(), 0);
  const auto calls = lookout_->call(robots_.front().devices, begin_s, now_s, end_s);  // all robots have the same
  const bool any_draw = std::any_of(calls.begin(), calls.end(), [](const auto& call) { return call.draws_normal; });
  for (std::size_t i = 0; i < robots_.size() && !calls.empty(); ++i) {
    lookout_->begin(i, robots_[i].body.truth(), tick_ + 1, now_s);
    alone_m_[i] = lookout_->alone_m();
    if (any_draw) draw(robots_[i], calls);
    Draws* drawn = draws_.data();
    for (const Lookout::Call& call : calls) {
      Device& device = robots_[i].devices[call.device];
      const Scene& scene = lookout_->scene(call.device);
      if (call.follows) device.follow(scene, now_s - begin_s);
      if (!call.fires) continue;
      if (call.draws_normal) {
        device.fire(scene, *drawn++);
      } else {
        Draws draws = device.draws(tick_ + 1);
        device.fire(scene, draws);
      }
    }
  }
}

void Simulation::draw(const Robot& robot, std::span<const Lookout::Call> calls) noexcept {
  draws_.clear();
  for (const Lookout::Call& call : calls) {
    if (call.draws_normal) draws_.push_back(robot.devices[call.device].draws(tick_ + 1));
  }
  Draws::foresee_normals(draws_);
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
