#include "ganglion/sim/world/shape/shape.h"

#include <algorithm>
#include <limits>

namespace ganglion::sim {
namespace {

constexpr double kTouch_m = 1e-9;

/// Whether a line along one of a's edges has all of b beyond it; `a` runs counter-clockwise.
bool edge_parts(std::span<const Vector2> a, std::span<const Vector2> b) noexcept {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector2 edge = a[(i + 1) % a.size()] - a[i];
    const double depth = kTouch_m * edge.length();
    if (std::all_of(b.begin(), b.end(), [&](Vector2 point) { return edge.cross(point - a[i]) < depth; })) return true;
  }
  return false;
}

}  // namespace

std::vector<Vector2> rectangle(Vector2 centre, double length_m, double width_m, double yaw_rad) {
  const Vector2 along = direction(yaw_rad) * (length_m / 2);
  const Vector2 across = direction(yaw_rad).left() * (width_m / 2);
  return {centre - along - across, centre + along - across, centre + along + across, centre - along + across};
}

double doubled_area(std::span<const Vector2> outline) noexcept {
  double area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2 from = outline[i] - outline.front();  // from a corner: far from the origin no digits are lost
    area += from.cross(outline[(i + 1) % outline.size()] - outline.front());
  }
  return area;
}

bool outline_contains(std::span<const Vector2> outline, Vector2 point) noexcept {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (crosses_right_of(point, outline[i], outline[(i + 1) % outline.size()])) inside = !inside;
  }
  return inside;
}

bool convex_overlap(std::span<const Vector2> a, std::span<const Vector2> b) noexcept {
  return !edge_parts(a, b) && !edge_parts(b, a);
}

}  // namespace ganglion::sim
