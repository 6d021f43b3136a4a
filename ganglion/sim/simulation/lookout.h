#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ganglion/sim/simulation/device.h"
#include "ganglion/sim/simulation/neighbours.h"
#include "ganglion/sim/world/sight.h"

namespace ganglion::sim {

/// What the devices of one robot after the other have before them: their scenes, and the rays of all that fire at once,
/// cast together. What the robot sees is gathered only if somebody looks.
class Lookout {
 public:
  /// For robots of one model; `devices` are those of any. World and neighbours must outlive it. Takes all its memory.
  Lookout(const World& world, Neighbours& neighbours, const RobotModel& model, std::span<const Device> devices);

  /// Turns to a robot and its devices.
  void begin(std::size_t robot, const Truth& truth, std::span<const Device> devices, std::uint32_t tick,
             double time_s) noexcept;
  /// Casts the rays of those devices that fire at the end of this sub-step.
  void cast(double begin_s, double end_s) noexcept;
  /// The scene of this robot's n-th device; valid until the next begin().
  Scene scene(std::size_t n) noexcept;

 private:
  void gather() noexcept;
  Vector2 turned(Vector2 on_robot) const noexcept;
  void add_rays(std::size_t n) noexcept;

  const World* world_;
  Neighbours* neighbours_;
  double radius_m_;
  double reach_m_ = 0;  // of the farthest-seeing device
  std::unique_ptr<Sight> sight_;  // if any sees at all
  RayFan fan_;
  std::vector<std::size_t> place_;  // in the fan, of each device's first ray
  std::vector<Disc> others_;
  std::span<const Device> devices_;
  const Truth* truth_ = nullptr;
  std::size_t robot_ = 0;
  std::uint32_t tick_ = 0;
  double time_s_ = 0;
  Vector2 heading_;  // of the robot, a unit vector
  bool gathered_ = false;
};

}  // namespace ganglion::sim
