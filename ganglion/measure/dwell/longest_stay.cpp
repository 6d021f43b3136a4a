#include "ganglion/measure/dwell/longest_stay.h"

#include <algorithm>
#include <cmath>

namespace ganglion {
namespace {

bool inside(const Circle& circle, Vector2 point) noexcept {
  return (point - circle.centre).length() <= circle.radius_m * (1 + 1e-12) + 1e-12;
}

Circle through(Vector2 a, Vector2 b) noexcept { return {(a + b) * 0.5, (a - b).length() / 2}; }

Circle through(Vector2 a, Vector2 b, Vector2 c) noexcept {
  const Vector2 u = b - a, v = c - a;
  const double d = 2 * u.cross(v);
  if (std::fabs(d) < 1e-15) {  // on one line: the widest pair counts
    const Circle ab = through(a, b), ac = through(a, c), bc = through(b, c);
    return std::max({ab, ac, bc}, [](const Circle& x, const Circle& y) { return x.radius_m < y.radius_m; });
  }
  const Vector2 offset{(v.y * u.squared() - u.y * v.squared()) / d, (u.x * v.squared() - v.x * u.squared()) / d};
  return {a + offset, offset.length()};
}

}  // namespace

Circle smallest_circle(const std::deque<Vector2>& points) {
  Circle circle;
  if (!points.empty()) circle.centre = points.front();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (inside(circle, points[i])) continue;
    circle = {points[i], 0};
    for (std::size_t j = 0; j < i; ++j) {
      if (inside(circle, points[j])) continue;
      circle = through(points[i], points[j]);
      for (std::size_t k = 0; k < j; ++k) {
        if (!inside(circle, points[k])) circle = through(points[i], points[j], points[k]);
      }
    }
  }
  return circle;
}

void LongestStay::add(double time_s, Vector2 position) {
  if (time_s + 1e-9 < next_s_) return;
  next_s_ = time_s + sample_s_;
  stretch_.push_back({time_s, position});
  auto too_wide = [this] {
    std::deque<Vector2> points;
    for (const Sample& sample : stretch_) points.push_back(sample.position);
    return smallest_circle(points).radius_m > radius_m_;
  };
  while (stretch_.size() > 1 && too_wide()) stretch_.pop_front();
  longest_s_ = std::max(longest_s_, time_s - stretch_.front().time_s);
}

}  // namespace ganglion
