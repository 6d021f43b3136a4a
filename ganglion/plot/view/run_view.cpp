#include "ganglion/plot/view/run_view.h"

#include <algorithm>
#include <cmath>

namespace ganglion::plot {
namespace {

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
  for (const GoalView& goal : robot.goals) extent.add(goal.place);
}

/// Inhibition of the cell that holds `point`; 0 outside the map.
std::uint8_t inhibition_at(const MapFrame& frame, double cell_m, Vector2 point) noexcept {
  const double column = std::floor((point.x - frame.origin.x) / cell_m);
  const double row = std::floor((point.y - frame.origin.y) / cell_m);
  if (!(column >= 0 && row >= 0 && column < frame.columns && row < frame.rows)) return 0;
  const std::size_t cell = static_cast<std::size_t>(row) * frame.columns + static_cast<std::size_t>(column);
  return cell < frame.inhibited.size() ? frame.inhibited[cell] : 0;
}

/// Where the robot was nearest to `place` in (after_s, until_s]; none where it was nowhere known.
std::optional<std::size_t> nearest_row(const Track& track, Vector2 place, double after_s, double until_s) noexcept {
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t row = index_at(track.times_s, after_s).value_or(0); row < track.times_s.size(); ++row) {
    if (track.times_s[row] > until_s) break;
    const double squared = (Vector2{track.x_m[row], track.y_m[row]} - place).squared();
    if (!(squared < least)) continue;
    least = squared;
    nearest = row;
  }
  return nearest;
}

void add_attempts(std::vector<Attempt>& attempts, const RobotView& robot, const MapView& map, std::size_t index) {
  const MapFrame& now = map.frames[index];
  if (now.inhibited.size() < static_cast<std::size_t>(now.columns) * now.rows) return;
  const double after_s = index > 0 ? map.frames[index - 1].time_s : 0;
  for (int row = 0; row < now.rows; ++row) {
    for (int column = 0; column < now.columns; ++column) {
      const std::uint8_t left = now.inhibited[static_cast<std::size_t>(row) * now.columns + column];
      if (left == 0) continue;
      const Vector2 centre = now.origin + Vector2{column + 0.5, row + 0.5} * map.cell_m;
      if (index > 0 && inhibition_at(map.frames[index - 1], map.cell_m, centre) >= left) continue;
      const auto from = nearest_row(robot.track, centre, after_s, now.time_s);
      if (!from) continue;
      const Track& track = robot.track;
      attempts.push_back({track.times_s[*from], {track.x_m[*from], track.y_m[*from]}, centre});
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

std::vector<Attempt> failed_attempts(const RobotView& robot) {
  std::vector<Attempt> attempts;
  for (const MapView& map : robot.maps)
    for (std::size_t i = 0; i < map.frames.size(); ++i) add_attempts(attempts, robot, map, i);
  std::ranges::stable_sort(attempts, {}, &Attempt::time_s);
  return attempts;
}

Bounds bounds_of(const RunView& run) noexcept {
  Extent extent;
  if (run.scene.bounds) {
    extent.add(run.scene.bounds->lower);
    extent.add(run.scene.bounds->upper);
  }
  extent.add(run.scene.walls);
  extent.add(run.scene.furniture);
  extent.add(run.scene.solids);
  for (const RobotView& robot : run.robots) add_robot(extent, robot);
  return extent.bounds();
}

}  // namespace ganglion::plot
