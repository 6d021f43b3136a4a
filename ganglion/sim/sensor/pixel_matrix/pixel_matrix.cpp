#include "ganglion/sim/sensor/pixel_matrix/pixel_matrix.h"

#include <cmath>

#include "ganglion/math/functions.h"

namespace ganglion::sim {
namespace {

constexpr double kBackground = 0;
constexpr std::array<double, 3> kWallBrightness = {0.5, 0.8, 0.3};  // by material

/// How far the middle of the n-th of 8 parts lies from the first edge, as a share of the whole.
constexpr double middle_of(int n) noexcept { return (n + 0.5) / PixelMatrix::kSide; }

}  // namespace

PixelMatrix::PixelMatrix(const PixelMatrixConfig& config) noexcept : config_(config) {
  for (int n = 0; n < kSide; ++n) {
    const auto place = static_cast<std::size_t>(n);
    columns_[place] = direction(config.width.rad() * (0.5 - middle_of(n)));
    fall_[place] = math::tan(config.down.rad() + config.height.rad() * (middle_of(n) - 0.5));
  }
}

double PixelMatrix::brightness(const Colour& colour) const noexcept {
  switch (config_.filter) {
    case Filter::Red:
      return colour.red;
    case Filter::Green:
      return colour.green;
    case Filter::Blue:
      return colour.blue;
    case Filter::Grey:
      break;
  }
  return 0.2126 * colour.red + 0.7152 * colour.green + 0.0722 * colour.blue;
}

void PixelMatrix::paint_column(const Scene& scene, int column, std::span<double> pixels) const noexcept {
  const Vector2 ahead = scene.ahead(), lens = scene.mount().position;
  const Vector2 in_frame = columns_[static_cast<std::size_t>(column)];
  const Vector2 along = ahead * in_frame.x + ahead.left() * in_frame.y;
  const auto hit = cast(scene, lens, along, config_.reach_m);
  const double wall_m = hit ? hit->range_m : config_.reach_m;
  double wall = kBackground;
  if (hit) {
    wall = kWallBrightness[static_cast<std::size_t>(hit->material)] * (1 + std::fabs(hit->normal.dot(along))) / 2;
  }
  const Floor& floor = scene.world.ground().plan().floor;
  for (int row = 0; row < kSide; ++row) {
    const double fall = fall_[static_cast<std::size_t>(row)];
    double& pixel = pixels[static_cast<std::size_t>(row * kSide + column)];
    if (fall * wall_m > config_.height_m) {
      pixel = brightness(floor.colour_at(lens + along * (config_.height_m / fall)));
    } else {
      pixel = config_.height_m - fall * wall_m <= config_.wall_height_m ? wall : kBackground;
    }
  }
}

void PixelMatrix::paint_beacon(const Scene& scene, const Beacon& beacon, std::span<double> pixels) const noexcept {
  const Pose2 mount = scene.mount();
  const Vector2 away = beacon.position - mount.position;
  const double range_m = away.length();
  if (!(range_m > 0) || range_m > std::min(beacon.light_range_m, config_.reach_m)) return;
  const double left_rad = wrap_rad(math::atan2(away.y, away.x) - mount.yaw.rad());
  const double down_rad = math::atan2(config_.height_m - beacon.height_m, range_m) - config_.down.rad();
  const double column = std::floor((0.5 - left_rad / config_.width.rad()) * kSide);
  const double row = std::floor((0.5 + down_rad / config_.height.rad()) * kSide);
  if (!(column >= 0 && column < kSide && row >= 0 && row < kSide)) return;
  if (cast(scene, mount.position, away * (1 / range_m), range_m)) return;  // something stands before it
  pixels[static_cast<std::size_t>(row * kSide + column)] = brightness(beacon.colour);
}

void PixelMatrix::measure(const Scene& scene, Draws& draws, std::span<double> values) noexcept {
  for (int column = 0; column < kSide; ++column) paint_column(scene, column, values);
  for (const Beacon& beacon : scene.world.ground().plan().beacons) paint_beacon(scene, beacon, values);
  for (double& pixel : values) {
    if (config_.noise > 0) pixel = std::clamp(pixel + draws.normal() * config_.noise, 0.0, 1.0);
    if (config_.levels > 1) pixel = std::floor(pixel * (config_.levels - 1) + 0.5) / (config_.levels - 1);
  }
}

}  // namespace ganglion::sim
