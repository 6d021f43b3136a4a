#include "ganglion/sim/world/way/free_space.h"

#include <algorithm>

#include "ganglion/base/expects.h"

namespace ganglion::sim {
namespace {

constexpr double kMostFreeCells = 4 << 20;
constexpr int kTries = 1000;

int cells_along(double length_m, double cell_m) {
  return std::max(1, static_cast<int>(std::ceil(length_m / cell_m - 1e-9)));
}

}  // namespace

FreeSpace::FreeSpace(std::shared_ptr<const Ground> ground, double cell_m)
    : ground_(std::move(ground)), cell_m_(cell_m) {
  expects(ground_ != nullptr && cell_m > 0);
  const Box2& box = bounds();
  while ((box.width_m() / cell_m_ + 1) * (box.height_m() / cell_m_ + 1) > kMostFreeCells) cell_m_ *= 2;
  columns_ = cells_along(box.width_m(), cell_m_);
  rows_ = cells_along(box.height_m(), cell_m_);
}

double FreeSpace::largest_part_area_m2(double clearance_m) {
  return static_cast<double>(part(clearance_m).size()) * cell_m_ * cell_m_;
}

Vector2 FreeSpace::sample(double clearance_m, Draws& draws) {
  const Cells& cells = part(clearance_m);
  expects(!cells.empty());
  for (int i = 0; i < kTries; ++i) {
    const Vector2 middle = centre(cells[draws.below(static_cast<std::uint32_t>(cells.size()))]);
    const double x = draws.uniform(-0.5, 0.5), y = draws.uniform(-0.5, 0.5);
    const Vector2 point = middle + Vector2{x, y} * cell_m_;
    if (bounds().contains(point) && roomy(point, clearance_m) && joined(middle, point, clearance_m)) return point;
  }
  return centre(cells[draws.below(static_cast<std::uint32_t>(cells.size()))]);
}

const FreeSpace::Cells& FreeSpace::part(double clearance_m) {
  auto found = parts_.find(clearance_m);
  if (found == parts_.end()) {
    auto part = ground_->findings().get<Cells>(clearance_m, cell_m_, [&] { return largest_part(clearance_m); });
    found = parts_.emplace(clearance_m, std::move(part)).first;
  }
  return *found->second;
}

FreeSpace::Cells FreeSpace::largest_part(double clearance_m) const {
  std::vector<bool> open(static_cast<std::size_t>(columns_) * rows_);
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Vector2 point = centre(static_cast<std::uint32_t>(i));
    open[i] = bounds().contains(point) && roomy(point, clearance_m);
  }
  Cells largest;
  for (std::size_t seed = 0; seed < open.size(); ++seed) {
    if (!open[seed]) continue;
    Cells cells{static_cast<std::uint32_t>(seed)};
    open[seed] = false;
    auto reach = [&](std::uint32_t from, std::uint32_t to) {
      if (!open[to] || !joined(centre(from), centre(to), clearance_m)) return;
      open[to] = false;
      cells.push_back(to);
    };
    for (std::size_t next = 0; next < cells.size(); ++next) {
      const std::uint32_t cell = cells[next], columns = static_cast<std::uint32_t>(columns_);
      if (cell % columns > 0) reach(cell, cell - 1);
      if (cell % columns + 1 < columns) reach(cell, cell + 1);
      if (cell >= columns) reach(cell, cell - columns);
      if (cell + columns < open.size()) reach(cell, cell + columns);
    }
    if (cells.size() > largest.size()) largest = std::move(cells);
  }
  std::sort(largest.begin(), largest.end());
  return largest;
}

Vector2 FreeSpace::centre(std::uint32_t cell) const noexcept {
  const double column = cell % static_cast<std::uint32_t>(columns_), row = cell / static_cast<std::uint32_t>(columns_);
  return bounds().lower + Vector2{(column + 0.5) * cell_m_, (row + 0.5) * cell_m_};
}

bool FreeSpace::roomy(Vector2 point, double clearance_m) const noexcept {
  return ground_->clearance(point, std::max(clearance_m, cell_m_)) >= clearance_m;
}

bool FreeSpace::joined(Vector2 a, Vector2 b, double clearance_m) const noexcept {
  const double apart_m = (b - a).length();
  if (clearance_m > cell_m_ || apart_m == 0) return true;
  return !ground_->cast(a, (b - a) * (1 / apart_m), apart_m);
}

}  // namespace ganglion::sim
