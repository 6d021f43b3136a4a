#include "ganglion/sim/world/ray/ray_fan.h"

#include "ganglion/base/expects.h"

namespace ganglion::sim {

std::size_t RayFan::add(const Ray& on_robot, double max_range_m) {
  expects(max_range_m > 0);
  mount_x_.push_back(on_robot.from.x);
  mount_y_.push_back(on_robot.from.y);
  bearing_x_.push_back(on_robot.direction.x);
  bearing_y_.push_back(on_robot.direction.y);
  limit_m_.push_back(next_above(max_range_m));
  return mount_x_.size() - 1;
}

std::size_t RayFan::close_group(bool wedge) {
  const std::size_t count = mount_x_.size() - grouped_;
  expects(count > 0);
  // A wedge of half a turn or more has its left edge to the right of its right one.
  const std::size_t last = mount_x_.size() - 1;
  const double spread = bearing_x_[grouped_] * bearing_y_[last] - bearing_y_[grouped_] * bearing_x_[last];
  groups_.push_back({grouped_, count, wedge && count > 1 && spread > 0});
  grouped_ = padded(mount_x_.size());
  for (auto* column : {&mount_x_, &mount_y_, &bearing_x_, &bearing_y_, &limit_m_}) {
    column->resize(grouped_, column->back());
  }
  for (auto* column : {&from_x_, &from_y_, &along_x_, &along_y_, &range_m_, &name_}) column->resize(grouped_);
  hits_.resize(grouped_);
  return groups_.size() - 1;
}

AimColumns RayFan::aims(const Group& group) const noexcept {
  const std::size_t at = group.first;
  return {&mount_x_[at], &mount_y_[at], &bearing_x_[at], &bearing_y_[at], &limit_m_[at]};
}

RayColumns RayFan::columns(const Group& group) noexcept {
  const std::size_t at = group.first;
  return {&from_x_[at], &from_y_[at], &along_x_[at], &along_y_[at], &range_m_[at], &name_[at], group.count};
}

Wedge RayFan::wedge(const Group& group) const noexcept {
  const std::size_t first = group.first, last = group.first + group.count - 1;
  return {from_x_[first], from_y_[first], along_x_[first], along_y_[first], along_x_[last], along_y_[last]};
}

}  // namespace ganglion::sim
