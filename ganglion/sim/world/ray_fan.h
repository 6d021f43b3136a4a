#pragma once

#include <vector>

#include "ganglion/sim/world/lanes.h"
#include "ganglion/sim/world/ray.h"

namespace ganglion::sim {

/// Rays that are cast together, in columns: several go through the processor side by side.
class RayFan {
 public:
  /// Takes the memory for so many rays in so many groups.
  explicit RayFan(std::size_t rays = 0, std::size_t groups = 0);

  bool empty() const noexcept { return groups_ == 0; }
  void clear() noexcept { count_ = groups_ = 0; }
  /// Gives the ray's place in the fan. There must be room. Surfaces at max_range_m itself count.
  std::size_t add(const Ray& ray, double max_range_m) noexcept;
  /// The rays added since the last call are a group. If they begin at one point, follow each other counter-clockwise
  /// and spread over less than half a turn (`wedge`), surfaces off their wedge are not looked at.
  void close_group(bool wedge) noexcept;

  /// What the ray at that place met first, once the fan was cast; range_m is +inf where there is nothing.
  const Hit& hit(std::size_t place) const noexcept { return hits_[place]; }

 private:
  friend class Sight;
  struct Group {
    std::size_t first = 0;
    std::size_t count = 0;  ///< Pads excluded.
    bool wedge = false;
  };
  Ray ray(std::size_t at) const noexcept { return {{from_x_[at], from_y_[at]}, {along_x_[at], along_y_[at]}}; }
  RayColumns columns(const Group& group) noexcept;
  Wedge wedge(const Group& group) const noexcept;

  std::vector<double> from_x_, from_y_, along_x_, along_y_, range_m_, name_;
  std::vector<Hit> hits_;
  std::vector<Group> group_;
  std::size_t count_ = 0;
  std::size_t groups_ = 0;
};

}  // namespace ganglion::sim
