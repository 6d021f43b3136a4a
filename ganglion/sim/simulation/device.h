#pragma once

#include <memory>
#include <span>

#include "ganglion/sim/robot/robot_model.h"

namespace ganglion::sim {

/// A sensor at work: when it fires, what it read last, what a fault makes of it.
class Device {
 public:
  /// `values` and its age belong to the robot's frame-to-be and outlive the device.
  Device(const SensorModel& model, std::unique_ptr<Sensor> sensor, std::span<double> values);

  /// An episode begins: `stream` is the sensor's own source of chance. Fires if it is due at once.
  Result<void> reset(const Scene& scene, const StreamId& stream);
  /// A sub-step of that length has gone by, for devices that follow().
  void follow(const Scene& scene, double substep_s) noexcept { sensor_->follow(scene, substep_s); }
  /// What a reading at a tick may draw.
  Draws draws(std::uint32_t tick) const noexcept { return draws_.at(tick); }
  /// It is due: takes a reading with those draws, or what its fault makes of it.
  void fire(const Scene& scene, Draws& draws) noexcept {
    if (model_->fault != Fault::None) return fire_faulty(scene, draws);
    fired_s_ = scene.time_s;
    sensor_->measure(scene, draws, values_);
  }
  void hear(const ActFrame& frame) noexcept { sensor_->hear(frame); }
  double age_s(double time_s) const noexcept { return time_s - fired_s_; }

  /// Whether it fires as an episode begins.
  bool fires_at_once() const noexcept;
  /// Whether it fires at the end of the sub-step from begin_s to now_s; the step it belongs to ends at end_s, and no
  /// firing before the step's last one would be seen.
  bool due(double begin_s, double now_s, double end_s) const noexcept;
  /// Whether it would have anything to do in the sub-steps of [begin_s, last_s), of the step that ends at end_s.
  bool wants_before(double begin_s, double last_s, double end_s) const noexcept;
  std::uint64_t name_hash() const noexcept { return name_hash_; }
  std::size_t channels() const noexcept { return channels_; }

  const SensorModel& model() const noexcept { return *model_; }
  const Sensor& sensor() const noexcept { return *sensor_; }

 private:
  double firings(double time_s) const noexcept;
  void fire_faulty(const Scene& scene, Draws& draws) noexcept;

  const SensorModel* model_;
  std::unique_ptr<Sensor> sensor_;
  std::span<double> values_;
  std::uint64_t name_hash_;
  std::size_t channels_;
  Draws draws_{{}, 0};  // its stream's at tick 0
  double fired_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace ganglion::sim
