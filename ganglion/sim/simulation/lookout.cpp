#include "ganglion/sim/simulation/lookout.h"

#include <algorithm>

namespace ganglion::sim {
namespace {

constexpr std::size_t kNotCast = static_cast<std::size_t>(-1);
constexpr std::size_t kFewRays = 2;  // of one device: they share a group with those of other devices

/// So many rays of one device are a group, for which surfaces to the side are left out.
constexpr std::size_t kGroup = kLanePadding;

std::size_t rays_of(std::span<const Device> devices) noexcept {
  std::size_t rays = 0;
  for (const Device& device : devices) rays += device.sensor().rays().size();
  return rays;
}

std::size_t groups_of(std::span<const Device> devices) noexcept {
  std::size_t groups = 1;
  for (const Device& device : devices) groups += (device.sensor().rays().size() + kGroup - 1) / kGroup;
  return groups;
}

}  // namespace

Lookout::Lookout(const World& world, Neighbours& neighbours, const RobotModel& model, std::span<const Device> devices)
    : world_(&world),
      neighbours_(&neighbours),
      radius_m_(model.radius_m),
      fan_(rays_of(devices), groups_of(devices)),
      place_(devices.size(), kNotCast) {
  double spread_m = 0;
  for (const Device& device : devices) {
    reach_m_ = std::max(reach_m_, device.sensor().reach_m());
    spread_m = std::max(spread_m, device.model().mount.position.length());
  }
  const std::size_t robots = neighbours.discs().size();
  others_.reserve(robots);
  if (reach_m_ > 0) sight_ = std::make_unique<Sight>(world.shared_ground(), reach_m_, spread_m, robots);
}

void Lookout::begin(std::size_t robot, const Truth& truth, std::span<const Device> devices, std::uint32_t tick,
                    double time_s) noexcept {
  robot_ = robot;
  truth_ = &truth;
  devices_ = devices;
  tick_ = tick;
  time_s_ = time_s;
  heading_ = direction(truth.pose.yaw.rad());
  gathered_ = false;
  std::fill(place_.begin(), place_.end(), kNotCast);
}

void Lookout::gather() noexcept {
  if (gathered_) return;
  gathered_ = true;
  const Vector2 here = truth_->pose.position;
  sight_->look(*world_, here);
  others_.clear();
  for (const std::uint32_t other : neighbours_->within(here, reach_m_ + 2 * radius_m_, robot_)) {
    others_.push_back(neighbours_->discs()[other]);
    sight_->add_other(others_.back());
  }
}

void Lookout::cast(double begin_s, double end_s) noexcept {
  if (sight_ == nullptr) return;
  fan_.clear();
  auto add = [&](bool few) {
    for (std::size_t n = 0; n < devices_.size(); ++n) {
      const std::size_t rays = devices_[n].sensor().rays().size();
      if (rays > 0 && (rays <= kFewRays) == few && devices_[n].due(begin_s, time_s_, end_s)) add_rays(n);
    }
  };
  add(true);
  fan_.close_group(false);
  add(false);
  if (fan_.empty()) return;
  gather();
  sight_->cast(fan_);
}

void Lookout::add_rays(std::size_t n) noexcept {
  const Sensor& sensor = devices_[n].sensor();
  const Vector2 from = truth_->pose.position + turned(devices_[n].model().mount.position);
  const Vector2 ahead = turned(devices_[n].ahead());
  const double reach_m = sensor.reach_m();
  const std::span<const Vector2> rays = sensor.rays();
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const std::size_t place = fan_.add({from, ahead * rays[k].x + ahead.left() * rays[k].y}, reach_m);
    if (k == 0) place_[n] = place;
    const bool ends = (k + 1) % kGroup == 0 || k + 1 == rays.size();
    if (rays.size() > kFewRays && ends) fan_.close_group(true);
  }
}

Vector2 Lookout::turned(Vector2 on_robot) const noexcept {
  return heading_ * on_robot.x + heading_.left() * on_robot.y;
}

Scene Lookout::scene(std::size_t n) noexcept {
  const Device& device = devices_[n];
  const Pose2& mount = device.model().mount;
  if (device.sensor().reach_m() > 0) gather();
  Scene scene{.world = *world_,
              .robot = *truth_,
              .mount = {truth_->pose.position + turned(mount.position), (truth_->pose.yaw + mount.yaw).wrapped()},
              .ahead = turned(device.ahead()),
              .others = gathered_ ? std::span<const Disc>(others_) : std::span<const Disc>(),
              .radius_m = radius_m_,
              .tick = tick_,
              .time_s = time_s_,
              .sight = gathered_ ? sight_.get() : nullptr};
  if (place_[n] != kNotCast) scene.hits = {&fan_.hit(place_[n]), device.sensor().rays().size()};
  return scene;
}

}  // namespace ganglion::sim
