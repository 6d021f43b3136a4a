#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "ganglion/base/base64.h"
#include "ganglion/plot/json_view.h"

namespace ganglion::plot {
namespace {

constexpr int kByteField = 1;  // foxglove.PackedElementField: UINT8

/// Where the bytes of a foxglove.Grid lie.
struct Layout {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::size_t row_stride = 0;
  std::size_t cell_stride = 0;
};

std::optional<Layout> layout_of(const Json& grid, std::size_t bytes) {
  const double columns = number_in(grid, "column_count");
  const double row_stride = number_in(grid, "row_stride");
  const double cell_stride = number_in(grid, "cell_stride");
  const double most = static_cast<double>(kMaxGridCells);
  if (!(columns >= 1 && columns <= most && cell_stride >= 1 && cell_stride <= 64)) return std::nullopt;
  if (!(row_stride >= columns * cell_stride && row_stride <= 64 * most)) return std::nullopt;
  Layout layout{static_cast<std::size_t>(columns), 0, static_cast<std::size_t>(row_stride),
                static_cast<std::size_t>(cell_stride)};
  layout.rows = bytes / layout.row_stride;
  if (layout.rows == 0 || layout.columns * layout.rows > kMaxGridCells) return std::nullopt;
  return layout;
}

/// One field of every cell; empty where the grid has no such field of one byte.
std::vector<std::uint8_t> layer(const Json& grid, const std::vector<std::uint8_t>& bytes, const Layout& layout,
                                std::string_view name) {
  const auto fields = grid.find("fields");
  if (fields == grid.end() || !fields->is_array()) return {};
  for (const Json& field : *fields) {
    const double offset = number_in(field, "offset", -1);
    if (text_in(field, "name") != name || number_in(field, "type") != kByteField) continue;
    if (!(offset >= 0 && offset < static_cast<double>(layout.cell_stride))) continue;
    std::vector<std::uint8_t> values;
    values.reserve(layout.columns * layout.rows);
    for (std::size_t row = 0; row < layout.rows; ++row)
      for (std::size_t column = 0; column < layout.columns; ++column)
        values.push_back(
            bytes[row * layout.row_stride + column * layout.cell_stride + static_cast<std::size_t>(offset)]);
    return values;
  }
  return {};
}

/// Labels are written as 0, 1, 2 or, by recorders that stretch every layer over a byte, as 0, 128, 255.
std::uint8_t label_of(std::uint8_t byte, std::uint8_t risk) noexcept {
  if (byte == 2 || byte >= 192) return static_cast<std::uint8_t>(CellLabel::Occupied);
  return static_cast<std::uint8_t>(byte > 0 || risk > 0 ? CellLabel::Empty : CellLabel::Unexplored);
}

}  // namespace

std::optional<GridFrame> grid_from(const Json& grid, double time_s) {
  const auto bytes = base64_bytes(text_in(grid, "data"));
  const auto layout = bytes ? layout_of(grid, bytes->size()) : std::nullopt;
  if (!layout) return std::nullopt;
  const Json& pose = grid.contains("pose") ? grid.at("pose") : grid;
  const Json& position = pose.is_object() && pose.contains("position") ? pose.at("position") : grid;
  GridFrame result;
  result.cell_m = grid.contains("cell_size") ? number_in(grid.at("cell_size"), "x") : 0;
  if (!(result.cell_m > 0)) return std::nullopt;
  MapFrame& frame = result.frame;
  frame = {time_s,
           {number_in(position, "x"), number_in(position, "y")},
           static_cast<int>(layout->columns),
           static_cast<int>(layout->rows),
           layer(grid, *bytes, *layout, "label"),
           layer(grid, *bytes, *layout, "risk"),
           layer(grid, *bytes, *layout, "dynamic"),
           layer(grid, *bytes, *layout, "inhibited")};
  const std::size_t cells = layout->columns * layout->rows;
  frame.risk.resize(cells, 0);
  frame.label.resize(cells, 0);
  frame.inhibited.resize(cells, 0);
  for (std::size_t i = 0; i < cells; ++i) frame.label[i] = label_of(frame.label[i], frame.risk[i]);
  if (const auto fixed = layer(grid, *bytes, *layout, "static"); frame.dynamic.empty() && !fixed.empty())
    for (std::size_t i = 0; i < cells; ++i) frame.dynamic.push_back(frame.label[i] != 0 && fixed[i] == 0);
  frame.dynamic.resize(cells, 0);
  return result;
}

}  // namespace ganglion::plot
