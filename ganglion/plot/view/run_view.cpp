#include "ganglion/plot/view/run_view.h"

#include <algorithm>
#include <cmath>

#include "ganglion/plot/view/shapes.h"

namespace ganglion::plot {
namespace {

constexpr double kWidestReach_m = 1000;

/// Grows by the finite points it is shown.
class Extent {
 public:
  void add(Vector2 p) noexcept {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
    lower_ = {std::min(lower_.x, p.x), std::min(lower_.y, p.y)};
    upper_ = {std::max(upper_.x, p.x), std::max(upper_.y, p.y)};
  }
  void add(const std::vector<Outline>& outlines) noexcept {
    for (const Outline& outline : outlines)
      for (const Vector2 p : outline.points) add(p);
  }
  /// Never empty and at least half a metre each way, so that a robot standing still has ground around it.
  Bounds bounds() const noexcept {
    if (lower_.x > upper_.x) return {{-1, -1}, {1, 1}};
    Bounds result{lower_, upper_};
    constexpr double kLeast_m = 0.5;
    const Vector2 lack{std::max(0.0, kLeast_m - (upper_.x - lower_.x)),
                       std::max(0.0, kLeast_m - (upper_.y - lower_.y))};
    result.lower += -0.5 * lack;
    result.upper += 0.5 * lack;
    return result;
  }

 private:
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  Vector2 lower_{kInfinite, kInfinite};
  Vector2 upper_{-kInfinite, -kInfinite};
};

void add_robot(Extent& extent, const RobotView& robot) noexcept {
  const double half_m = robot.extent_m() / 2;
  for (std::size_t i = 0; i < robot.track.times_s.size(); ++i) {
    const Vector2 p{robot.track.x_m[i], robot.track.y_m[i]};
    extent.add(p - Vector2{half_m, half_m});
    extent.add(p + Vector2{half_m, half_m});
  }
}

/// Shapes of all time: a picture that shows only the last ones has room for them too.
void add_exhibits(Extent& extent, const RunView& run) {
  for (const PlacedShape& placed : lasting_shapes(run)) {
    const double radius_m = placed.radius_m < kWidestReach_m ? placed.radius_m : 0;
    if (placed.shape->role == Role::Echo || placed.shape->role == Role::Sensing) continue;
    if (run.scene.bounds && placed.shape->form == Form::Polyline) continue;  // lines may lead out of the world
    for (const Vector2 point : placed.shape->points) {
      const Vector2 at = placed.frame.to_outer(point);
      extent.add(at - Vector2{radius_m, radius_m});
      extent.add(at + Vector2{radius_m, radius_m});
    }
  }
}

}  // namespace

std::optional<std::size_t> SignalTable::find(const std::string& name) const noexcept {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].name == name) return i;
  return std::nullopt;
}

double RobotView::extent_m() const noexcept { return radius_m > 0 ? 2 * radius_m : std::max({length_m, width_m, 0.0}); }

std::optional<std::size_t> index_at(std::span<const double> times_s, double time_s) noexcept {
  const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s);
  if (after == times_s.begin()) return std::nullopt;
  return static_cast<std::size_t>(after - times_s.begin()) - 1;
}

bool has_way(const RunView& run) noexcept {
  const auto seen = [](const RobotView& robot) {
    return std::ranges::any_of(robot.track.x_m, [](double x_m) { return std::isfinite(x_m); });
  };
  return std::ranges::any_of(run.robots, seen);
}

Bounds bounds_of(const RunView& run) {
  Extent extent;
  if (run.scene.bounds) {
    extent.add(run.scene.bounds->lower);
    extent.add(run.scene.bounds->upper);
  }
  extent.add(run.scene.walls);
  extent.add(run.scene.furniture);
  extent.add(run.scene.solids);
  for (const RobotView& robot : run.robots) add_robot(extent, robot);
  add_exhibits(extent, run);
  return extent.bounds();
}

}  // namespace ganglion::plot
