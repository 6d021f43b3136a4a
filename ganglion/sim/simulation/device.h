#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ganglion/sim/robot/robot_model.h"

namespace ganglion::sim {

/// A sensor of the model at work on all robots: when it fires, what it reads, what a fault makes of it. The robots
/// share its times, and those sensors that remember nothing are one for all of them.
class Device {
 public:
  /// `offset`: of its values among those of a robot. Fails as the sensor's kind does.
  static Result<Device> make(const SensorModel& model, std::size_t robots, std::size_t offset);

  /// An episode begins: chance comes from streams of that seed and episode.
  void reset(std::uint64_t seed, std::uint32_t episode) noexcept;
  /// The same for one robot's sensor. Fires if it is due at once.
  Result<void> reset(std::size_t robot, const Scene& scene, std::span<double> robot_values);
  /// A sub-step of that length has gone by, for devices that follow().
  void follow(std::size_t robot, const Scene& scene, double substep_s) noexcept {
    sensor(robot).follow(scene, substep_s);
  }
  /// What a robot's reading at a tick may draw.
  Draws draws(std::size_t robot, std::uint32_t tick) const noexcept {
    return draws_.at(static_cast<std::uint32_t>(robot), tick);
  }
  /// It is due: takes a robot's reading with those draws, or what its fault makes of it.
  void fire(std::size_t robot, const Scene& scene, Draws& draws, std::span<double> robot_values) noexcept {
    const auto values = robot_values.subspan(offset_, size_);
    if (model_->fault != Fault::None) return fire_faulty(sensor(robot), scene, draws, values);
    sensor(robot).measure(scene, draws, values);
  }
  /// All robots' have fired.
  void fired(double time_s) noexcept { fired_s_ = time_s; }
  double age_s(double time_s) const noexcept { return time_s - fired_s_; }

  /// Whether it fires as an episode begins.
  bool fires_at_once() const noexcept;
  /// Whether it fires at the end of the sub-step from begin_s to now_s; the step it belongs to ends at end_s, and no
  /// firing before the step's last one would be seen.
  bool due(double begin_s, double now_s, double end_s) const noexcept;
  /// Whether it would have anything to do in the sub-steps of [begin_s, last_s), of the step that ends at end_s.
  bool wants_before(double begin_s, double last_s, double end_s) const noexcept;
  /// See Sensor::ranging(); none where a fault may spoil the reading.
  std::optional<Ranging> ranging() const noexcept {
    return model_->fault == Fault::None ? sensor().ranging() : std::nullopt;
  }
  /// Its first value among those of a robot, and how many they are.
  std::size_t offset() const noexcept { return offset_; }
  std::size_t size() const noexcept { return size_; }
  std::size_t channels() const noexcept { return model_->kind->descriptor.ports.size(); }

  const SensorModel& model() const noexcept { return *model_; }
  const Sensor& sensor(std::size_t robot = 0) const noexcept { return *sensors_[shared_ ? 0 : robot]; }

 private:
  Device(const SensorModel& model, std::size_t offset);
  Sensor& sensor(std::size_t robot) noexcept { return *sensors_[shared_ ? 0 : robot]; }
  double firings(double time_s) const noexcept;
  bool faulty(double time_s) const noexcept;
  void fire_faulty(Sensor& sensor, const Scene& scene, Draws& draws, std::span<double> values) noexcept;

  const SensorModel* model_;
  std::vector<std::unique_ptr<Sensor>> sensors_;  // of each robot, or one for all
  bool shared_ = false;
  std::size_t offset_;
  std::size_t size_ = 0;
  std::uint64_t name_hash_;
  StreamId stream_{};   // of the first robot's
  Draws draws_{{}, 0};  // the same at tick 0
  double fired_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace ganglion::sim
