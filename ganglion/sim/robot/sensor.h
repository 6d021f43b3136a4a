#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "ganglion/application/application.h"
#include "ganglion/module/component.h"
#include "ganglion/random/draws.h"
#include "ganglion/sim/robot/truth.h"
#include "ganglion/sim/world/world.h"

namespace ganglion::sim {

class TrainerLog;

/// All that a sensor may look at.
struct Scene {
  const World& world;
  const Truth& robot;            ///< The robot that carries it.
  Pose2 mount{};                 ///< The sensor's own pose in the world.
  std::span<const Disc> others;  ///< The other robots near enough to matter, ordered by index.
  double radius_m = 0;           ///< Of the robot's own disc.
  std::uint32_t tick = 0;
  double time_s = 0;
};

/// The first surface along a ray, other robots (rough) included. None within max_range_m.
std::optional<Hit> cast(const Scene& scene, Vector2 from, Vector2 unit_direction, double max_range_m) noexcept;

struct Limits {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

/// A device on a simulated robot: a function of the scene, of its own inertia and of the draws it is given.
/// Takes no memory after reset().
class Sensor {
 public:
  Sensor() = default;
  Sensor(const Sensor&) = delete;
  Sensor& operator=(const Sensor&) = delete;
  virtual ~Sensor() = default;

  /// Between what the finite values of the n-th channel lie.
  virtual Limits limits(std::size_t channel) const noexcept = 0;
  /// How far it sees other robots; 0 = not at all.
  virtual double reach_m() const noexcept { return 0; }
  /// An episode begins. Fails where the scene makes no sense to it.
  virtual Result<void> reset(const Scene&, Draws) { return {}; }
  /// Whether it wants to be told how time goes by between firings.
  virtual bool follows() const noexcept { return false; }
  /// A sub-step has gone by: for devices with inertia.
  virtual void follow(const Scene&, double step_s) noexcept { static_cast<void>(step_s); }
  /// What the controller commanded; the device may listen (a trainer does).
  virtual void hear(const ActFrame&) noexcept {}
  /// Fires. `values` has the values of all channels, one after the other; missing readings after REP-117.
  virtual void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept = 0;
  /// What comes out once the device is broken: NaN unless the kind knows better.
  virtual void broken(std::span<double> values) const noexcept {
    std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
  }
  /// What it keeps of its goals, if it is a trainer.
  virtual const TrainerLog* trainer_log() const noexcept { return nullptr; }
};

/// A kind's descriptor lists the channels as its Output ports.
using SensorKind = Kind<Sensor>;

}  // namespace ganglion::sim
