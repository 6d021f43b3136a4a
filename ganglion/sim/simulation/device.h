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
  /// A sub-step has gone by, from begin_s to scene.time_s; the step it belongs to ends at end_s, and no firing before
  /// the step's last one would be seen.
  void follow(const Scene& scene, double begin_s, double end_s) noexcept;
  void hear(const ActFrame& frame) noexcept { sensor_->hear(frame); }
  double age_s(double time_s) const noexcept { return time_s - fired_s_; }

  /// Whether it fires at the end of that sub-step.
  bool due(double begin_s, double now_s, double end_s) const noexcept;
  /// Whether it would have anything to do in the sub-steps of [begin_s, last_s), of the step that ends at end_s.
  bool wants_before(double begin_s, double last_s, double end_s) const noexcept;
  std::uint64_t name_hash() const noexcept { return name_hash_; }
  /// Unit vector of the mount's yaw on the robot.
  Vector2 ahead() const noexcept { return ahead_; }

  const SensorModel& model() const noexcept { return *model_; }
  const Sensor& sensor() const noexcept { return *sensor_; }
  /// Whether follow() would do anything for that sub-step: a scene is not made in vain.
  bool wants(double begin_s, double now_s, double end_s) const noexcept;

 private:
  double firings(double time_s) const noexcept;
  void fire(const Scene& scene) noexcept;

  const SensorModel* model_;
  std::unique_ptr<Sensor> sensor_;
  std::span<double> values_;
  Vector2 ahead_;
  std::uint64_t name_hash_;
  StreamId stream_{};
  double fired_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace ganglion::sim
