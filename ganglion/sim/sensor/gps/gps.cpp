#include "ganglion/sim/sensor/gps/gps.h"

#include <cmath>

#include "ganglion/math/functions.h"

namespace ganglion::sim {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kEquatorialRadius_m = 6378137;  // WGS 84
constexpr double kEccentricitySquared = 6.69437999014e-3;

}  // namespace

Gps::Gps(const GpsConfig& config) noexcept : config_(config) {
  const Datum& datum = config.datum;
  const math::SinCos latitude = math::sincos(datum.latitude.rad());
  const double flattened = 1 - kEccentricitySquared * latitude.sin * latitude.sin;
  const double across_m = kEquatorialRadius_m / std::sqrt(flattened);
  const double meridian_m = across_m * (1 - kEccentricitySquared) / flattened;
  deg_per_m_north_ = Angle::from_rad(1 / (meridian_m + datum.altitude_m)).deg();
  deg_per_m_east_ = Angle::from_rad(1 / ((across_m + datum.altitude_m) * latitude.cos)).deg();
  north_ = direction(datum.north.rad());
  east_ = -north_.left();
}

Limits Gps::limits(std::size_t channel) const noexcept {
  constexpr std::array<Limits, 8> kLimits = {
      {{-1e6, 1e6}, {-90, 90}, {-180, 180}, {-1e5, 1e5}, {-kPi, kPi}, {0, 1e3}, {0, 1e12}, {0, 1}}};
  return kLimits[channel];
}

Result<void> Gps::reset(const Scene& scene, Draws draws) {
  const double east = draws.normal(), north = draws.normal();
  drift_ = {east, north, draws.normal()};
  const double both_s = config_.lost_every_s + config_.lost_for_s;
  lost_ = config_.lost_every_s > 0 && draws.uniform() < config_.lost_for_s / both_s;
  fired_s_ = scene.time_s;
  return {};
}

void Gps::age(double step_s, Draws& draws) noexcept {
  const double kept = math::exp(-step_s / config_.drift_s);
  const double fresh = std::sqrt(1 - kept * kept);
  const double east = draws.normal(), north = draws.normal(), up = draws.normal();
  drift_ = {drift_.east * kept + east * fresh, drift_.north * kept + north * fresh, drift_.up * kept + up * fresh};
  const double chance = draws.uniform();
  if (!(config_.lost_every_s > 0)) return;
  const double share_lost = config_.lost_for_s / (config_.lost_every_s + config_.lost_for_s);
  const double forgotten = 1 - math::exp(-step_s * (1 / config_.lost_every_s + 1 / config_.lost_for_s));
  lost_ = lost_ ? chance >= forgotten * (1 - share_lost) : chance < forgotten * share_lost;
}

void Gps::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  age(scene.time_s - fired_s_, draws);
  fired_s_ = scene.time_s;
  const double east_m = drift_.east * config_.drift_m + draws.normal() * config_.noise_m;
  const double north_m = drift_.north * config_.drift_m + draws.normal() * config_.noise_m;
  const double up_m = (drift_.up * config_.drift_m + draws.normal() * config_.noise_m) * config_.vertical_factor;
  const double spread_x_mps = draws.normal() * config_.velocity_noise_mps;
  const double spread_y_mps = draws.normal() * config_.velocity_noise_mps;
  std::fill(values.begin(), values.end(), kNan);
  values[7] = config_.datum.utc_s + scene.time_s;
  values[8] = lost_ ? 0 : 1;
  if (lost_) return;

  const Vector2 antenna = scene.mount().position;
  const Vector2 place = antenna + east_ * east_m + north_ * north_m;
  values[0] = place.x;
  values[1] = place.y;
  values[2] = config_.datum.latitude.deg() + place.dot(north_) * deg_per_m_north_;
  const double longitude_deg = config_.datum.longitude.deg() + place.dot(east_) * deg_per_m_east_;
  values[3] = Angle::from_deg(longitude_deg).wrapped().deg();
  values[4] = config_.datum.altitude_m + scene.world.ground().plan().floor.height_at(antenna) + up_m;
  const Vector2 arm = antenna - scene.robot.pose.position;
  const Vector2 velocity_mps =
      scene.robot.velocity_mps + arm.left() * scene.robot.turn_rate_radps + Vector2{spread_x_mps, spread_y_mps};
  const double speed_mps = velocity_mps.length();
  if (speed_mps >= config_.course_from_mps) values[5] = math::atan2(velocity_mps.y, velocity_mps.x);
  values[6] = speed_mps;
}

}  // namespace ganglion::sim
