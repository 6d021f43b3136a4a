#include "ganglion/sim/world/ray/near_surfaces.h"

#include <algorithm>
#include <cmath>

namespace ganglion::sim {
namespace {

constexpr double kGenerosity_m = 1e-6;  // by which the lists are generous
constexpr double kMostLists = 1 << 18;  // larger cells are taken rather than more
constexpr double kHalfDiagonal = 0.7072;

Box2 box_of(const SurfaceSet& set, std::size_t item) noexcept {
  Box2 box = empty_box();
  if (item < set.segments.size()) {
    box.include(set.segments[item].from);
    box.include(set.segments[item].to);
    return box;
  }
  const Disc& disc = set.rounds[item - set.segments.size()].disc;
  const Vector2 reach{disc.radius_m, disc.radius_m};
  return {disc.position - reach, disc.position + reach};
}

double distance(const SurfaceSet& set, std::size_t item, Vector2 point) noexcept {
  if (item < set.segments.size()) {
    return (point - nearest_on_segment(point, set.segments[item].from, set.segments[item].to)).length();
  }
  const Disc& disc = set.rounds[item - set.segments.size()].disc;
  return std::fabs((point - disc.position).length() - disc.radius_m);
}

/// For each segment the box round the solid that it bounds; empty for walls and maps.
std::vector<Box2> outlines_of(const SurfaceSet& set) {
  std::vector<Box2> boxes(set.segments.size(), empty_box());
  for (const SolidOutline& outline : set.outlines) {
    Box2 box = empty_box();
    for (std::uint32_t i = 0; i < outline.segments; ++i) box.include(set.segments[outline.first_segment + i].from);
    std::fill_n(boxes.begin() + outline.first_segment, outline.segments, box);
  }
  return boxes;
}

}  // namespace

NearSurfaces::NearSurfaces(const SurfaceGrid& surfaces, double reach_m, double spread_m)
    : reach_m_(reach_m), spread_m_(spread_m) {
  const SurfaceSet& set = surfaces.set();
  const std::size_t items = set.segments.size() + set.rounds.size();
  lay_out(surfaces);
  if (cells_.empty()) return;
  std::vector<std::uint32_t> counts(cells_.size());
  for (std::size_t item = 0; item < items; ++item) {
    each_near_cell(set, item, [&](std::size_t cell) { ++counts[cell]; });
  }
  std::uint32_t total = 0;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    cells_[cell] = {.start = total, .listed = counts[cell] <= kMaxListed};
    if (cells_[cell].listed) total += counts[cell];
  }
  items_.resize(total);
  const std::vector<Box2> outlines = outlines_of(set);
  auto fill = [&](std::size_t first, std::size_t last, std::uint8_t Cell::*count, auto wanted) {
    for (std::size_t item = first; item < last; ++item) {
      each_near_cell(set, item, [&](std::size_t at) {
        Cell& cell = cells_[at];
        if (!cell.listed || !wanted(static_cast<std::uint32_t>(item), at)) return;
        items_[cell.start + cell.facing + cell.averted + cell.rounds] = static_cast<std::uint32_t>(item);
        ++(cell.*count);
      });
    }
  };
  auto averted = [&](std::uint32_t item, std::size_t at) { return averts(set, item, outlines[item], at); };
  fill(0, set.segments.size(), &Cell::facing, [&](std::uint32_t item, std::size_t at) { return !averted(item, at); });
  fill(0, set.segments.size(), &Cell::averted, averted);
  fill(set.segments.size(), items, &Cell::rounds, [](std::uint32_t, std::size_t) { return true; });
}

