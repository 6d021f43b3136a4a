#include <algorithm>
#include <limits>

#include "ganglion/geometry/box2.h"
#include "ganglion/geometry/pose2.h"
#include "ganglion/geometry/vector2.h"
#include "ganglion/math/functions.h"

namespace ganglion {
namespace {

Vector2 rotated(Vector2 v, math::SinCos turn) noexcept {
  return {turn.cos * v.x - turn.sin * v.y, turn.sin * v.x + turn.cos * v.y};
}

}  // namespace

Vector2 direction(double yaw_rad) noexcept {
  const auto turn = math::sincos(yaw_rad);
  return {turn.cos, turn.sin};
}

Vector2 nearest_on_segment(Vector2 point, Vector2 from, Vector2 to) noexcept {
  const Vector2 along = to - from;
  const double squared = along.squared();
  if (squared <= 0) return from;
  return from + along * std::clamp((point - from).dot(along) / squared, 0.0, 1.0);
}

Vector2 Pose2::to_outer(Vector2 local) const noexcept { return position + rotated(local, math::sincos(yaw.rad())); }

Vector2 Pose2::to_local(Vector2 outer) const noexcept {
  const auto turn = math::sincos(yaw.rad());
  return rotated(outer - position, {-turn.sin, turn.cos});
}

Pose2 Pose2::then(const Pose2& local) const noexcept { return {to_outer(local.position), (yaw + local.yaw).wrapped()}; }

void Box2::include(Vector2 point) noexcept {
  lower = {std::min(lower.x, point.x), std::min(lower.y, point.y)};
  upper = {std::max(upper.x, point.x), std::max(upper.y, point.y)};
}

Box2 empty_box() noexcept {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return {{kInf, kInf}, {-kInf, -kInf}};
}

}  // namespace ganglion
