#include "ganglion/grid/risk_map.h"

#include <algorithm>
#include <bit>

#include "ganglion/base/expects.h"

namespace ganglion::grid {
namespace {

// Arithmetic shift: cells -64..-1 belong to tile -1.
constexpr int kTileShift = 6;
static_assert(1 << kTileShift == kTileSide);

constexpr std::size_t within_tile(CellIndex cell) noexcept {
  return static_cast<std::size_t>((cell.row & (kTileSide - 1)) * kTileSide + (cell.column & (kTileSide - 1)));
}

}  // namespace

RiskMap::RiskMap(int max_tiles, const RiskRule& rule)
    : rule_(rule),
      max_tiles_(static_cast<std::size_t>(max_tiles)),
      directory_(std::bit_ceil(2 * static_cast<std::size_t>(max_tiles)), nullptr),
      lapses_(rule.inhibition_base + rule.inhibition_span + 1u, 0) {
  expects(max_tiles >= 1);
  tiles_.reserve(max_tiles_);
  list_parts();
}

std::size_t RiskMap::slot_of(std::int32_t column, std::int32_t row) const noexcept {
  const auto mixed = static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) * 0x9E3779B97F4A7C15u +
                     static_cast<std::uint64_t>(static_cast<std::uint32_t>(row)) * 0xC2B2AE3D27D4EB4Fu;
  std::size_t slot = (mixed >> 32) & (directory_.size() - 1);
  while (directory_[slot] != nullptr && (directory_[slot]->column != column || directory_[slot]->row != row)) {
    slot = (slot + 1) & (directory_.size() - 1);
  }
  return slot;
}

Tile* RiskMap::tile_at(std::int32_t column, std::int32_t row) const noexcept {
  return directory_[slot_of(column, row)];
}

const Cell* RiskMap::find(CellIndex cell) const noexcept {
  const Tile* tile = tile_at(cell.column >> kTileShift, cell.row >> kTileShift);
  return tile == nullptr ? nullptr : &tile->cells[within_tile(cell)];
}

Cell* RiskMap::at(CellIndex cell) noexcept {
  Tile* tile = tile_at(cell.column >> kTileShift, cell.row >> kTileShift);
  if (tile == nullptr) return nullptr;
  touch(tile->part);
  return &tile->cells[within_tile(cell)];
}

Tile& RiskMap::add_tile(std::int32_t column, std::int32_t row) {
  expects(!full());
  tiles_.push_back(std::make_unique<Tile>());
  Tile& tile = *tiles_.back();
  tile.column = column;
  tile.row = row;
  directory_[slot_of(column, row)] = &tile;
  list_parts();
  ++revision_;
  return tile;
}

void RiskMap::grow_around(CellIndex cell) {
  constexpr std::array<CellIndex, 5> kReach = {{{0, 0}, {-2, -2}, {2, -2}, {-2, 2}, {2, 2}}};
  for (const CellIndex offset : kReach) {
    const std::int32_t column = (cell.column + offset.column) >> kTileShift;
    const std::int32_t row = (cell.row + offset.row) >> kTileShift;
    if (!full() && tile_at(column, row) == nullptr) add_tile(column, row);
  }
}

void RiskMap::count(Label before, Label after) noexcept {
  explored_ += (after != Label::Unexplored) - (before != Label::Unexplored);
  occupied_ += (after == Label::Occupied) - (before == Label::Occupied);
}

void RiskMap::cross(CellIndex index) noexcept {
  Cell* cell = at(index);
  if (cell == nullptr) return;
  const Cell before = *cell;
  note_crossing(*cell, rule_);
  count(before.label, cell->label);
  if (before.label != cell->label || before.risk != cell->risk) ++revision_;
}

void RiskMap::visit(CellIndex index) noexcept {
  const Cell* cell = find(index);
  if (cell != nullptr && cell->label != Label::Empty) cross(index);
}

void RiskMap::fail(CellIndex index, std::uint32_t now, FailureCause cause) noexcept {
  Cell* cell = at(index);
  if (cell == nullptr) return;
  const Label before = cell->label;
  note_failure(*cell, rule_);
  count(before, cell->label);
  cell->inhibited_until = now + inhibition_ticks(cell->risk, rule_);
  lapses_[cell->inhibited_until % lapses_.size()] = cell->inhibited_until;
  enter_round(*cell);
  cell->strain = static_cast<std::uint8_t>(std::min(255, cell->strain + static_cast<int>(cause)));
  ++revision_;
}

void RiskMap::enter_round(Cell& cell) const noexcept {
  if (cell.round == round_) return;
  cell.round = round_;
  cell.strain = 0;
  cell.closed_diagonals = 0;
}

void RiskMap::fail_diagonal(CellIndex from, int direction) noexcept {
  Cell* cell = at(from);
  if (cell == nullptr) return;
  enter_round(*cell);
  cell->closed_diagonals = static_cast<std::uint8_t>(cell->closed_diagonals | 1 << (direction / 2));
  std::array<Cell*, 3> suspects{};
  std::size_t count = 0;
  for (const int turn : {-1, 0, 1}) {
    Cell* suspect = at(neighbour(from, turned(direction, turn)));
    if (suspect != nullptr && suspect->label == Label::Unexplored) suspects[count++] = suspect;
  }
  for (std::size_t n = 0; n < count; ++n) suspects[n]->risk = std::max(suspects[n]->risk, suspicion(count));
  ++revision_;
}

void RiskMap::book_cost(CellIndex index, double cost_j) noexcept {
  Cell* cell = at(index);
  if (cell == nullptr) return;
  note_cost(*cell, cost_j);
  note_cost(whole_, cost_j);
  touch(kWholePart);
}

bool RiskMap::spent(const Cell& cell) const noexcept {
  return cell.round == round_ && cell.strain >= 2 * (cell.nature == Nature::Static ? 1 : dynamic_tries_);
}

std::optional<std::uint32_t> RiskMap::next_lapse(std::uint32_t now) const noexcept {
  std::optional<std::uint32_t> next;
  for (const std::uint32_t lapse : lapses_) {
    if (lapse > now && (!next || lapse < *next)) next = lapse;
  }
  return next;
}

double RiskMap::cost_factor(const Cell& cell) const noexcept {
  constexpr double kDearest = 20;  // a cell that once took a hundredfold is no worse than a long detour
  if (cell.costed == 0 || !(whole_.cost_j > 0)) return 1;
  return std::clamp(cell.cost_j / whole_.cost_j, 1.0, kDearest);
}

}  // namespace ganglion::grid