/// No cells where the lists would be too long on the average.
void NearSurfaces::lay_out(const SurfaceGrid& surfaces) {
  const SurfaceSet& set = surfaces.set();
  Box2 box = empty_box();
  double needed = 0;
  for (std::size_t item = 0; item < set.segments.size() + set.rounds.size(); ++item) {
    const Box2 own = box_of(set, item);
    box.include(own.lower);
    box.include(own.upper);
  }
  if (!(box.width_m() >= 0)) return;
  cell_m_ = std::max({0.5, reach_m_ / 16, std::sqrt((box.width_m() + 1) * (box.height_m() + 1) / kMostLists)});
  const double around_m = 2 * (reach_m_ + spread_m_) + cell_m_;
  for (const Segment& segment : set.segments) {
    const Vector2 along = segment.to - segment.from;
    needed += (std::fabs(along.x) + around_m) * (std::fabs(along.y) + around_m) / (cell_m_ * cell_m_);
  }
  lower_ = box.lower;
  const int columns = static_cast<int>(box.width_m() / cell_m_) + 1,
            rows = static_cast<int>(box.height_m() / cell_m_) + 1;
  if (needed > 4.0 * kMaxListed * columns * rows) return;
  columns_ = columns;
  rows_ = rows;
  cells_.resize(static_cast<std::size_t>(columns_) * rows_);
}

Vector2 NearSurfaces::centre(std::size_t cell) const noexcept {
  const auto column = static_cast<double>(cell % columns_), row = static_cast<double>(cell / columns_);
  return lower_ + Vector2{(column + 0.5) * cell_m_, (row + 0.5) * cell_m_};
}

template <class OnCell>
void NearSurfaces::each_near_cell(const SurfaceSet& set, std::size_t item, OnCell on_cell) const {
  const double around_m = reach_m_ + spread_m_ + cell_m_ * kHalfDiagonal + kGenerosity_m;
  const Box2 box = box_of(set, item);
  auto index = [&](double from_m, int count) { return std::clamp(static_cast<int>(from_m / cell_m_), 0, count - 1); };
  const int left = index(box.lower.x - around_m - lower_.x, columns_);
  const int right = index(box.upper.x + around_m - lower_.x, columns_);
  const int top = index(box.upper.y + around_m - lower_.y, rows_);
  for (int row = index(box.lower.y - around_m - lower_.y, rows_); row <= top; ++row) {
    for (int column = left; column <= right; ++column) {
      const std::size_t cell = static_cast<std::size_t>(row) * columns_ + column;
      if (distance(set, item, centre(cell)) <= around_m) on_cell(cell);
    }
  }
}

/// A ray that begins outside a solid meets the far side of its outline only after the near one. Certain for all rays
/// from a cell that lies behind the segment and wholly off the solid.
bool NearSurfaces::averts(const SurfaceSet& set, std::uint32_t segment, const Box2& outline,
                          std::size_t cell) const noexcept {
  if (outline.lower.x > outline.upper.x) return false;
  const double half_m = cell_m_ / 2 + spread_m_ + kGenerosity_m;
  const Vector2 middle = centre(cell);
  const bool off = middle.x + half_m < outline.lower.x || middle.x - half_m > outline.upper.x ||
                   middle.y + half_m < outline.lower.y || middle.y - half_m > outline.upper.y;
  if (!off) return false;
  const Vector2 from = set.segments[segment].from, along = set.segments[segment].to - from;
  const double behind = along.cross(middle - from);  // times the length: the solid's side
  return behind > half_m * (std::fabs(along.x) + std::fabs(along.y));
}

NearSurfaces::List NearSurfaces::at(Vector2 point) const noexcept {
  const double x = (point.x - lower_.x) / cell_m_, y = (point.y - lower_.y) / cell_m_;
  if (!(x >= 0 && y >= 0 && x < columns_ && y < rows_)) return {};
  const Cell& cell = cells_[static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x)];
  const std::span<const std::uint32_t> all(items_.data() + cell.start, cell.facing + cell.averted + cell.rounds);
  return {all.first(cell.facing), all.subspan(cell.facing, cell.averted), all.last(cell.rounds), cell.listed};
}

}  // namespace ganglion::sim
