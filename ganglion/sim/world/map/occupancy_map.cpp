#include "ganglion/sim/world/map/occupancy_map.h"

#include "ganglion/base/expects.h"

namespace ganglion::sim {

OccupancyMap::OccupancyMap(int columns, int rows, double resolution_m, const Pose2& origin,
                           std::vector<Occupancy> cells)
    : columns_(columns),
      rows_(rows),
      resolution_m_(resolution_m),
      origin_(origin),
      along_(direction(origin.yaw.rad())),
      cells_(std::move(cells)) {
  expects(columns >= 1 && rows >= 1 && resolution_m > 0);
  expects(cells_.size() == static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
}

Occupancy OccupancyMap::at(Vector2 point) const noexcept {
  const Vector2 away = point - origin_.position;
  const double column = std::floor(away.dot(along_) / resolution_m_);
  const double row = std::floor(away.dot(along_.left()) / resolution_m_);
  if (!(column >= 0 && row >= 0 && column < columns_ && row < rows_)) return Occupancy::Unknown;
  return at(static_cast<int>(column), static_cast<int>(row));
}

std::array<std::size_t, 3> OccupancyMap::counts() const noexcept {
  std::array<std::size_t, 3> counts{};
  for (const Occupancy cell : cells_) ++counts[static_cast<std::size_t>(cell)];
  return counts;
}

Vector2 OccupancyMap::corner(int column, int row) const noexcept {
  return origin_.position + along_ * (column * resolution_m_) + along_.left() * (row * resolution_m_);
}

Box2 OccupancyMap::bounds() const noexcept {
  Box2 box = empty_box();
  for (const int column : {0, columns_}) {
    for (const int row : {0, rows_}) box.include(corner(column, row));
  }
  return box;
}

std::vector<std::pair<Vector2, Vector2>> OccupancyMap::borders(std::size_t limit) const {
  std::vector<std::pair<Vector2, Vector2>> found;
  // Along each line of the raster: the cell to the line's left against the one to its right.
  auto run_along = [&](int lines, int length, auto left_free, auto right_free, auto corner_at) {
    for (int line = 0; line <= lines && found.size() <= limit; ++line) {
      int start = 0, way = 0;  // +1: solid to the left, -1: solid to the right, 0: no border
      for (int at = 0; at <= length; ++at) {
        const int here = at == length ? 0 : int{right_free(line, at)} - int{left_free(line, at)};
        if (here == way) continue;
        if (way > 0) found.emplace_back(corner_at(line, start), corner_at(line, at));
        if (way < 0) found.emplace_back(corner_at(line, at), corner_at(line, start));
        way = here;
        start = at;
      }
    }
  };
  run_along(
      rows_, columns_, [&](int row, int column) { return free(column, row); },
      [&](int row, int column) { return free(column, row - 1); },
      [&](int row, int column) { return corner(column, row); });
  run_along(
      columns_, rows_, [&](int column, int row) { return free(column - 1, row); },
      [&](int column, int row) { return free(column, row); }, [&](int column, int row) { return corner(column, row); });
  return found;
}

}  // namespace ganglion::sim
