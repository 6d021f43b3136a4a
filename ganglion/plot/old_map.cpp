#include <algorithm>
#include <string_view>

#include "ganglion/base/base64.h"
#include "ganglion/plot/json_view.h"
#include "ganglion/plot/old_run_file.h"
#include "ganglion/record/exhibit/exhibit_codec.h"

namespace ganglion::plot {
namespace {

constexpr std::size_t kMaxCells = kMostCells;
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
  const double most = static_cast<double>(kMaxCells);
  if (!(columns >= 1 && columns <= most && cell_stride >= 1 && cell_stride <= 64)) return std::nullopt;
  if (!(row_stride >= columns * cell_stride && row_stride <= 64 * most)) return std::nullopt;
  Layout layout{static_cast<std::size_t>(columns), 0, static_cast<std::size_t>(row_stride),
                static_cast<std::size_t>(cell_stride)};
  layout.rows = bytes / layout.row_stride;
  if (layout.rows == 0 || layout.columns * layout.rows > kMaxCells) return std::nullopt;
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

/// What was recorded of the cells, as it stands in the message.
struct Recorded {
  std::vector<std::uint8_t> label, risk, dynamic, fixed, inhibited;

  static std::uint8_t at(const std::vector<std::uint8_t>& layer, std::size_t cell) noexcept {
    return cell < layer.size() ? layer[cell] : std::uint8_t{0};
  }
  /// Labels are written as 0, 1, 2 or, by recorders that stretch every layer over a byte, as 0, 128, 255.
  bool is_occupied(std::size_t cell) const noexcept { return at(label, cell) == 2 || at(label, cell) >= 192; }
  bool is_known(std::size_t cell) const noexcept {
    return at(label, cell) > 0 || at(risk, cell) > 0 || at(inhibited, cell) > 0;
  }
  bool is_dynamic(std::size_t cell) const noexcept {
    if (!dynamic.empty()) return at(dynamic, cell) > 0;
    return !fixed.empty() && at(label, cell) > 0 && at(fixed, cell) == 0;
  }
};

std::vector<shown::Layer> layers_of_a_map() {
  using Classes = std::vector<shown::Class>;
  const auto layer = [](const char* name, Sentence title, Classes classes) {
    return shown::Layer{name, std::move(title), "", 0, 1, std::move(classes)};
  };
  return {
      layer("label", {"cells", "celdas"},
            {{0.5, Role::Free, {"empty cell", "celda vacía"}}, {1, Role::Solid, {"occupied cell", "celda ocupada"}}}),
      layer("risk", {"risk", "riesgo"}, {}),
      layer(
          "static", {"nature", "naturaleza"},
          {{0, Role::Moving, {"dynamic cell", "celda dinámica"}}, {1, Role::Plain, {"static cell", "celda estática"}}}),
      layer("inhibited", {"inhibition", "inhibición"},
            {{0, Role::Free, {"not inhibited", "no inhibida"}},
             {1, Role::Danger, {"inhibited cell", "celda inhibida"}}})};
}

}  // namespace

std::optional<shown::Field> old_map(const Json& grid) {
  const auto bytes = base64_bytes(text_in(grid, "data"));
  const auto layout = bytes ? layout_of(grid, bytes->size()) : std::nullopt;
  if (!layout) return std::nullopt;
  const Json& pose = grid.contains("pose") ? grid.at("pose") : grid;
  const Json& position = pose.is_object() && pose.contains("position") ? pose.at("position") : grid;
  const double cell_m = grid.contains("cell_size") ? number_in(grid.at("cell_size"), "x") : 0;
  if (!(cell_m > 0 && cell_m < 1e6)) return std::nullopt;
  const Recorded cells{layer(grid, *bytes, *layout, "label"), layer(grid, *bytes, *layout, "risk"),
                       layer(grid, *bytes, *layout, "dynamic"), layer(grid, *bytes, *layout, "static"),
                       layer(grid, *bytes, *layout, "inhibited")};
  shown::Field field;
  field.frame = "world";
  field.origin = {number_in(position, "x"), number_in(position, "y")};
  field.cell = {cell_m, cell_m};
  field.columns = static_cast<int>(layout->columns);
  field.rows = static_cast<int>(layout->rows);
  field.layers = layers_of_a_map();
  const std::size_t count = layout->columns * layout->rows;
  field.cells.assign(4, std::vector<std::uint8_t>(count, shown::kUnknownCell));
  for (std::size_t cell = 0; cell < count; ++cell) {
    if (!cells.is_known(cell)) continue;
    field.cells[0][cell] = field.layers[0].byte_of(cells.is_occupied(cell) ? 1 : 0.5);
    field.cells[1][cell] = field.layers[1].byte_of(Recorded::at(cells.risk, cell) / 255.0);
    field.cells[2][cell] = field.layers[2].byte_of(cells.is_dynamic(cell) ? 0 : 1);
    field.cells[3][cell] = field.layers[3].byte_of(Recorded::at(cells.inhibited, cell) > 0 ? 1 : 0);
  }
  return field;
}

}  // namespace ganglion::plot
