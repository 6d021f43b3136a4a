#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "ganglion/module/tick/command.h"
#include "ganglion/sim/world/way/cell_grid.h"

namespace ganglion::sim {

/// What became of a goal that a trainer set.
enum class GoalOutcome : std::uint8_t {
  Open,       ///< Still wanted when the run ended.
  Reached,    ///< The robot stood in the goal's cell.
  Withdrawn,  ///< The controller gave it up.
  TimedOut,   ///< The trainer's patience ran out.
  Replaced,   ///< Somebody set another goal instead.
};
std::string_view name_of(GoalOutcome) noexcept;

/// One goal of a trainer. Cells: floor(position / cell_m).
struct GoalRecord {
  std::uint32_t tick = 0;  ///< When it was set.
  CellGrid::Cell start{};  ///< Where the robot was then.
  CellGrid::Cell goal{};
  bool reachable = true;  ///< Whether any way led there from the start of the run, movers aside.
  double shortest_m = std::numeric_limits<double>::infinity();  ///< From `start`, movers as they stood; +inf = no way.
  double static_shortest_m = std::numeric_limits<double>::infinity();  ///< The same without movers.
  /// `static_shortest_m` for a robot with the heading of that moment and the trainer's max_turn_deg.
  double steered_shortest_m = std::numeric_limits<double>::infinity();
  double travelled_m = 0;
  std::uint32_t ticks = 0;  ///< From setting to the outcome.
  GoalOutcome outcome = GoalOutcome::Open;
  ReasonCode reason = ReasonCode::None;  ///< Of a withdrawal.
};

/// What a trainer knows of its goals.
class TrainerLog {
 public:
  virtual ~TrainerLog() = default;
  /// The goals set so far, in order.
  virtual std::span<const GoalRecord> records() const noexcept = 0;
  /// Every goal has its outcome.
  virtual bool done() const noexcept = 0;
};

}  // namespace ganglion::sim
