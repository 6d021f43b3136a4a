#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "ganglion/application/ledger.h"
#include "ganglion/base/reason_code.h"
#include "ganglion/grid/way/cell_grid.h"

namespace ganglion {

/// What became of a goal. The numbers stand in ledgers and files.
enum class GoalOutcome : std::uint8_t {
  Open = 0,       ///< Still wanted when the run ended.
  Reached = 1,    ///< The robot stood in the goal's cell.
  Withdrawn = 2,  ///< The controller gave it up.
  TimedOut = 3,   ///< The task's patience ran out.
  Replaced = 4,   ///< Somebody set another goal instead.
};

/// One goal. Cells: floor(position / cell_m).
struct GoalRecord {
  std::uint32_t tick = 0;  ///< When it was set.
  CellGrid::Cell start{};  ///< Where the robot was then.
  CellGrid::Cell goal{};
  bool reachable = true;  ///< Whether any way led there from the start of the run, movers aside.
  double shortest_m = std::numeric_limits<double>::infinity();  ///< From `start`, movers as they stood; +inf = no way.
  double static_shortest_m = std::numeric_limits<double>::infinity();  ///< The same without movers.
  /// `static_shortest_m` for a robot with the heading of that moment and the task's max_turn_deg.
  double steered_shortest_m = std::numeric_limits<double>::infinity();
  double travelled_m = 0;
  std::uint32_t ticks = 0;  ///< From setting to the outcome.
  GoalOutcome outcome = GoalOutcome::Open;
  ReasonCode reason = ReasonCode::None;  ///< Of a withdrawal.
  Vector2 centre{};                      ///< Of the goal's cell.
};

/// The goals set so far, in order, as rows of named numbers.
class GoalLedger final : public Ledger {
 public:
  /// In cells of that size.
  static LedgerForm form(double cell_m);

  std::span<const LedgerColumn> columns() const noexcept override;
  std::size_t rows() const noexcept override { return records_.size(); }
  double at(std::size_t row, std::size_t column) const noexcept override;
  bool done() const noexcept override { return done_; }
  std::uint64_t changes() const noexcept override { return changes_; }

  void clear() noexcept { records_.clear(), done_ = false, ++changes_; }
  void reserve(std::size_t goals) { records_.reserve(goals); }
  void open(const GoalRecord& record) noexcept { records_.push_back(record), done_ = false, ++changes_; }
  const GoalRecord& last() const noexcept { return records_.back(); }
  /// The last, to be concluded.
  GoalRecord& concluding() noexcept { return ++changes_, records_.back(); }
  void set_done(bool done) noexcept { changes_ += done != done_ ? 1 : 0, done_ = done; }
  std::span<const GoalRecord> records() const noexcept { return records_; }

 private:
  std::vector<GoalRecord> records_;
  bool done_ = false;
  std::uint64_t changes_ = 0;
};

}  // namespace ganglion
