#include "ganglion/sim/simulation/device.h"

#include <cmath>

#include "ganglion/base/hash.h"

namespace ganglion::sim {
namespace {

constexpr double kTimeTolerance_s = 1e-7;  // sums of steps differ from multiples of periods by rounding

}  // namespace

Device::Device(const SensorModel& model, std::size_t offset)
    : model_(&model), offset_(offset), name_hash_(hash_name(model.id)) {
  for (const PortDescriptor& port : model.kind->descriptor.ports) size_ += static_cast<std::size_t>(port.size);
}

Result<Device> Device::make(const SensorModel& model, std::size_t robots, std::size_t offset) {
  Device device(model, offset);
  do {
    auto sensor = model.kind->make(model.parameters);
    if (!sensor) return tl::unexpected<Error>(sensor.error());
    device.sensors_.push_back(std::move(*sensor));
    device.shared_ = !device.sensors_.front()->remembers();
  } while (!device.shared_ && device.sensors_.size() < robots);
  return device;
}

void Device::reset(std::uint64_t seed, std::uint32_t episode) noexcept {
  stream_ = {seed, episode, 0, name_hash_};
  draws_ = Draws(stream_, 0);
  fired_s_ = -std::numeric_limits<double>::infinity();
}

Result<void> Device::reset(std::size_t robot, const Scene& scene, std::span<double> robot_values) {
  const auto values = robot_values.subspan(offset_, size_);
  std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
  StreamId beginning = stream_;
  beginning.robot = static_cast<std::uint32_t>(robot);
  beginning.component = combine(name_hash_, hash_name("reset"));
  if (auto begun = sensor(robot).reset(scene, Draws(beginning, 0)); !begun) return begun;
  Draws first = draws(robot, scene.tick);
  if (fires_at_once()) fire(robot, scene, first, robot_values);
  return {};
}

bool Device::fires_at_once() const noexcept { return model_->phase_s <= kTimeTolerance_s; }

double Device::firings(double time_s) const noexcept {
  if (time_s < model_->phase_s - kTimeTolerance_s) return 0;
  return std::floor((time_s - model_->phase_s + kTimeTolerance_s) / model_->period_s) + 1;
}

bool Device::due(double begin_s, double now_s, double end_s) const noexcept {
  if (model_->period_s <= 0) return now_s == end_s && now_s >= model_->phase_s - kTimeTolerance_s;
  const double now = firings(now_s);
  return now > firings(begin_s) && now == firings(end_s);
}

bool Device::wants_before(double begin_s, double last_s, double end_s) const noexcept {
  if (sensor().follows()) return true;
  if (model_->period_s <= 0) return false;
  return firings(last_s) > firings(begin_s) && firings(last_s) == firings(end_s);
}

bool Device::faulty(double time_s) const noexcept {
  return model_->fault != Fault::None && time_s >= model_->fault_from_s - kTimeTolerance_s;
}

void Device::fire_faulty(Sensor& sensor, const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  const bool faulty = this->faulty(scene.time_s);
  const bool has_fired = std::isfinite(fired_s_);
  if (faulty && model_->fault == Fault::Dead) {
    sensor.broken(values);
  } else if (!faulty || !has_fired) {
    sensor.measure(scene, draws, values);
  }
}

}  // namespace ganglion::sim
