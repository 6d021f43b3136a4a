#include "ganglion/report/map_changes.h"

#include <algorithm>
#include <cmath>

namespace ganglion::report {
namespace {

std::uint32_t layer_at(const std::vector<std::uint8_t>& layer, std::size_t i) noexcept {
  return i < layer.size() ? layer[i] : 0;
}

std::uint32_t packed_cell(const plot::MapFrame& frame, std::size_t i) noexcept {
  return layer_at(frame.risk, i) | layer_at(frame.inhibited, i) << 8 | (layer_at(frame.label, i) & 3) << 16 |
         (layer_at(frame.dynamic, i) != 0 ? 1u << 18 : 0u);
}

/// A frame's lower corner in whole cells from the map's first frame.
struct Corner {
  long column = 0;
  long row = 0;
};

Corner corner_of(const plot::MapView& map, const plot::MapFrame& frame) noexcept {
  const Vector2 from = (frame.origin - map.frames.front().origin) * (1 / map.cell_m);
  return {std::lround(from.x), std::lround(from.y)};
}

/// Calls `use(column, row, packed)` for every cell of a frame that is not blank.
template <class Use>
void for_each_cell(const plot::MapView& map, const plot::MapFrame& frame, Use use) {
  const Corner corner = corner_of(map, frame);
  for (int row = 0; row < frame.rows; ++row)
    for (int column = 0; column < frame.columns; ++column)
      if (const auto cell = packed_cell(frame, static_cast<std::size_t>(row) * frame.columns + column); cell != 0)
        use(corner.column + column, corner.row + row, cell);
}

/// The grid over all explored cells; its lower corner in whole cells.
Corner make_grid(const plot::MapView& map, MapChanges& result) {
  Corner lower{1L << 40, 1L << 40};
  Corner upper{-(1L << 40), -(1L << 40)};
  for (const plot::MapFrame& frame : map.frames)
    for_each_cell(map, frame, [&](long column, long row, std::uint32_t) {
      lower = {std::min(lower.column, column), std::min(lower.row, row)};
      upper = {std::max(upper.column, column + 1), std::max(upper.row, row + 1)};
    });
  if (lower.column >= upper.column) return {};
  result.origin = map.frames.front().origin +
                  Vector2{static_cast<double>(lower.column), static_cast<double>(lower.row)} * map.cell_m;
  result.columns = static_cast<int>(upper.column - lower.column);
  result.rows = static_cast<int>(upper.row - lower.row);
  return lower;
}

std::size_t collect(const plot::MapView& map, Corner lower, std::size_t every, MapChanges& result) {
  const std::size_t cells = static_cast<std::size_t>(result.columns) * result.rows;
  std::vector<std::uint32_t> known(cells, 0);
  std::size_t total = 0;
  result.frames.clear();
  for (std::size_t i = 0; i < map.frames.size(); ++i) {
    if (i % every != 0 && i + 1 != map.frames.size()) continue;
    std::vector<std::uint32_t> now(cells, 0);
    for_each_cell(map, map.frames[i], [&](long column, long row, std::uint32_t cell) {
      now[static_cast<std::size_t>(row - lower.row) * result.columns +
          static_cast<std::size_t>(column - lower.column)] = cell;
    });
    MapChanges::Frame frame{map.frames[i].time_s, {}};
    for (std::size_t k = 0; k < cells; ++k)
      if (now[k] != known[k]) frame.changes.insert(frame.changes.end(), {static_cast<std::uint32_t>(k), now[k]});
    total += frame.changes.size() / 2;
    known = std::move(now);
    if (!frame.changes.empty()) result.frames.push_back(std::move(frame));
  }
  return total;
}

}  // namespace

MapChanges changes_of(const plot::MapView& map, std::size_t max_changes, std::size_t max_cells) {
  MapChanges result;
  if (map.frames.empty() || !(map.cell_m > 0)) return result;
  const Corner lower = make_grid(map, result);
  if (static_cast<std::size_t>(result.columns) * result.rows > max_cells) return {};
  if (result.columns == 0) return {};
  for (std::size_t every = 1; collect(map, lower, every, result) > max_changes && every < map.frames.size();)
    every *= 2;
  return result;
}

}  // namespace ganglion::report
