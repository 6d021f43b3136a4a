#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/geometry/box2.h"

namespace ganglion::sim {

/// Acoustic surface. How far from the normal it still answers belongs to the sonar, not here.
enum class Material : std::uint8_t { Rough, Smooth, Soft };
/// As written in files, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> kMaterialNames = {"rough", "smooth", "soft"};
constexpr std::string_view name_of(Material material) noexcept {
  return kMaterialNames[static_cast<std::size_t>(material)];
}

/// Where a ray meets a surface.
struct Hit {
  double range_m = 0;
  Vector2 normal;  ///< Unit, towards the ray's origin.
  Material material = Material::Rough;
};

/// A filled circle: a solid, or a robot.
struct Disc {
  Vector2 position;
  double radius_m = 0;
};

enum class ShapeKind : std::uint8_t { Wall, Box, Disc, Polygon };

/// One thing that stands on the ground. Walls are lines without thickness; the other kinds are solid.
struct Shape {
  ShapeKind kind = ShapeKind::Wall;
  std::string id;
  std::string label;
  Material material = Material::Rough;
  bool structural = true;       ///< Part of the building; furniture is not.
  bool closed = false;          ///< Walls: the last point joins the first.
  std::vector<Vector2> points;  ///< Outline; of solids counter-clockwise. Empty for discs.
  Disc disc;
};

/// The corners, counter-clockwise, of a rectangle about `centre`.
std::vector<Vector2> rectangle(Vector2 centre, double length_m, double width_m, double yaw_rad);

/// Twice the area, positive when the outline runs counter-clockwise.
double doubled_area(std::span<const Vector2> outline) noexcept;

/// Whether a level line from the point to the right crosses the edge a-b: an odd count over an outline means inside.
inline bool crosses_right_of(Vector2 point, Vector2 a, Vector2 b) noexcept {
  if ((a.y > point.y) == (b.y > point.y)) return false;
  return ((b - a).cross(point - a) > 0) == (b.y > a.y);
}

/// Whether the point lies within the outline (even-odd rule).
bool outline_contains(std::span<const Vector2> outline, Vector2 point) noexcept;

/// Whether two convex outlines share more than a border 1 nm deep.
bool convex_overlap(std::span<const Vector2> a, std::span<const Vector2> b) noexcept;

}  // namespace ganglion::sim
