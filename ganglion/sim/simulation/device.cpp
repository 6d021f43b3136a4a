#include "ganglion/sim/simulation/device.h"

#include <cmath>

#include "ganglion/base/hash.h"

namespace ganglion::sim {
namespace {

constexpr double kTimeTolerance_s = 1e-7;  // sums of steps differ from multiples of periods by rounding

}  // namespace

Device::Device(const SensorModel& model, std::unique_ptr<Sensor> sensor, std::span<double> values)
    : model_(&model),
      sensor_(std::move(sensor)),
      values_(values),
      name_hash_(hash_name(model.id)),
      channels_(model.kind->descriptor.ports.size()) {}

Result<void> Device::reset(const Scene& scene, const StreamId& stream) {
  draws_ = Draws(stream, 0);
  fired_s_ = -std::numeric_limits<double>::infinity();
  std::fill(values_.begin(), values_.end(), std::numeric_limits<double>::quiet_NaN());
  StreamId beginning = stream;
  beginning.component = combine(stream.component, hash_name("reset"));
  if (auto begun = sensor_->reset(scene, Draws(beginning, 0)); !begun) return begun;
  Draws first = draws(scene.tick);
  if (fires_at_once()) fire(scene, first);
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
  if (sensor_->follows()) return true;
  if (model_->period_s <= 0) return false;
  return firings(last_s) > firings(begin_s) && firings(last_s) == firings(end_s);
}

void Device::fire_faulty(const Scene& scene, Draws& draws) noexcept {
  const bool faulty = scene.time_s >= model_->fault_from_s - kTimeTolerance_s;
  const bool has_fired = std::isfinite(fired_s_);
  fired_s_ = scene.time_s;
  if (faulty && model_->fault == Fault::Dead) {
    sensor_->broken(values_);
  } else if (!faulty || !has_fired) {
    sensor_->measure(scene, draws, values_);
  }
}

}  // namespace ganglion::sim
