#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ganglion/grid/way/steered_way.h"
#include "ganglion/task/go_to/goal_ledger.h"
#include "ganglion/task/task.h"

namespace ganglion {

struct GoToConfig {
  double cell_m = 0.5;
  int goals = 20;           ///< How many to draw, where `cells` is empty.
  double sealed_share = 0;  ///< Share of the drawn goals that are free but out of reach, to see them withdrawn.
  double patience_s = 0;    ///< A goal is given up after that; 0 = never.
  int max_turn_deg = 180;   ///< Largest turn in one step, 45, 90 or 180, for steered_shortest_m; 180 = on the spot.
  std::vector<double> cell_numbers;   ///< `cells` as files have them: column, row, column, row...
  std::vector<CellGrid::Cell> cells;  ///< Goals in order, instead of drawn ones.
};

/// Sets cells for the robot to go to: the application as trainer, "App" in the GFM papers, told to the controller as
/// sensations.
/// The next goal is set when the robot stands in the goal's cell, when the controller withdraws, or when patience ends.
///
/// Channel `goal` {column, row}  the cell wanted, floor(position / cell_m); after the last outcome it keeps its value.
/// Channel `direction` [rad]     bearing of that cell's centre from the robot, in the world's frame.
/// Drawn goals are free cells that the robot's disc can step to from where the episode begins, movers aside; sealed
/// ones are free cells that it cannot. No goal is drawn twice in a row. Somebody may set a goal in place of the present
/// one, or after the last: then come the goals that were left.
/// Source    "A growing functional modules locomotion subsystem", section 5; drawing, patience, log and goals set by
///           somebody are ours.
class GoTo final : public Task {
 public:
  explicit GoTo(GoToConfig config) : config_(std::move(config)) {}
  /// Makes `cells` of cell_numbers. Fails with BadParameter unless those are pairs of whole numbers, with TooLarge where
  /// there are more than kMaxGoals pairs.
  static Result<void> judge(GoToConfig& config);

  Limits limits(std::size_t channel) const noexcept override;
  LedgerForm form() const override { return GoalLedger::form(config_.cell_m); }
  /// Fails with BadParameter without ground, body or a truth that says where the robot is; with TooLarge where the grid
  /// has too many cells.
  Result<void> settle(const TaskSetting& setting) override;
  /// Fails with BadParameter where there are no cells to draw from.
  Result<void> begin(const Outlook& now, Draws draws) override;
  void hear(const ActFrame& frame) noexcept override;
  void judge(const Outlook& now) noexcept override;
  void tell(const Outlook& now, std::span<double> values) const noexcept override;
  const Ledger* ledger() const noexcept override { return &ledger_; }

  std::span<const InterventionDescriptor> interventions() const noexcept override;
  /// "goal": the cell that holds the point is the goal from now on; gives its centre. The present goal gets its outcome,
  /// or is Replaced. Fails with BadParameter where no robot could stand at that centre, or where it is the goal already,
  /// with TooLarge after kMaxGoalsSet of them. Takes memory.
  Result<Intervened> intervene(const Outlook& now, const InterventionDescriptor& what,
                               std::span<const double> arguments) override;

  std::span<const GoalRecord> records() const noexcept { return ledger_.records(); }

  static constexpr std::size_t kMaxGoals = 10000;  ///< Its own, drawn or stated.
  static constexpr std::size_t kMaxGoalsSet = 1000;

 private:
  struct Goal {
    CellGrid::Cell cell{};
    bool reachable = true;
  };
  /// Where the truth has what is asked of it.
  struct Channels {
    std::size_t x_m = 0, y_m = 0, yaw_rad = 0, travelled_m = 0;
  };
  Vector2 position(const Outlook& now) const noexcept { return {now.truth[at_.x_m], now.truth[at_.y_m]}; }
  Result<void> draw_goals(CellGrid::Cell start, Draws& draws);
  void state_goals(CellGrid::Cell start);
  void set_next_goal(const Outlook& now) noexcept { open(now, goals_[next_++]); }
  void open(const Outlook& now, const Goal& goal) noexcept;
  void measure_ways(const Outlook& now, GoalRecord& record) noexcept;
  std::optional<GoalOutcome> outcome(const Outlook& now) const noexcept;
  void conclude(const Outlook& now, GoalOutcome outcome) noexcept;
  bool done() const noexcept;

  GoToConfig config_;
  Channels at_;
  std::optional<CellGrid> grid_;
  std::optional<CellGrid::Workspace> workspace_;
  std::optional<SteeredWay> steered_way_;  // only for robots that do not turn on the spot
  std::vector<CellGrid::Cell> taken_;      // by movers
  std::vector<Goal> goals_;                // its own
  std::size_t next_ = 0;                   // of them
  std::size_t goals_set_ = 0;              // by somebody
  CellGrid::Cell begin_;                   // where the robot was as the episode began
  GoalLedger ledger_;                      // room for all goals
  double set_s_ = 0;                       // time at which the present goal was set
  double set_travelled_m_ = 0;
  bool withdrawn_ = false;
  ReasonCode reason_ = ReasonCode::None;
};

extern const TaskKind go_to_kind;

}  // namespace ganglion
