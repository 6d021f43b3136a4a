#pragma once

#include <span>
#include <vector>

#include "ganglion/grid/goal_distance.h"

namespace ganglion::grid {

enum class Motion : std::int8_t { Forward = 1, Backward = -1 };

struct RouteStep {
  Motion motion = Motion::Forward;
  std::uint8_t direction = 0;  ///< Of travel.
  std::uint8_t heading = 0;  ///< Of the robot while and after travelling: `direction`, or its opposite going backwards.
  CellIndex from{};
  CellIndex to{};
};

struct RouterRule {
  int window_cells = 128;      ///< Side of the square in which a route is sought, its middle between start and goal.
  int max_turn = 1;            ///< Most the heading may change in a step, in eighths of a turn: 1, 2 or 4.
  double backward_weight = 2;  ///< A step backwards counts as this many forwards, >= 1 (ours: it drives blind).
};

/// Longest route kept; of a longer one the beginning.
inline constexpr std::size_t kLongestRoute = 2048;

/// Finds the cheapest route of a robot that steers like a car: a step turns the heading by at most max_turn and goes
/// one cell forwards or backwards along it. A half turn therefore needs room; corners are never cut.
///
/// Method   A* over (column, row, heading), guided by GoalDistance, which is exact but for the steering.
/// Ties     of equal estimates the state nearer to the goal goes first, then the first in row order.
/// Memory   about 170 bytes a cell of the window, taken when made; a search allocates nothing.
class Router {
 public:
  /// window_cells >= 8, max_turn in {1, 2, 4}, backward_weight in [1, 100].
  explicit Router(const RouterRule& rule);

  enum class Outcome : std::uint8_t { Found, None, TooFar };  ///< TooFar: start and goal do not fit into the window.
  /// `heading` in eighths of a turn, 0..7. The start cell may be closed, the goal must be open.
  Outcome find(const Pricing& pricing, CellIndex start, int heading, CellIndex goal) noexcept;

  /// The route found last.
  std::span<const RouteStep> route() const noexcept { return route_; }
  /// Its cost in cells of straight way, backward steps weighed.
  double cost() const noexcept { return static_cast<double>(cost_) / kStraightUnits; }
  const RouterRule& rule() const noexcept { return rule_; }

 private:
  struct State {
    std::uint32_t cost = kNever;
    std::uint16_t met = 0;
    std::uint8_t arrival = 0;  ///< Direction of travel, heading before, motion: how it was reached.
  };
  State& meet(std::uint32_t state) noexcept;
  void begin_search() noexcept;
  void expand(std::uint32_t state) noexcept;
  void reach(std::uint32_t from, int direction, Motion motion) noexcept;
  void trace(std::uint32_t start, std::uint32_t end) noexcept;

  RouterRule rule_;
  GoalDistance distance_;
  std::vector<State> states_;
  OpenList open_;
  std::vector<RouteStep> route_;
  std::uint64_t backward_extra_;  ///< What a backward step costs more, in 1/256 of its length.
  std::uint32_t cost_ = kNever;
  std::uint16_t search_ = 0;
};

}  // namespace ganglion::grid
