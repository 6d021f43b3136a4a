#include "ganglion/sim/simulation/simulation.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/hash.h"

namespace ganglion::sim {
namespace {

constexpr double kApart_m = 1e-6;  // left over between robots that meet nothing

}  // namespace

Simulation::Simulation(SimulationConfig config, Spawner spawner)
    : config_(std::move(config)),
      spawner_(std::move(spawner)),
      world_(config_.ground),
      terrain_(config_.ground, &world_) {}

Result<std::unique_ptr<Simulation>> Simulation::make(SimulationConfig config) {
  if (config.ground == nullptr)
    return fail(ErrorCode::BadParameter, {"a simulation needs a ground", "una simulación necesita un terreno"});
  if (config.robots < 1)
    return fail(ErrorCode::BadParameter, {"robots is {}, must be >= 1", "robots es {}, debe ser >= 1"}, config.robots);
  if (config.model == nullptr || !config.model->simulated()) {
    return fail(ErrorCode::BadParameter, {"the robot has no [drive]: it is described, not simulated",
                                          "el robot no tiene [drive]: está descrito, no simulado"});
  }
  auto spawner = Spawner::make(config.ground, config.spawn, config.robots, config.model->radius_m);
  if (!spawner) return tl::unexpected<Error>(spawner.error());
  std::unique_ptr<Simulation> simulation(new Simulation(std::move(config), std::move(*spawner)));
  if (auto added = simulation->add_bodies(); !added) return tl::unexpected<Error>(added.error());
  if (auto added = simulation->add_devices(); !added) return tl::unexpected<Error>(added.error());
  simulation->prepare();
  return simulation;
}

Result<void> Simulation::add_bodies() {
  const RobotModel& model = *config_.model;
  const auto robots = static_cast<std::size_t>(config_.robots);
  bodies_.reserve(robots);
  for (std::size_t i = 0; i < robots; ++i) {
    auto drive = model.drive->make(model.drive_parameters);
    if (!drive) return tl::unexpected<Error>(drive.error());
    bodies_.emplace_back(model, std::move(*drive));
  }
  return {};
}

Result<void> Simulation::add_devices() {
  for (const SensorModel& sensor : config_.model->sensors) {
    auto device = Device::make(sensor, bodies_.size(), stride_);
    if (!device) return tl::unexpected<Error>(device.error());
    stride_ += device->size();
    devices_.push_back(std::move(*device));
  }
  expects(stride_ == static_cast<std::size_t>(config_.model->description.sensation_values()));
  return {};
}

/// What depends on all robots and their devices.
void Simulation::prepare() {
  values_.resize(stride_ * bodies_.size());
  truths_.resize(sim::truth_channels().size() * bodies_.size());
  placed_.resize(world_.movers().size());
  ages_s_.resize(config_.model->description.sensations.size());
  way_m_.resize(bodies_.size());
  is_busy_.resize(bodies_.size());
  alone_m_.resize(bodies_.size());
  busy_.reserve(bodies_.size());
  wishes_.resize(bodies_.size());
  crowd_ = std::make_unique<Crowd>(config_.model->radius_m, bodies_.front().yields());
  crowd_->make_room(bodies_.size());
  draws_.reserve(devices_.size());
  lookout_ = std::make_unique<Lookout>(world_, neighbours_, bodies_.size(), *config_.model, devices_);
}

Result<void> Simulation::reset(std::uint64_t seed, std::uint32_t episode) {
  tick_ = substeps_ = 0;
  clock_ = {};
  time_s_ = 0;
  world_.reset(seed, episode);
  std::vector<Pose2> poses(bodies_.size());
  if (auto placed = spawner_.place(world_, seed, episode, poses); !placed) return placed;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i].reset(poses[i], {seed, episode, static_cast<std::uint32_t>(i), hash_name("floor")});
    neighbours_.put(i, bodies_[i].disc());
  }
  neighbours_.sort();
  std::fill(alone_m_.begin(), alone_m_.end(), 0);
  lookout_->call_first(devices_);
  for (Device& device : devices_) device.reset(seed, episode);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    lookout_->begin(i, bodies_[i], 0, 0);
    for (std::size_t n = 0; n < devices_.size(); ++n) {
      if (auto ready = devices_[n].reset(i, lookout_->scene(n), values_of(i)); !ready) return ready;
    }
  }
  for (Device& device : devices_) {
    if (device.fires_at_once()) device.fired(0);
  }
  return {};
}

