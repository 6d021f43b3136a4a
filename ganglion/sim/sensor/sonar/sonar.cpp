#include "ganglion/sim/sensor/sonar/sonar.h"

#include <cmath>

#include "ganglion/math/functions.h"

namespace ganglion::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLiftOff_m = 1e-6;  // a mirrored ray starts this far from the surface, so as not to meet it again

double rounded(double value, double resolution) noexcept {
  return resolution > 0 ? std::floor(value / resolution + 0.5) * resolution : value;
}

}  // namespace

Sonar::Sonar(const SonarConfig& config) : config_(config) {
  for (int n = 0; n < config.rays; ++n) {
    const double share = config.rays == 1 ? 0 : static_cast<double>(n) / (config.rays - 1) - 0.5;
    rays_.push_back(direction(share * config.cone.rad()));
    ray_reach_m_.push_back(config.fading ? config.max_range_m * math::pow(2, -2 * share * share) : kInfinity);
  }
  cos_half_cone_ = math::cos(config.cone.rad() / 2);
  for (std::size_t i = 0; i < cos_incidence_.size(); ++i) {
    const double limit_rad = config.incidence_limit[i].rad();
    cos_incidence_[i] = limit_rad < kPi / 2 ? math::cos(limit_rad) : 0;
  }
}

Limits Sonar::limits(std::size_t channel) const noexcept {
  if (channel == 0) return {config_.min_range_m, config_.max_range_m};
  return {0, std::max(config_.no_echo_s, 2 * config_.max_range_m / speed_of_sound_mps(config_.air_C))};
}

bool Sonar::answers(const Sight::Incidence& met, double way_m) const noexcept {
  if (met.material == Material::Soft && way_m > config_.soft_range * config_.max_range_m) return false;
  return met.cosine >= cos_incidence_[static_cast<std::size_t>(met.material)];
}

double Sonar::way_m(const Scene& scene, const Ray& axis, std::size_t n, double within_m) const noexcept {
  if (!scene.rays.empty()) {
    const double range_m = scene.rays.range_m(n);
    if (!(range_m < within_m && range_m <= config_.max_range_m)) return kInfinity;
    if (answers(scene.rays.incidence(n), range_m)) return range_m;
    if (config_.mirror_bounces == 0) return kInfinity;
  }
  Vector2 from = axis.from;
  Vector2 along = axis.direction * rays_[n].x + axis.direction.left() * rays_[n].y;
  Hit hit = first_hit(scene, rays_[n], n, config_.max_range_m);
  double way_m = hit.range_m;
  for (int bounce = 0; way_m < within_m; ++bounce) {
    if (answers(hit, along, way_m)) return way_m;
    if (bounce == config_.mirror_bounces) break;
    from = from + along * hit.range_m + hit.normal * kLiftOff_m;
    along = along - hit.normal * (2 * hit.normal.dot(along));
    const auto next = cast(scene, from, along, std::min(config_.max_range_m, within_m) - way_m);
    if (!next) break;
    hit = *next;
    way_m += hit.range_m;
  }
  return kInfinity;
}

double Sonar::echo_range_m(const Scene& scene) const noexcept {
  const Ray axis{scene.robot.pose.position + scene.turned(scene.mounting->pose.position), scene.ahead()};
  double nearest_m = kInfinity;
  for (std::size_t n = 0; n < rays_.size(); ++n) {
    nearest_m = std::min(nearest_m, way_m(scene, axis, n, std::min(nearest_m, ray_reach_m_[n])));
  }
  return nearest_m;
}

double Sonar::crosstalk_m(const Scene& scene, double within_m) const noexcept {
  const Vector2 here = scene.mount().position;
  double nearest_m = within_m;
  for (const Ping& ping : scene.pings) {
    if (ping.mounting == scene.mounting) continue;
    const Vector2 from = scene.robot.pose.position + scene.turned(ping.mounting->pose.position);
    const Vector2 axis = scene.turned(ping.mounting->ahead);
    for (const Vector2 ray : rays_) {
      const Vector2 along = scene.ahead() * ray.x + scene.ahead().left() * ray.y;
      const Hit hit = cast_own(scene, ray, config_.max_range_m);
      if (hit.range_m == kInfinity) continue;
      const Vector2 out = here + along * hit.range_m + hit.normal * kLiftOff_m - from;
      const double out_m = out.length();
      const double half_m = (out_m + hit.range_m) / 2;
      if (!(half_m < nearest_m) || out.dot(axis) < ping.cos_half_cone * out_m) continue;
      const Vector2 unit = out * (1 / out_m);
      const Vector2 between = unit + along;  // against the bisector of both ways
      if (!answers(hit, between * (1 / between.length()), half_m)) continue;
      if (!cast(scene, from, unit, out_m)) nearest_m = half_m;
    }
  }
  return nearest_m < within_m ? nearest_m : kInfinity;
}

void Sonar::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  const double noise_m = draws.normal() * config_.noise_m;
  const bool lost = config_.dropout > 0 && draws.uniform() < config_.dropout;
  double heard_m = lost ? kInfinity : echo_range_m(scene);
  if (config_.crosstalk && !lost) heard_m = std::min(heard_m, crosstalk_m(scene, heard_m));
  if (heard_m == kInfinity) {
    values[0] = kInfinity;
    values[1] = config_.no_echo_s;
  } else if (heard_m < config_.min_range_m) {
    values[0] = config_.too_close == TooClose::Minimum ? config_.min_range_m : -kInfinity;
    values[1] = config_.too_close_echo_s;
  } else {
    const double read_m = std::clamp(heard_m + noise_m, config_.min_range_m, config_.max_range_m);
    values[1] = 2 * read_m / speed_of_sound_mps(config_.air_C);
    const double taken_m = values[1] * speed_of_sound_mps(config_.assumed_C) / 2;
    values[0] = std::clamp(rounded(taken_m, config_.resolution_m), config_.min_range_m, config_.max_range_m);
  }
}

void Sonar::broken(std::span<double> values) const noexcept {
  values[0] = std::numeric_limits<double>::quiet_NaN();
  values[1] = 0;
}

}  // namespace ganglion::sim
