// The layout of a saved map, version 2. Version 1 had no suspected cells.
//   "map":          f64 mean cost of all crossings, u32 crossings in that mean
//   "tile <c> <r>": i32 column, i32 row, u32 count, then for each explored or suspected cell, ascending:
//                   u32 index, u8 label + 4 * dynamic, f64 risk, f64 mean cost, u32 crossings in that mean
#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "ganglion/base/expects.h"
#include "ganglion/grid/risk_map.h"

namespace ganglion::grid {
namespace {

constexpr std::string_view kSummary = "map";
constexpr std::int32_t kFarthestTile = kFarthestCell / kTileSide;

void write_cell(ByteWriter& writer, std::uint32_t index, const Cell& cell) {
  writer.u32(index);
  writer.u8(static_cast<std::uint8_t>(static_cast<int>(cell.label) + (cell.nature == Nature::Dynamic ? 4 : 0)));
  writer.f64(cell.risk);
  writer.f64(cell.cost_j);
  writer.u32(cell.costed);
}

/// Reads all but the index. False when the values are not those of a cell worth saving.
bool read_cell(ByteReader& reader, Cell& cell) noexcept {
  const int kind = reader.u8();
  cell.label = static_cast<Label>(kind & 3);
  cell.nature = (kind & 4) != 0 ? Nature::Dynamic : Nature::Static;
  cell.risk = reader.f64();
  cell.cost_j = reader.f64();
  cell.costed = reader.u32();
  const bool suspected = kind == static_cast<int>(Label::Unexplored) && cell.costed == 0;
  const bool labelled = kind < 8 && (cell.label == Label::Empty || cell.label == Label::Occupied);
  return (labelled || suspected) && cell.risk >= 0 && cell.risk <= kMaxRisk && std::isfinite(cell.cost_j) &&
         cell.cost_j >= 0;
}

tl::unexpected<Error> corrupt(std::string_view part, const Text& wanted) {
  return fail(ErrorCode::Corrupt,
              {"part \"{}\" of the saved map is damaged, expected {}",
               "la parte \"{}\" del mapa guardado está dañada, se esperaba {}"},
              part, wanted);
}

constexpr std::size_t kTileBytes = 2 * sizeof(std::int32_t) + sizeof(Tile::cells);
static_assert(std::is_trivially_copyable_v<Cell>);

void encode_tile(std::span<const std::byte> raw, ByteWriter& writer) {
  expects(raw.size() == kTileBytes);
  std::array<std::int32_t, 2> place{};
  std::memcpy(place.data(), raw.data(), sizeof place);
  raw = raw.subspan(sizeof place);
  std::uint32_t worth = 0;
  const auto for_each_worth = [raw](auto&& what) {
    for (std::uint32_t i = 0; i < std::tuple_size_v<decltype(Tile::cells)>; ++i) {
      Cell cell;
      std::memcpy(&cell, raw.data() + i * sizeof(Cell), sizeof(Cell));
      if (cell.label != Label::Unexplored || cell.risk > 0) what(i, cell);
    }
  };
  for_each_worth([&](std::uint32_t, const Cell&) { ++worth; });
  writer.i32(place[0]);
  writer.i32(place[1]);
  writer.u32(worth);
  for_each_worth([&](std::uint32_t index, const Cell& cell) { write_cell(writer, index, cell); });
}

}  // namespace

void RiskMap::list_parts() {
  std::vector<Tile*> sorted;
  for (const auto& tile : tiles_) sorted.push_back(tile.get());
  std::sort(sorted.begin(), sorted.end(),
            [](const Tile* a, const Tile* b) { return a->row != b->row ? a->row < b->row : a->column < b->column; });
  const std::vector<PartState> before = std::move(parts_);
  parts_ = {{kSummary, before.empty() ? ++changes_ : before.front().generation}};
  for (Tile* tile : sorted) {
    const bool known = !tile->name.empty();
    if (!known) tile->name = fmt::format("tile {} {}", tile->column, tile->row);
    parts_.push_back({tile->name, known ? before[tile->part].generation : ++changes_});
    tile->part = parts_.size() - 1;
  }
}

void RiskMap::copy(std::size_t part, std::vector<std::byte>& into) const {
  if (part == kWholePart) {
    ByteWriter writer(std::move(into));
    writer.f64(whole_.cost_j);
    writer.u32(whole_.costed);
    into = writer.take();
    return;
  }
  const auto found = std::find_if(tiles_.begin(), tiles_.end(), [part](const auto& one) { return one->part == part; });
  expects(found != tiles_.end());
  const Tile& tile = **found;
  const std::array place = {tile.column, tile.row};
  into.resize(kTileBytes);
  std::memcpy(into.data(), place.data(), sizeof place);
  std::memcpy(into.data() + sizeof place, tile.cells.data(), sizeof tile.cells);
}

void RiskMap::encode(std::string_view part, std::span<const std::byte> raw, std::vector<std::byte>& stored) {
  if (part == kSummary) {
    stored.assign(raw.begin(), raw.end());
    return;
  }
  ByteWriter writer(std::move(stored));
  encode_tile(raw, writer);
  stored = writer.take();
}

Result<RiskMap> RiskMap::loaded(std::span<const ExperiencePart> parts) const {
  if (parts.size() > max_tiles_ + 1) {
    return ganglion::fail(
        ErrorCode::Unsupported,
        {"the saved map has {} tiles, max_tiles is {}", "el mapa guardado tiene {} bloques, max_tiles es {}"},
        parts.size() - 1, max_tiles_);
  }
  RiskMap map(static_cast<int>(max_tiles_), rule_);
  map.dynamic_tries_ = dynamic_tries_;
  for (const ExperiencePart& part : parts) {
    const auto taken = part.name == kSummary ? map.load_summary(part.bytes) : map.load_tile(part);
    if (!taken) return tl::unexpected<Error>(taken.error());
  }
  map.revision_ = revision_ + 1;
  map.changes_ += changes_;
  for (PartState& part : map.parts_) part.generation += changes_;  // none that one of these parts has had
  return map;
}

Result<void> RiskMap::load_summary(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  whole_.cost_j = reader.f64();
  whole_.costed = reader.u32();
  if (!reader.complete() || !std::isfinite(whole_.cost_j) || whole_.cost_j < 0) {
    return corrupt(kSummary, {"a finite cost >= 0 and a count", "un costo finito >= 0 y un recuento"});
  }
  return {};
}

Result<void> RiskMap::load_tile(const ExperiencePart& part) {
  ByteReader reader(part.bytes);
  const std::int32_t column = reader.i32();
  const std::int32_t row = reader.i32();
  const std::uint32_t count_saved = reader.u32();
  const bool placed = std::abs(std::int64_t{column}) < kFarthestTile && std::abs(std::int64_t{row}) < kFarthestTile;
  if (!reader.ok() || !placed)
    return corrupt(part.name,
                   {"a tile's column, row and number of cells", "columna, fila y número de celdas de un bloque"});
  if (tile_at(column, row) != nullptr || full()) return corrupt(part.name, {"each tile once", "cada bloque una vez"});
  Tile& tile = add_tile(column, row);
  std::int64_t previous = -1;
  for (std::uint32_t i = 0; i < count_saved; ++i) {
    const std::int64_t index = reader.u32();
    Cell cell;
    const bool sound = read_cell(reader, cell);
    if (!reader.ok() || !sound || index <= previous || index >= std::ssize(tile.cells)) {
      return corrupt(part.name, {"explored cells in ascending order", "celdas exploradas en orden ascendente"});
    }
    tile.cells[static_cast<std::size_t>(index)] = cell;
    count(Label::Unexplored, cell.label);
    previous = index;
  }
  if (!reader.complete()) return corrupt(part.name, {"nothing after its last cell", "nada tras su última celda"});
  return {};
}

}  // namespace ganglion::grid