void Simulation::sense(std::span<SenseFrame> frames) noexcept {
  expects(frames.size() == bodies_.size());
  std::size_t channel = 0;
  for (const Device& device : devices_) {
    for (std::size_t n = 0; n < device.channels(); ++n) ages_s_[channel++] = device.age_s(time_s_);
  }
  for (std::size_t i = 0; i < frames.size(); ++i) {
    SenseFrame& frame = frames[i];
    frame.tick = tick_;
    frame.time_s = time_s_;
    frame.cost = tick_ == 0 ? std::nullopt : std::optional(bodies_[i].truth().step_energy_J);
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(i * stride_), stride_, frame.values.begin());
    std::copy(ages_s_.begin(), ages_s_.end(), frame.ages_s.begin());
  }
}

void Simulation::step(std::span<const ActFrame> frames, double step_s) noexcept {
  expects(frames.size() == bodies_.size() && step_s > 0);
  const double end_s = clock_.end_s(step_s);
  for (std::size_t i = 0; i < frames.size(); ++i) bodies_[i].begin(frames[i], step_s);
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
  clock_.advance();
  ++tick_;
  time_s_ = end_s;
}

bool Simulation::devices_wait(double last_s, double end_s) const noexcept {
  for (const Device& device : devices_) {
    if (device.wants_before(time_s_, last_s, end_s)) return false;
  }
  return true;
}

bool Simulation::goes_freely(std::size_t robot, double longest_m, double step_s) noexcept {
  const double way_m = way_m_[robot], radius_m = config_.model->radius_m;
  if (way_m == 0) return true;  // it turns on the spot, or stands: it is the others who run into it
  // Who goes farther than its own radius is never sure: then the others need not look far for it.
  if (way_m > radius_m || !bodies_[robot].off_ground(world_.ground(), way_m, step_s)) return false;
  const Vector2 here = bodies_[robot].truth().pose.position;
  const double look_m = 2 * radius_m + way_m + longest_m;
  if (alone_m_[robot] > look_m) return true;
  for (const std::uint32_t other : neighbours_.within(here, look_m, robot)) {
    const Vector2 there = bodies_[other].truth().pose.position;
    const double apart_m = 2 * radius_m + std::min(way_m_[other], radius_m);
    if ((there - here).length() > apart_m + way_m) continue;
    if (!(bodies_[robot].nearest_m(there, way_m, step_s) > apart_m + kApart_m)) return false;
  }
  return true;
}

void Simulation::wake_standing_robots(double longest_m) noexcept {
  std::fill(is_busy_.begin(), is_busy_.end(), 0);
  for (const std::size_t i : busy_) is_busy_[i] = 1;
  const std::size_t moving = busy_.size();
  const double reach_m = 2 * config_.model->radius_m + longest_m + kApart_m;
  for (std::size_t n = 0; n < busy_.size(); ++n) {
    for (const std::uint32_t other : neighbours_.within(bodies_[busy_[n]].truth().pose.position, reach_m, busy_[n])) {
      if (is_busy_[other] != 0 || way_m_[other] > 0) continue;
      is_busy_[other] = 1;
      busy_.push_back(other);
    }
  }
  if (busy_.size() > moving) std::sort(busy_.begin(), busy_.end());
}

void Simulation::move_free_robots(double step_s) noexcept {
  double longest_m = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    way_m_[i] = bodies_[i].steady_way_m(step_s);
    longest_m = std::max(longest_m, std::min(way_m_[i], config_.model->radius_m));
  }
  busy_.clear();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!goes_freely(i, longest_m, step_s)) busy_.push_back(i);
  }
  if (bodies_.front().yields()) wake_standing_robots(longest_m);
  std::size_t busy = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (busy < busy_.size() && busy_[busy] == i) {
      ++busy;
      continue;
    }
    bodies_[i].advance_freely(step_s);
    neighbours_.put(i, bodies_[i].disc());
    part(i);
  }
}

void Simulation::part(std::size_t robot) noexcept {
  Body& body = bodies_[robot];
  if (!body.leaning()) return;
  const double touch_m = 2 * config_.model->radius_m + kApart_m;
  if (neighbours_.within(body.truth().pose.position, touch_m, robot).empty()) body.stand_alone();
}

