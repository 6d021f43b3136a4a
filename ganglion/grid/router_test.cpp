#include "ganglion/grid/router.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace ganglion::grid {
namespace {

constexpr double kSqrt2 = std::numbers::sqrt2;

/// A map drawn with the first line on top: '#' occupied, '.' empty, ' ' unexplored.
RiskMap drawn(const std::vector<std::string>& lines) {
  RiskMap map(16, {});
  const int rows = static_cast<int>(lines.size());
  for (int row = 0; row < rows; ++row) {
    const std::string& line = lines[static_cast<std::size_t>(rows - 1 - row)];
    for (int column = 0; column < static_cast<int>(line.size()); ++column) {
      const CellIndex cell{column, row};
      map.grow_around(cell);
      if (line[static_cast<std::size_t>(column)] == '.') map.cross(cell);
      if (line[static_cast<std::size_t>(column)] == '#') map.fail(cell, 0);
    }
  }
  map.new_round();
  return map;
}

constexpr std::uint32_t kLater = 1000;  // a tick at which every inhibition has lapsed

Pricing secure(const RiskMap& map) { return {map, {}, Query::Secure, kLater}; }
Pricing feasible(const RiskMap& map) { return {map, {}, Query::Feasible, kLater}; }

TEST(Pricing, AllowsOnlyUnexploredAndLittleRiskyEmptyCellsInASecureRoute) {
  RiskMap map = drawn({"..#"});
  EXPECT_TRUE(secure(map).may_enter({0, 0}));
  EXPECT_FALSE(secure(map).may_enter({2, 0}));
  EXPECT_TRUE(secure(map).may_enter({5, 5}));
  EXPECT_TRUE(secure(map).may_enter({500, 500}));  // beyond the tiles
  for (int i = 0; i < 3; ++i) map.fail({1, 0}, 0);
  map.cross({1, 0});  // 0.2, 0.32, 0.422, then * 0.7 = 0.2954: empty, but not secure
  EXPECT_FALSE(secure(map).may_enter({1, 0}));
  map.cross({1, 0});  // 0.20678
  EXPECT_FALSE(secure(map).may_enter({1, 0}));
  map.cross({1, 0});  // 0.144746
  EXPECT_TRUE(secure(map).may_enter({1, 0}));
}

TEST(Pricing, PaysForRiskInAFeasibleRoute) {
  const RiskMap map = drawn({".#"});
  const Price price = feasible(map)({1, 0});
  EXPECT_EQ(price.straight, 13860u);
  EXPECT_EQ(price.diagonal, 19601u);
  EXPECT_NEAR(price.risk / 13860.0, 0.892574, 1e-4);  // -4 ln 0.8
  EXPECT_EQ(feasible(map)({0, 0}).risk, 0u);
}

TEST(Pricing, ClosesGroundOutsideAFullMap) {
  RiskMap map(1, {});
  map.grow_around({10, 10});
  EXPECT_TRUE(secure(map).may_enter({63, 63}));
  EXPECT_FALSE(secure(map).may_enter({64, 0}));
  EXPECT_FALSE(feasible(map).may_enter({64, 0}));
}

TEST(Router, DrivesStraightToAGoalAhead) {
  const RiskMap map = drawn({"....."});
  Router router({});
  ASSERT_EQ(router.find(secure(map), {0, 0}, 0, {4, 0}), Router::Outcome::Found);
  ASSERT_EQ(router.route().size(), 4u);
  for (const RouteStep& step : router.route()) {
    EXPECT_EQ(step.motion, Motion::Forward);
    EXPECT_EQ(step.direction, 0);
  }
  EXPECT_EQ(router.cost(), 4);
}

TEST(Router, BacksOutOfAPassageTooNarrowToTurnIn) {
  const RiskMap map = drawn({"#####", ".....", "#####"});
  Router router({});
  const Pricing closed{map, {}, Query::Secure, 0};
  ASSERT_EQ(router.find(closed, {4, 1}, 0, {0, 1}), Router::Outcome::Found);
  EXPECT_EQ(router.cost(), 8);  // four steps, backwards at 2
  EXPECT_EQ(router.route()[0].motion, Motion::Backward);
  EXPECT_EQ(router.route()[0].direction, 4);
  EXPECT_EQ(router.route()[0].heading, 0);
}

TEST(Router, CutsNoCorner) {
  const RiskMap map = drawn({"...", "#..", "..."});  // the corner stands between (0,0) and (1,1)
  Router router({.max_turn = 4});
  ASSERT_EQ(router.find(secure(map), {0, 0}, 1, {1, 1}), Router::Outcome::Found);
  EXPECT_EQ(router.cost(), 2);
}

int backward_steps(const Router& router) {
  return static_cast<int>(std::count_if(router.route().begin(), router.route().end(),
                                        [](const RouteStep& step) { return step.motion == Motion::Backward; }));
}

TEST(Router, TurnsRoundOnlyWhereThereIsRoom) {
  // A goal far behind: in a wide room the robot turns round, in a passage it cannot and backs all the way.
  const std::string wide = "#" + std::string(40, '.') + "#";
  const std::string wall(42, '#');
  const RiskMap room = drawn({wall, wide, wide, wide, wide, wide, wall});
  const RiskMap passage = drawn({wall, wide, wall});
  Router router({});
  ASSERT_EQ(router.find(secure(room), {30, 3}, 0, {2, 3}), Router::Outcome::Found);
  EXPECT_LE(backward_steps(router), 3);
  EXPECT_LT(router.cost(), 2 * 28);
  ASSERT_EQ(router.find(secure(passage), {30, 1}, 0, {2, 1}), Router::Outcome::Found);
  EXPECT_EQ(backward_steps(router), 28);
}

TEST(Router, TakesTheFirstInRowOrderOfEqualRoutes) {
  const RiskMap map = drawn({".....", ".....", "..#..", ".....", "....."});
  Router router({});
  ASSERT_EQ(router.find(secure(map), {0, 2}, 0, {4, 2}), Router::Outcome::Found);
  const auto passes = [&](CellIndex cell) {
    return std::any_of(router.route().begin(), router.route().end(), [&](const RouteStep& s) { return s.to == cell; });
  };
  EXPECT_TRUE(passes({2, 1}));
  EXPECT_FALSE(passes({2, 3}));
}

TEST(Router, CrossesAnOccupiedCellWhenTheWayRoundIsDearer) {
  const RiskMap map = drawn({"#######", "#..#..#", "#######"});
  Router router({});
  EXPECT_EQ(router.find(secure(map), {1, 1}, 0, {5, 1}), Router::Outcome::None);
  ASSERT_EQ(router.find(feasible(map), {1, 1}, 0, {5, 1}), Router::Outcome::Found);
  EXPECT_EQ(router.route().size(), 4u);
  EXPECT_NEAR(router.cost(), 4.892574, 1e-4);  // 4 cells - 4 ln 0.8
  const Pricing while_inhibited{map, {}, Query::Feasible, 0};
  EXPECT_EQ(router.find(while_inhibited, {1, 1}, 0, {5, 1}), Router::Outcome::None);
}

TEST(Router, AvoidsGroundThatHasProvedDear) {
  RiskMap map = drawn({"#######", "#.....#", "#.....#", "#######"});
  for (int column = 1; column <= 5; ++column) map.book_cost({column, 2}, 1);
  for (int column = 2; column <= 4; ++column) map.book_cost({column, 1}, 9);  // mean of all: 4; factor 2.25
  Router router({.max_turn = 4});
  ASSERT_EQ(router.find(secure(map), {1, 1}, 0, {5, 1}), Router::Outcome::Found);
  EXPECT_NEAR(router.cost(), 2 + 2 * kSqrt2, 1e-6);  // up, two along the upper lane, down
  const Pricing by_length{map, {.secure_weighs_cost = false}, Query::Secure, kLater};
  ASSERT_EQ(router.find(by_length, {1, 1}, 0, {5, 1}), Router::Outcome::Found);
  EXPECT_EQ(router.cost(), 4);
}

TEST(Router, SaysWhenTheGoalIsTooFarForItsWindow) {
  const RiskMap map(4, {});
  Router router({.window_cells = 32});
  EXPECT_EQ(router.find(secure(map), {0, 0}, 0, {28, 0}), Router::Outcome::Found);
  EXPECT_EQ(router.find(secure(map), {0, 0}, 0, {40, 0}), Router::Outcome::TooFar);
  EXPECT_EQ(router.find(secure(map), {-268435000, 268435000}, 0, {-268435009, 268435003}), Router::Outcome::Found);
}

/// Least cost by plain Dijkstra over (column, row, heading), written without looking at the router's method.
double oracle(const RiskMap& map, int side, CellIndex start, int heading, CellIndex goal, int max_turn,
              double backward) {
  const auto free = [&](int c, int r) {
    const Cell* cell = map.find({c, r});
    return c >= 0 && r >= 0 && c < side && r < side && cell->label != Label::Occupied;
  };
  constexpr int kColumn[8] = {1, 1, 0, -1, -1, -1, 0, 1};
  constexpr int kRow[8] = {0, 1, 1, 1, 0, -1, -1, -1};
  std::vector<double> best(static_cast<std::size_t>(side * side * 8), 1e300);
  using Item = std::tuple<double, int, int, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  open.emplace(0.0, start.column, start.row, heading);
  while (!open.empty()) {
    const auto [cost, c, r, h] = open.top();
    open.pop();
    auto& known = best[static_cast<std::size_t>((r * side + c) * 8 + h)];
    if (known <= cost) continue;
    known = cost;
    if (c == goal.column && r == goal.row) return cost;
    for (int turn = -max_turn; turn <= max_turn; ++turn) {
      const int h2 = (h + turn + 8) % 8;
      for (const bool ahead : {true, false}) {
        const int k = ahead ? h2 : (h2 + 4) % 8;
        if (!free(c + kColumn[k], r + kRow[k])) continue;
        if (k % 2 == 1 && (!free(c + kColumn[k], r) || !free(c, r + kRow[k]))) continue;
        open.emplace(cost + (k % 2 == 1 ? kSqrt2 : 1.0) * (ahead ? 1 : backward), c + kColumn[k], r + kRow[k], h2);
      }
    }
  }
  return -1;
}

RiskMap scattered(std::mt19937& chance, int side, int percent_blocked) {
  std::vector<std::string> lines(static_cast<std::size_t>(side + 2), std::string(static_cast<std::size_t>(side), '.'));
  for (auto& line : lines) {
    for (char& c : line) c = static_cast<int>(chance() % 100) < percent_blocked ? '#' : '.';
  }
  lines.front().assign(lines.front().size(), '#');
  lines.back().assign(lines.back().size(), '#');
  for (auto& line : lines) line.front() = line.back() = '#';
  return drawn(lines);
}

TEST(Router, FindsTheOptimumOnEveryKnownMap) {
  std::mt19937 chance(7);
  int found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int side = 24;
    const RiskMap map = scattered(chance, side, static_cast<int>(chance() % 40));
    const auto somewhere = [&] { return static_cast<std::int32_t>(1 + chance() % 22); };
    const CellIndex start{somewhere(), somewhere()};
    const CellIndex goal{somewhere(), somewhere()};
    const int heading = static_cast<int>(chance() % 8);
    const int max_turn = trial % 3 == 2 ? 4 : 1 + trial % 3;
    if (map.find(goal)->label == Label::Occupied || start == goal) continue;
    const double best = oracle(map, side + 2, start, heading, goal, max_turn, 2);
    Router router({.window_cells = 64, .max_turn = max_turn});
    const auto outcome = router.find(secure(map), start, heading, goal);
    ASSERT_EQ(outcome == Router::Outcome::Found, best >= 0) << trial;
    if (best < 0) continue;
    ++found;
    ASSERT_NEAR(router.cost(), best, 1e-5) << trial;
    CellIndex at = start;
    int facing = heading;
    for (const RouteStep& step : router.route()) {
      ASSERT_EQ(step.from, at);
      ASSERT_EQ(step.to, neighbour(at, step.direction));
      ASSERT_LE(std::abs(turn_between(facing, step.heading)), max_turn);
      ASSERT_TRUE(secure(map).may_step(at, step.direction));
      at = step.to;
      facing = step.heading;
    }
    ASSERT_EQ(at, goal);
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace ganglion::grid
