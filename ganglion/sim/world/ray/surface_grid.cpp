#include "ganglion/sim/world/ray/surface_grid.h"

#include <algorithm>

namespace ganglion::sim {
namespace {

constexpr double kReach_m = 1e-6;  ///< By which the lists of the cells are generous.
constexpr double kMaxColumns = 2048;
constexpr double kMaxItems = 16e6;  ///< Entries in all lists; larger cells are taken rather than more.

Box2 box_of(const RoundSurface& round) noexcept {
  const Vector2 reach{round.disc.radius_m, round.disc.radius_m};
  return {round.disc.position - reach, round.disc.position + reach};
}

Box2 box_of(const SurfaceSet& set, const SolidOutline& outline) noexcept {
  Box2 box = empty_box();
  for (std::uint32_t i = 0; i < outline.segments; ++i) box.include(set.segments[outline.first_segment + i].from);
  return box;
}

Box2 box_of(const SurfaceSet& set) noexcept {
  Box2 box = empty_box();
  for (const Segment& segment : set.segments) {
    box.include(segment.from);
    box.include(segment.to);
  }
  for (const RoundSurface& round : set.rounds) {
    box.include(box_of(round).lower);
    box.include(box_of(round).upper);
  }
  return set.segments.empty() && set.rounds.empty() ? Box2{} : box;
}

/// About how many list entries cells of this size would need.
double expected_items(const SurfaceSet& set, double cell_m) noexcept {
  double items = 0;
  auto add_box = [&](const Box2& box) { items += (box.width_m() / cell_m + 2) * (box.height_m() / cell_m + 2); };
  for (const Segment& segment : set.segments) {
    const Vector2 along = segment.to - segment.from;
    items += (std::fabs(along.x) + std::fabs(along.y)) / cell_m + 2;
  }
  for (const SolidOutline& outline : set.outlines) add_box(box_of(set, outline));
  for (const RoundSurface& round : set.rounds) add_box(box_of(round));
  return items;
}

/// Where the ray enters and leaves the box; entry > exit or NaN: never.
struct Span {
  double entry;
  double exit;
};
Span clip(const Ray& ray, Vector2 lower, Vector2 upper, double max_range_m) noexcept {
  Span span{0, max_range_m};
  auto clip_axis = [&](double from, double step, double low, double high) {
    if (step == 0) {
      if (from < low || from > high) span.exit = -1;
      return;
    }
    const double near = ((step > 0 ? low : high) - from) / step;
    const double far = ((step > 0 ? high : low) - from) / step;
    span.entry = std::max(span.entry, near);
    span.exit = std::min(span.exit, far);
  };
  clip_axis(ray.from.x, ray.direction.x, lower.x, upper.x);
  clip_axis(ray.from.y, ray.direction.y, lower.y, upper.y);
  return span;
}

}  // namespace

SurfaceGrid::SurfaceGrid(SurfaceSet set) : set_(std::move(set)) {
  choose_cells();
  for (const Segment& s : set_.segments) {
    const SurfaceTraits& traits = set_.traits[s.traits];
    faces_.push_back({s.to - s.from, left_normal(s.from, s.to), traits.material, traits.solid});
  }
  items_ = gather([this](auto add) {
    for (std::uint32_t i = 0; i < set_.segments.size(); ++i) {
      cells_of(set_.segments[i], [&](std::size_t at) { add(at, i); });
    }
    for (std::uint32_t i = 0; i < set_.rounds.size(); ++i) {
      const auto item = static_cast<std::uint32_t>(set_.segments.size()) + i;
      cells_of(set_.rounds[i], false, [&](std::size_t at) { add(at, item); });
    }
  });
  solids_ = gather([this](auto add) {
    for (std::uint32_t i = 0; i < set_.outlines.size(); ++i) {
      cells_of(box_of(set_, set_.outlines[i]), [&](std::size_t at) { add(at, i); });
    }
    for (std::uint32_t i = 0; i < set_.rounds.size(); ++i) {
      const auto item = static_cast<std::uint32_t>(set_.outlines.size()) + i;
      cells_of(set_.rounds[i], true, [&](std::size_t at) { add(at, item); });
    }
  });
}

void SurfaceGrid::choose_cells() {
  const Box2 box = box_of(set_);
  const double width = box.width_m() + 4 * kReach_m, height = box.height_m() + 4 * kReach_m;
  const double wanted = 2.0 * static_cast<double>(set_.segments.size() + set_.rounds.size()) + 1;
  cell_m_ = std::max({std::sqrt(width * height / wanted), std::max(width, height) / kMaxColumns, 0.01});
  while (expected_items(set_, cell_m_) > kMaxItems && cell_m_ < std::max(width, height)) cell_m_ *= 2;
  lower_ = box.lower - Vector2{2 * kReach_m, 2 * kReach_m};
  columns_ = static_cast<int>(width / cell_m_) + 1;
  rows_ = static_cast<int>(height / cell_m_) + 1;
  upper_ = lower_ + Vector2{columns_ * cell_m_, rows_ * cell_m_};
}

/// Counts first, then fills: `for_each(add)` must call add(cell, item) the same way twice.
template <class ForEach>
SurfaceGrid::Lists SurfaceGrid::gather(ForEach for_each) const {
  Lists lists;
  lists.starts.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for_each([&](std::size_t at, std::uint32_t) { ++lists.starts[at + 1]; });
  for (std::size_t i = 1; i < lists.starts.size(); ++i) lists.starts[i] += lists.starts[i - 1];
  lists.items.resize(lists.starts.back());
  std::vector<std::uint32_t> next(lists.starts.begin(), lists.starts.end() - 1);
  for_each([&](std::size_t at, std::uint32_t item) { lists.items[next[at]++] = item; });
  return lists;
}

template <class OnCell>
void SurfaceGrid::cells_of(const Box2& box, OnCell on_cell) const {
  for (int row = row_of(box.lower.y - kReach_m); row <= row_of(box.upper.y + kReach_m); ++row) {
    for (int column = column_of(box.lower.x - kReach_m); column <= column_of(box.upper.x + kReach_m); ++column) {
      on_cell(cell(column, row));
    }
  }
}

/// Row by row: the piece of the segment within the row, and the columns under it.
template <class OnCell>
void SurfaceGrid::cells_of(const Segment& segment, OnCell on_cell) const {
  const bool up = segment.from.y <= segment.to.y;
  const Vector2 low = up ? segment.from : segment.to, high = up ? segment.to : segment.from;
  const double rise = high.y - low.y;
  auto x_at = [&](double y) {
    return rise > kReach_m ? low.x + (high.x - low.x) * std::clamp((y - low.y) / rise, 0.0, 1.0) : low.x;
  };
  for (int row = row_of(low.y - kReach_m); row <= row_of(high.y + kReach_m); ++row) {
    double x0 = x_at(lower_.y + row * cell_m_ - kReach_m), x1 = x_at(lower_.y + (row + 1) * cell_m_ + kReach_m);
    if (rise <= kReach_m) x1 = high.x;
    if (x0 > x1) std::swap(x0, x1);
    const int last = column_of(x1 + kReach_m);
    for (int column = column_of(x0 - kReach_m); column <= last; ++column) on_cell(cell(column, row));
  }
}

/// The cells that the circle touches, or the whole disc if `filled`.
template <class OnCell>
void SurfaceGrid::cells_of(const RoundSurface& round, bool filled, OnCell on_cell) const {
  const double reach = cell_m_ * 0.7072 + kReach_m;  // half a cell's diagonal
  const Disc& disc = round.disc;
  cells_of(box_of(round), [&](std::size_t at) {
    const auto column = static_cast<double>(at % columns_), row = static_cast<double>(at / columns_);
    const Vector2 centre = lower_ + Vector2{(column + 0.5) * cell_m_, (row + 0.5) * cell_m_};
    const double range = (centre - disc.position).length();
    if (range <= disc.radius_m + reach && (filled || range >= disc.radius_m - reach)) on_cell(at);
  });
}

SurfaceGrid::Found SurfaceGrid::found(const Ray& ray, std::uint32_t item, double range_m) const noexcept {
  if (item < set_.segments.size()) {
    const Segment& segment = set_.segments[item];
    const bool leaves_solid = faces_[item].along.cross(ray.direction) < 0;
    return {range_m, normal_towards(ray, faces_[item].normal), segment.traits, leaves_solid};
  }
  const RoundSurface& round = set_.rounds[item - set_.segments.size()];
  return {range_m, normal_towards(ray, round.disc, range_m), round.traits,
          (ray.from - round.disc.position).squared() < round.disc.radius_m * round.disc.radius_m};
}

void SurfaceGrid::meet(std::uint32_t item, const Ray& ray, bool structural_only, Nearest& best) const noexcept {
  const bool straight = item < set_.segments.size();
  const std::size_t round = straight ? 0 : item - set_.segments.size();
  const double range_m = straight ? range_to_segment(ray, set_.segments[item].from, set_.segments[item].to)
                                  : range_to_circle(ray, set_.rounds[round].disc);
  if (!(range_m < best.range_m || (range_m == best.range_m && item < best.item))) return;
  const std::uint32_t traits = straight ? set_.segments[item].traits : set_.rounds[round].traits;
  if (!structural_only || set_.traits[traits].structural) best = {range_m, item};
}

std::optional<SurfaceGrid::Found> SurfaceGrid::cast(Vector2 from, Vector2 unit_direction, double max_range_m,
                                                    bool structural_only) const noexcept {
  const Ray ray{from, unit_direction};
  const Span span = clip(ray, lower_, upper_, max_range_m);
  const Vector2 start = from + unit_direction * span.entry;
  if (!(span.entry <= span.exit) || !std::isfinite(start.x + start.y)) return std::nullopt;
  const double limit_m = std::nextafter(max_range_m, kNoHit);
  Nearest best{limit_m, 0};
  const Vector2 inverse{1 / unit_direction.x, 1 / unit_direction.y};
  int column = column_of(start.x), row = row_of(start.y);
  while (column >= 0 && row >= 0 && column < columns_ && row < rows_) {
    for (const std::uint32_t item : items_in(column, row)) meet(item, ray, structural_only, best);
    auto crossing = [&](double origin, double low, int index, double step, double inverse_step) {
      if (step == 0) return kNoHit;
      return (low + (index + (step > 0 ? 1 : 0)) * cell_m_ - origin) * inverse_step;
    };
    const double at_x = crossing(from.x, lower_.x, column, unit_direction.x, inverse.x);
    const double at_y = crossing(from.y, lower_.y, row, unit_direction.y, inverse.y);
    const double leaves = std::min(at_x, at_y);
    if (best.range_m <= leaves || !(leaves <= span.exit)) break;
    (at_x <= at_y ? column : row) += (at_x <= at_y ? unit_direction.x : unit_direction.y) > 0 ? 1 : -1;
  }
  if (best.range_m < limit_m) return found(ray, best.item, best.range_m);
  return std::nullopt;
}

double SurfaceGrid::distance_to(std::uint32_t item, Vector2 point) const noexcept {
  if (item < set_.segments.size()) {
    const Segment& segment = set_.segments[item];
    return (point - nearest_on_segment(point, segment.from, segment.to)).length();
  }
  const Disc& disc = set_.rounds[item - set_.segments.size()].disc;
  return std::fabs((point - disc.position).length() - disc.radius_m);
}

/// Rings of cells about the point, until no cell left can hold anything nearer.
double SurfaceGrid::distance(Vector2 point, double up_to_m) const noexcept {
  double best = up_to_m;
  const int column = column_of(point.x), row = row_of(point.y);
  for (int ring = 0;; ++ring) {
    const int left = column - ring, right = column + ring, below = row - ring, above = row + ring;
    for (int j = std::max(below, 0); j <= std::min(above, rows_ - 1); ++j) {
      const int stride = j == below || j == above ? 1 : std::max(right - left, 1);
      for (int i = left; i <= right; i += stride) {
        if (i < 0 || i >= columns_) continue;
        for (const std::uint32_t item : items_in(i, j)) best = std::min(best, distance_to(item, point));
      }
    }
    double nearest_left_out = kNoHit;  // distance to the cells outside the block looked at so far
    if (left > 0) nearest_left_out = std::min(nearest_left_out, point.x - (lower_.x + left * cell_m_));
    if (below > 0) nearest_left_out = std::min(nearest_left_out, point.y - (lower_.y + below * cell_m_));
    if (right + 1 < columns_) nearest_left_out = std::min(nearest_left_out, lower_.x + (right + 1) * cell_m_ - point.x);
    if (above + 1 < rows_) nearest_left_out = std::min(nearest_left_out, lower_.y + (above + 1) * cell_m_ - point.y);
    if (!(nearest_left_out < best)) return best;
  }
}

bool SurfaceGrid::inside_solid(Vector2 point) const noexcept {
  if (!Box2{lower_, upper_}.contains(point)) return false;
  for (const std::uint32_t item : solids_.of(cell(column_of(point.x), row_of(point.y)))) {
    if (item >= set_.outlines.size()) {
      const Disc& disc = set_.rounds[item - set_.outlines.size()].disc;
      if ((point - disc.position).squared() < disc.radius_m * disc.radius_m) return true;
      continue;
    }
    const SolidOutline& outline = set_.outlines[item];
    bool inside = false;
    for (std::uint32_t i = 0; i < outline.segments; ++i) {
      const Segment& edge = set_.segments[outline.first_segment + i];
      if (crosses_right_of(point, edge.from, edge.to)) inside = !inside;
    }
    if (inside) return true;
  }
  return false;
}

}  // namespace ganglion::sim