void Simulation::move_busy_robots(double elapsed_s, double step_s) noexcept {
  for (const std::size_t i : busy_) {
    bodies_[i].intend(world_.ground().plan().floor, elapsed_s, step_s);
    wishes_[i] = bodies_[i].wish();
  }
  crowd_->gather(neighbours_, busy_, wishes_);
  for (const std::size_t i : busy_) {
    if (!crowd_->has(i)) move_alone(i, time_s_ + elapsed_s, step_s);
  }
  if (!crowd_->members().empty()) move_crowd(time_s_ + elapsed_s, step_s);
}

void Simulation::move_alone(std::size_t robot, double time_s, double step_s) noexcept {
  Body& body = bodies_[robot];
  World::Slide slide{body.truth().pose.position, false, {}};
  if (wishes_[robot].way.squared() > 0)
    slide = world_.slide(slide.position, wishes_[robot].way, config_.model->radius_m);
  body.settle(world_.ground().plan().floor, slide.position, slide.touched, step_s);
  if (slide.touched) body.note_contact(slide.normal, -wishes_[robot].way.dot(slide.normal) / step_s, time_s);
  neighbours_.put(robot, body.disc());
  part(robot);
}

void Simulation::move_crowd(double time_s, double step_s) noexcept {
  crowd_->push(world_, neighbours_);
  const Floor& floor = world_.ground().plan().floor;
  for (const std::size_t i : crowd_->members())
    bodies_[i].settle(floor, neighbours_.discs()[i].position, crowd_->pressed(i), step_s);
  for (const Crowd::Press& press : crowd_->presses()) {
    Body& body = bodies_[press.robot];
    if (!press.wall) body.lean();
    body.note_contact(press.normal, press.closing_m / step_s, time_s);
  }
  for (const std::size_t i : crowd_->members()) part(i);
}

void Simulation::run_devices(double begin_s, double now_s, double end_s) noexcept {
  std::fill(alone_m_.begin(), alone_m_.end(), 0);
  const auto calls = lookout_->call(devices_, begin_s, now_s, end_s);
  if (calls.empty() && lookout_->rays().empty()) return;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    lookout_->begin(i, bodies_[i], tick_ + 1, now_s);
    alone_m_[i] = lookout_->alone_m();
    lookout_->read_rays(values_of(i));
    if (!calls.empty()) run_devices(i, calls, now_s - begin_s);
  }
  for (const Lookout::Ray& ray : lookout_->rays()) devices_[ray.device].fired(now_s);
  for (const Lookout::Call& call : calls) {
    if (call.fires) devices_[call.device].fired(now_s);
  }
}

void Simulation::run_devices(std::size_t robot, std::span<const Lookout::Call> calls, double substep_s) noexcept {
  const auto values = values_of(robot);
  draw(robot, calls);
  Draws* drawn = draws_.data();
  for (const Lookout::Call& call : calls) {
    Device& device = devices_[call.device];
    const Scene& scene = lookout_->scene(call.device);
    if (call.follows) device.follow(robot, scene, substep_s);
    if (!call.fires) continue;
    if (call.draws_normal) {
      device.fire(robot, scene, *drawn++, values);
    } else {
      Draws draws = device.draws(robot, tick_ + 1);
      device.fire(robot, scene, draws, values);
    }
  }
}

void Simulation::draw(std::size_t robot, std::span<const Lookout::Call> calls) noexcept {
  draws_.clear();
  for (const Lookout::Call& call : calls) {
    if (call.draws_normal) draws_.push_back(devices_[call.device].draws(robot, tick_ + 1));
  }
  Draws::foresee_normals(draws_);
}

std::span<const double> Simulation::truth_of(int robot) const noexcept {
  const std::size_t size = sim::truth_channels().size();
  const auto row = std::span(truths_).subspan(static_cast<std::size_t>(robot) * size, size);
  write_truth(truth(robot), row);
  return row;
}

std::span<const PlacedMover> Simulation::movers() const noexcept {
  for (std::size_t n = 0; n < placed_.size(); ++n) placed_[n] = {world_.movers()[n].id, world_.movers()[n].pose};
  return placed_;
}

}  // namespace ganglion::sim
