#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ganglion/sim/simulation/body.h"
#include "ganglion/sim/simulation/device.h"
#include "ganglion/sim/simulation/neighbours.h"
#include "ganglion/sim/world/sight.h"

namespace ganglion::sim {

/// What the devices of one robot after the other have before them: their scenes, and the rays of all that fire at once,
/// cast together. What a robot sees is gathered only if somebody looks.
class Lookout {
 public:
  /// For robots of one model, whose devices these are. World and neighbours must outlive it. Takes all its memory
  /// and that of the neighbours.
  Lookout(const World& world, Neighbours& neighbours, std::size_t robots, const RobotModel& model,
          std::span<const Device> devices);

  /// A device that has to do in a sub-step.
  struct Call {
    std::size_t device = 0;  ///< Its number on the robot.
    bool fires = false;
    bool follows = false;
    bool draws_normal = false;  ///< First, when it fires.
  };
  /// An ideal ranger that fires: its ray is read beside others.
  struct Ray {
    std::size_t device = 0;
    std::size_t place = 0;  ///< In the fan.
    std::size_t value = 0;  ///< Among the robot's.
    Ranging ranging{};
  };
  /// Finds out which devices have to do in the sub-step from begin_s to now_s, of a step that ends at end_s; it is the
  /// same for all robots. Ideal rangers are not among them: see rays().
  std::span<const Call> call(std::span<const Device> devices, double begin_s, double now_s, double end_s) noexcept;
  /// An episode begins: nobody's rays are cast beforehand, though all get their scenes and those that fire at once
  /// ping.
  void call_first(std::span<const Device> devices) noexcept;
  /// Turns to a robot and casts the rays of its devices that fire.
  void begin(std::size_t robot, const Body& body, std::uint32_t tick, double time_s) noexcept;
  /// The ideal rangers that fire, as call() found them.
  std::span<const Ray> rays() const noexcept { return rays_; }
  /// Their readings, put in their places among the robot's values.
  void read_rays(std::span<double> values) const noexcept;
  /// No other robot's centre is nearer to that of this one; 0 where nobody looked.
  double alone_m() const noexcept { return gathered_ ? alone_m_ : 0; }
  /// The scene of that robot's n-th device; valid until the next call.
  const Scene& scene(std::size_t n) noexcept {
    if (posts_[n].sees && !gathered_) gather();
    scene_->mounting = &posts_[n].mounting;
    scene_->rays = cast_[n];
    return *scene_;
  }

 private:
  /// What is fixed of a device.
  struct Post {
    Mounting mounting;
    std::size_t place = 0;  ///< Of its first ray in the fan.
    std::size_t rays = 0;
    std::size_t first_group = 0;
    std::size_t end_group = 0;
    bool sees = false;
  };
  void lay_out(std::span<const Device> devices, bool few);
  void gather() noexcept;
  void forget_calls() noexcept;
  void ping(const Device& device, std::size_t n) noexcept;

  const World* world_;
  Neighbours* neighbours_;
  double radius_m_;
  double reach_m_ = 0;            // of the farthest-seeing device
  double far_m_ = 0;              // other robots nearer than this matter
  std::unique_ptr<Sight> sight_;  // if any sees at all
  RayFan fan_;
  std::vector<Post> posts_;
  std::vector<Call> calls_;
  std::vector<Ray> rays_;
  std::vector<CastRays> cast_;  // by device: its rays, if they are
  std::vector<char> group_called_;
  std::vector<Ping> pings_;
  std::vector<Disc> others_;
  std::optional<Scene> scene_;
  std::size_t robot_ = 0;
  bool gathered_ = false;
  double alone_m_ = 0;
};

}  // namespace ganglion::sim
