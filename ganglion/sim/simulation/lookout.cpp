#include "ganglion/sim/simulation/lookout.h"

#include <algorithm>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr std::size_t kFewRays = 2;  // of one device: they share a group with those of other devices

constexpr double kTouch = 4;  // radii: within one step two robots come from so far off to touch, as a rule

/// So many rays of one device are a group, for which surfaces to the side are left out.
constexpr std::size_t kGroup = kLanePadding;

}  // namespace

Lookout::Lookout(const World& world, Neighbours& neighbours, std::size_t robots, const RobotModel& model,
                 std::span<const Device> devices)
    : world_(&world), neighbours_(&neighbours), radius_m_(model.radius_m), cast_(devices.size()) {
  double spread_m = 0;
  for (const Device& device : devices) {
    const Pose2& mount = device.model().mount;
    const double reach_m = device.sensor().reach_m();
    reach_m_ = std::max(reach_m_, reach_m);
    spread_m = std::max(spread_m, mount.position.length());
    posts_.push_back({.mounting = {mount, direction(mount.yaw.rad())}, .sees = reach_m > 0});
  }
  lay_out(devices, true);
  lay_out(devices, false);
  group_called_.resize(fan_.groups());
  calls_.reserve(devices.size());
  rays_.reserve(devices.size());
  pings_.reserve(devices.size());
  far_m_ = reach_m_ + 2 * radius_m_;
  neighbours.make_room(robots, kTouch * radius_m_, std::max(far_m_, kTouch * radius_m_));
  others_.reserve(robots);
  if (reach_m_ > 0) sight_ = std::make_unique<Sight>(world.shared_ground(), reach_m_, spread_m, robots);
}

/// Devices with few rays share one group, others have groups of their own.
void Lookout::lay_out(std::span<const Device> devices, bool few) {
  const std::size_t shared = fan_.groups();
  bool open = false;
  for (std::size_t n = 0; n < devices.size(); ++n) {
    const std::span<const Vector2> rays = devices[n].sensor().rays();
    if (rays.empty() || (rays.size() <= kFewRays) != few) continue;
    Post& post = posts_[n];
    post.rays = rays.size();
    post.first_group = fan_.groups();
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const Vector2 along = post.mounting.ahead * rays[k].x + post.mounting.ahead.left() * rays[k].y;
      const std::size_t place = fan_.add({post.mounting.pose.position, along}, devices[n].sensor().reach_m());
      if (k == 0) post.place = place;
      if (!few && ((k + 1) % kGroup == 0 || k + 1 == rays.size())) fan_.close_group(true);
    }
    post.end_group = few ? shared + 1 : fan_.groups();
    open = open || few;
  }
  if (open) fan_.close_group(false);
}

std::span<const Lookout::Call> Lookout::call(std::span<const Device> devices, double begin_s, double now_s,
                                             double end_s) noexcept {
  forget_calls();
  for (std::size_t n = 0; n < devices.size(); ++n) {
    const Device& device = devices[n];
    const bool fires = device.due(begin_s, now_s, end_s);
    if (fires && posts_[n].rays > 0) {
      cast_[n] = CastRays(*sight_, fan_, posts_[n].place);
      for (std::size_t g = posts_[n].first_group; g < posts_[n].end_group; ++g) group_called_[g] = true;
    }
    if (const auto ranging = device.ranging(); fires && ranging) {
      rays_.push_back({n, posts_[n].place, device.offset(), *ranging});
      continue;
    }
    const bool follows = device.sensor().follows();
    if (fires || follows) calls_.push_back({n, fires, follows, fires && device.sensor().draws_normal()});
    if (fires) ping(device, n);
  }
  return calls_;
}

void Lookout::read_rays(std::span<double> values) const noexcept {
  const double* range_m = fan_.ranges_m().data();
  double* value = values.data();
  for (const Ray& ray : std::span(rays_)) value[ray.value] = ray.ranging.reading_m(range_m[ray.place]);
}

void Lookout::call_first(std::span<const Device> devices) noexcept {
  forget_calls();
  for (std::size_t n = 0; n < devices.size(); ++n) {
    if (devices[n].fires_at_once()) ping(devices[n], n);
  }
}

void Lookout::ping(const Device& device, std::size_t n) noexcept {
  if (const auto cone = device.sensor().ping_cos_half_cone()) pings_.push_back({&posts_[n].mounting, *cone});
}

void Lookout::forget_calls() noexcept {
  calls_.clear();
  rays_.clear();
  pings_.clear();
  std::fill(cast_.begin(), cast_.end(), CastRays());
  std::fill(group_called_.begin(), group_called_.end(), false);
}

void Lookout::begin(std::size_t robot, const Body& body, std::uint32_t tick, double time_s) noexcept {
  robot_ = robot;
  gathered_ = false;
  scene_.emplace(Scene{.world = *world_,
                       .robot = body.truth(),
                       .heading = body.ahead(),
                       .others = {},
                       .radius_m = radius_m_,
                       .tick = tick,
                       .time_s = time_s,
                       .pings = pings_});
  for (std::size_t g = 0; g < group_called_.size(); ++g) {
    if (!group_called_[g]) continue;
    if (!gathered_) gather();
    sight_->cast(fan_, g, scene_->robot.pose.position, scene_->heading);
  }
}

void Lookout::gather() noexcept {
  gathered_ = true;
  const Vector2 here = scene_->robot.pose.position;
  const auto near = neighbours_->within(here, far_m_, robot_);
  if (others_.size() < near.size()) others_.resize(near.size());  // within what is reserved
  double nearest = far_m_ * far_m_;
  const Disc* discs = neighbours_->discs().data();
  Disc* other = others_.data();
  for (const std::uint32_t robot : near) {
    *other = discs[robot];
    nearest = std::min(nearest, (other++->position - here).squared());
  }
  scene_->others = std::span(others_).first(near.size());
  sight_->look(*world_, here, scene_->others);
  alone_m_ = std::sqrt(nearest);
  scene_->sight = sight_.get();
}

}  // namespace ganglion::sim
