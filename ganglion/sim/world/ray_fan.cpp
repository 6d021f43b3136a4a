#include "ganglion/sim/world/ray_fan.h"

#include "ganglion/base/expects.h"

namespace ganglion::sim {
RayFan::RayFan(std::size_t rays, std::size_t groups) : group_(groups) {
  const std::size_t room = rays + groups * kLanePadding;
  for (auto* column : {&from_x_, &from_y_, &along_x_, &along_y_, &range_m_, &name_}) column->resize(room);
  hits_.resize(room);
}

std::size_t RayFan::add(const Ray& ray, double max_range_m) noexcept {
  expects(count_ < hits_.size());
  from_x_[count_] = ray.from.x;
  from_y_[count_] = ray.from.y;
  along_x_[count_] = ray.direction.x;
  along_y_[count_] = ray.direction.y;
  range_m_[count_] = max_range_m > 0 ? next_above(max_range_m) : 0;
  name_[count_] = -1;
  return count_++;
}

void RayFan::close_group(bool wedge) noexcept {
  const std::size_t first = groups_ == 0 ? 0 : padded(group_[groups_ - 1].first + group_[groups_ - 1].count);
  if (count_ == first) return;
  expects(groups_ < group_.size());
  group_[groups_++] = {first, count_ - first, wedge};
  const std::size_t last = count_ - 1, end = padded(count_);
  while (count_ < end) add(ray(last), 0);
}

RayColumns RayFan::columns(const Group& group) noexcept {
  const std::size_t at = group.first;
  return {&from_x_[at], &from_y_[at], &along_x_[at], &along_y_[at], &range_m_[at], &name_[at], group.count};
}

Wedge RayFan::wedge(const Group& group) const noexcept {
  const std::size_t first = group.first, last = group.first + group.count - 1;
  return {from_x_[first],  from_y_[first], along_x_[first], along_y_[first], along_x_[last], along_y_[last]};
}

}  // namespace ganglion::sim
