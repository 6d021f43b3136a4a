#pragma once

#include <span>
#include <vector>

#include "ganglion/sim/world/ray/lanes.h"
#include "ganglion/sim/world/ray/ray.h"

namespace ganglion::sim {

/// The rays of all sensors of a robot, laid out once in its own frame, in columns: several go through the processor
/// side by side. Groups of them are cast from wherever the robot stands.
class RayFan {
 public:
  /// Gives the ray's place in the fan. Surfaces at max_range_m > 0 itself count.
  std::size_t add(const Ray& on_robot, double max_range_m);
  /// The rays added since the last call are a group; gives its number. If they begin at one point, follow each other
  /// counter-clockwise and spread over less than half a turn (`wedge`), surfaces off their wedge are not looked at.
  std::size_t close_group(bool wedge);

  std::size_t groups() const noexcept { return groups_.size(); }
  /// How far the ray at that place went, once its group was cast; more than its longest where it met nothing.
  double range_m(std::size_t place) const noexcept { return range_m_[place]; }
  std::span<const double> ranges_m() const noexcept { return range_m_; }

 private:
  friend class Sight;
  struct Group {
    std::size_t first = 0;
    std::size_t count = 0;  ///< Pads excluded.
    bool wedge = false;
  };
  Ray ray(std::size_t at) const noexcept { return {{from_x_[at], from_y_[at]}, {along_x_[at], along_y_[at]}}; }
  AimColumns aims(const Group& group) const noexcept;
  RayColumns columns(const Group& group) noexcept;
  Wedge wedge(const Group& group) const noexcept;

  std::vector<double> mount_x_, mount_y_, bearing_x_, bearing_y_, limit_m_;   // on the robot
  std::vector<double> from_x_, from_y_, along_x_, along_y_, range_m_, name_;  // in the world
  std::vector<Hit> hits_;                                                     // of rays that were not cast in lanes
  std::vector<Group> groups_;
  std::size_t grouped_ = 0;  // places before this belong to groups
};

}  // namespace ganglion::sim
