#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/grid/cell.h"
#include "ganglion/grid/risk_rule.h"
#include "ganglion/module/experience.h"

namespace ganglion::grid {

inline constexpr int kTileSide = 64;

/// A square of kTileSide x kTileSide cells; `column` and `row` count tiles.
struct Tile {
  std::int32_t column = 0;
  std::int32_t row = 0;
  std::string name;      ///< Of its part of what is stored: "tile -1 0".
  std::size_t part = 0;  ///< Its place among the parts.
  std::array<Cell, kTileSide * kTileSide> cells{};
};

/// How sure it is that a step failed because of this cell, and how much of an attempt that makes, in halves.
enum class FailureCause : std::uint8_t {
  Unclear = 0,    ///< It may have been another cell: see fail_diagonal().
  Untouched = 1,  ///< No other cell, but nothing was touched: perhaps the robot only slipped.
  Cell = 2,
};

/// The ground as experience has it: which cells were entered, which failed, how likely each can be crossed.
///
/// Memory   tiles added by grow_around() between ticks, at most max_tiles; nothing else allocates. Once the map is
///          full, cells outside it are not to be entered.
/// Ticks    are whatever the caller counts, ever upwards.
/// Source   "A growing functional modules locomotion subsystem", Methodology 1b; numbers ours, see RiskRule.
class RiskMap {
 public:
  /// max_tiles >= 1.
  RiskMap(int max_tiles, const RiskRule& rule);

  /// Null outside the tiles.
  const Cell* find(CellIndex cell) const noexcept;
  bool full() const noexcept { return tiles_.size() == max_tiles_; }
  /// Adds the tiles of a cell and of what lies within two steps of it. Allocates.
  void grow_around(CellIndex cell);

  /// Each does nothing outside the tiles.
  void cross(CellIndex cell) noexcept;
  /// The robot was put or found there without an attempt of its own.
  void visit(CellIndex cell) noexcept;
  void fail(CellIndex cell, std::uint32_t now, FailureCause cause = FailureCause::Cell) noexcept;
  /// A diagonal step failed, and which of its three cells blocks it is unclear: not the same way again in this round,
  /// and those that are unexplored stay so, but share the suspicion.
  void fail_diagonal(CellIndex from, int direction) noexcept;
  void book_cost(CellIndex cell, double cost_j) noexcept;

  static bool inhibited(const Cell& cell, std::uint32_t now) noexcept { return now < cell.inhibited_until; }
  /// Its attempts of this round are used up: a static cell has one, a dynamic one `dynamic_tries`.
  bool spent(const Cell& cell) const noexcept;
  /// The diagonal steps from this cell that were closed in this round, a bit each.
  std::uint8_t closed_diagonals(const Cell& cell) const noexcept {
    return cell.round == round_ ? cell.closed_diagonals : std::uint8_t{0};
  }
  void set_dynamic_tries(int tries) noexcept { dynamic_tries_ = tries; }
  void new_round() noexcept { ++round_; }
  /// The first tick after `now` at which an inhibition lapses; none when nothing is inhibited.
  std::optional<std::uint32_t> next_lapse(std::uint32_t now) const noexcept;

  /// How much dearer than the average crossing this cell is, at least 1; 1 where nothing is known.
  double cost_factor(const Cell& cell) const noexcept;
  const RiskRule& rule() const noexcept { return rule_; }
  /// Changes whenever a cell becomes harder or easier to enter.
  std::uint32_t revision() const noexcept { return revision_; }
  int explored() const noexcept { return explored_; }
  int occupied() const noexcept { return occupied_; }
  std::span<const std::unique_ptr<Tile>> tiles() const noexcept { return tiles_; }

  /// One part for the whole and one for each tile, in row order.
  std::span<const PartState> parts() const noexcept { return parts_; }
  /// Of a tile its place and its cells as they lie in memory.
  void copy(std::size_t part, std::vector<std::byte>& into) const;
  /// What is stored of copy()'s bytes: cells never explored take no room.
  static void encode(std::string_view part, std::span<const std::byte> raw, std::vector<std::byte>& stored);
  /// A map of the same limits from saved parts. Fails with Corrupt, or with Unsupported when it holds too many tiles.
  Result<RiskMap> loaded(std::span<const ExperiencePart> parts) const;

 private:
  /// To be changed.
  Cell* at(CellIndex cell) noexcept;
  void touch(std::size_t part) noexcept { parts_[part].generation = ++changes_; }
  void list_parts();
  void enter_round(Cell& cell) const noexcept;
  std::size_t slot_of(std::int32_t column, std::int32_t row) const noexcept;
  Tile* tile_at(std::int32_t column, std::int32_t row) const noexcept;
  Tile& add_tile(std::int32_t column, std::int32_t row);
  void count(Label before, Label after) noexcept;
  Result<void> load_summary(std::span<const std::byte> bytes);
  Result<void> load_tile(const ExperiencePart& part);

  static constexpr std::size_t kWholePart = 0;
  RiskRule rule_;
  std::size_t max_tiles_;
  std::vector<std::unique_ptr<Tile>> tiles_;
  std::vector<PartState> parts_;  ///< First the whole, then tiles in row order.
  std::uint64_t changes_ = 0;
  std::vector<Tile*> directory_;       ///< Hash table of the tiles, open addressing, at most half full.
  std::vector<std::uint32_t> lapses_;  ///< Ticks at which inhibitions end, each at its remainder.
  Cell whole_{};                       ///< Running mean of the cost of all crossings.
  int dynamic_tries_ = 3;
  std::uint32_t round_ = 1;
  std::uint32_t revision_ = 0;
  int explored_ = 0;
  int occupied_ = 0;
};

}  // namespace ganglion::grid
