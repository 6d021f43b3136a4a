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
#include "ganglion/sim/world/sight.h"

namespace ganglion::sim {

/// Where a sensor sits on its robot.
struct Mounting {
  Pose2 pose{};
  Vector2 ahead{1, 0};  ///< The unit vector of its yaw.
};
inline constexpr Mounting kCentred{};

/// A ping of the same robot, sent while a sensor listens.
struct Ping {
  const Mounting* mounting = &kCentred;  ///< Of the sensor that sends it.
  double cos_half_cone = 1;
};

/// Rays of a sensor that were cast beforehand, as long as nobody looks elsewhere.
class CastRays {
 public:
  CastRays() = default;
  CastRays(const Sight& sight, const RayFan& fan, std::size_t first) noexcept
      : sight_(&sight), fan_(&fan), first_(first) {}
  bool empty() const noexcept { return fan_ == nullptr; }
  double range_m(std::size_t n) const noexcept { return fan_->range_m(first_ + n); }
  Hit hit(std::size_t n) const noexcept { return sight_->hit(*fan_, first_ + n); }
  /// Of a ray that met something.
  Sight::Incidence incidence(std::size_t n) const noexcept { return sight_->incidence(*fan_, first_ + n); }

 private:
  const Sight* sight_ = nullptr;
  const RayFan* fan_ = nullptr;
  std::size_t first_ = 0;
};

/// All that a sensor may look at.
struct Scene {
  const World& world;
  const Truth& robot;                    ///< The robot that carries it.
  Vector2 heading{1, 0};                 ///< The unit vector of the robot's yaw.
  const Mounting* mounting = &kCentred;  ///< Of the sensor on the robot.
  std::span<const Disc> others;          ///< The other robots near enough to matter, ordered by index.
  double radius_m = 0;                   ///< Of the robot's own disc.
  std::uint32_t tick = 0;
  double time_s = 0;
  CastRays rays{};                ///< The sensor's rays(), where they were cast beforehand.
  std::span<const Ping> pings{};  ///< Sent by sensors of the robot that fire now, its own among them.
  Sight* sight = nullptr;         ///< What the robot sees, gathered beforehand: the same as `world` and `others` hold.

  /// A vector given in the robot's frame, in the world's.
  Vector2 turned(Vector2 on_robot) const noexcept { return heading * on_robot.x + heading.left() * on_robot.y; }
  /// The sensor's own pose in the world, and the unit vector of its yaw.
  Pose2 mount() const noexcept {
    return {robot.pose.position + turned(mounting->pose.position), (robot.pose.yaw + mounting->pose.yaw).wrapped()};
  }
  Vector2 ahead() const noexcept { return turned(mounting->ahead); }
};

/// The first surface along a ray, other robots (rough, and not seen from within) included. None within max_range_m.
std::optional<Hit> cast(const Scene& scene, Vector2 from, Vector2 unit_direction, double max_range_m) noexcept;

/// What a ray of a sensor, a unit vector in its own frame, meets first. range_m is +inf where nothing is within
/// reach_m.
Hit cast_own(const Scene& scene, Vector2 ray, double reach_m) noexcept;
/// The same of ray `n` of its rays(), which may be cast already.
inline Hit first_hit(const Scene& scene, Vector2 ray, std::size_t n, double reach_m) noexcept {
  return scene.rays.empty() ? cast_own(scene, ray, reach_m) : scene.rays.hit(n);
}
/// Only how far it goes; more than reach_m where it meets nothing.
inline double first_range_m(const Scene& scene, Vector2 ray, std::size_t n, double reach_m) noexcept {
  return scene.rays.empty() ? cast_own(scene, ray, reach_m).range_m : scene.rays.range_m(n);
}

/// The reading of an ideal ranger: how far its only ray goes.
struct Ranging {
  double min_m = 0;  ///< What is nearer is too close: -inf.
  double max_m = 0;  ///< What is farther is not seen: +inf.

  double reading_m(double range_m) const noexcept {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double seen_m = range_m <= max_m ? range_m : kInfinity;
    return range_m < min_m ? -kInfinity : seen_m;
  }
};

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

  /// Whether a reading depends on what came before it. One that does not serves all robots of its model.
  virtual bool remembers() const noexcept { return true; }
  /// Between what the finite values of the n-th channel lie.
  virtual Limits limits(std::size_t channel) const noexcept = 0;
  /// What a full turn counts in that channel: see SensationChannel::turn.
  virtual double turn(std::size_t channel) const noexcept {
    static_cast<void>(channel);
    return 0;
  }
  /// The rays it casts whenever it fires, from its mount and up to reach_m(): unit vectors in its own frame, in the
  /// order of their bearings counter-clockwise. They are cast together with those of other sensors: see first_hit().
  virtual std::span<const Vector2> rays() const noexcept { return {}; }
  /// How far it sees; 0 = not at all. Rays that it casts itself, ways there included, end no farther off either.
  virtual double reach_m() const noexcept { return 0; }
  /// If all it does is to give the range of its only ray: those of a robot are read together, measure() is not called.
  virtual std::optional<Ranging> ranging() const noexcept { return std::nullopt; }
  /// Cosine of half the cone of what it sends when it fires; none if it only listens.
  virtual std::optional<double> ping_cos_half_cone() const noexcept { return std::nullopt; }
  /// An episode begins. Fails where the scene makes no sense to it.
  virtual Result<void> reset(const Scene&, Draws) { return {}; }
  /// Whether it wants to be told how time goes by between firings.
  virtual bool follows() const noexcept { return false; }
  /// A sub-step has gone by: for devices with inertia.
  virtual void follow(const Scene&, double step_s) noexcept { static_cast<void>(step_s); }
  /// Fires. `values` has the values of all channels, one after the other; missing readings after REP-117.
  virtual void measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept = 0;
  /// Whether measure() begins by draws.normal(). Those of many sensors are worked out side by side then; the same bits.
  virtual bool draws_normal() const noexcept { return false; }
  /// What comes out once the device is broken: NaN unless the kind knows better.
  virtual void broken(std::span<double> values) const noexcept {
    std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
  }
};

/// A kind's descriptor lists the channels as its Output ports.
using SensorKind = Kind<Sensor>;

}  // namespace ganglion::sim
