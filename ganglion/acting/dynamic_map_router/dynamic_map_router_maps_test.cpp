// Many small maps, held against oracles written without the code under test.
#include <gtest/gtest.h>

#include <array>
#include <queue>
#include <random>
#include <tuple>

#include "ganglion/acting/dynamic_map_router/testing/grid_bot.h"

namespace ganglion {
namespace {

using testing::Drive;
using testing::GridBot;

/// Least cost of driving to a cell on the true map, backwards at twice the length; -1 when the steering cannot do it.
double least_cost(const GridBot& bot, int goal_column, int goal_row) {
  using Item = std::tuple<double, int, int, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  std::set<std::tuple<int, int, int>> closed;
  open.emplace(0, bot.column, bot.row, bot.heading);
  while (!open.empty()) {
    const auto [cost, c, r, h] = open.top();
    open.pop();
    if (!closed.insert({c, r, h}).second) continue;
    if (c == goal_column && r == goal_row) return cost;
    for (const int turn : {7, 0, 1}) {
      const int heading = (h + turn) % 8;
      for (const int reversed : {0, 4}) {
        const int k = (heading + reversed) % 8;
        if (!bot.passable(c, r, k)) continue;
        const double length = (k % 2 == 0 ? 1 : std::numbers::sqrt2) * (reversed == 0 ? 1 : 2);
        open.emplace(cost + length, c + GridBot::kColumns[k], r + GridBot::kRows[k], heading);
      }
    }
  }
  return -1;
}

GridBot random_bot(std::mt19937& chance, int side, int percent_walls) {
  std::vector<std::string> lines(static_cast<std::size_t>(side), std::string(static_cast<std::size_t>(side), '.'));
  for (auto& line : lines) {
    for (char& c : line) c = static_cast<int>(chance() % 100) < percent_walls ? '#' : '.';
  }
  GridBot bot(lines);
  bot.column = static_cast<int>(chance()) % side & 15;
  bot.row = static_cast<int>(chance() % 16);
  bot.heading = static_cast<int>(chance() % 8);
  bot.walls.erase({bot.column, bot.row});
  return bot;
}

TEST(DynamicMapRouter, ReachesEveryGoalThatItsSteeringAllowsAndWithdrawsFromTheOthers) {
  std::mt19937 chance(11);
  int reached = 0;
  int stuck = 0;  // a step into the unknown cannot always be undone by a robot that steers like a car
  int sealed = 0;
  for (int trial = 0; trial < 100; ++trial) {
    GridBot bot = random_bot(chance, 20, 10 + trial % 20);
    const int column = static_cast<int>(chance() % 20);
    const int row = static_cast<int>(chance() % 20);
    if (bot.column == column && bot.row == row) continue;
    bot.walls.erase({column, row});
    const bool can = least_cost(bot, column, row) >= 0;
    Drive drive(bot);
    const RequestStatus status = drive.go(column, row, 20000);
    EXPECT_EQ(bot.illegal, 0);
    if (can && status == RequestStatus::Satisfied) {
      ++reached;
      continue;
    }
    EXPECT_EQ(status, RequestStatus::Withdrawn) << "map " << trial;
    EXPECT_LT(least_cost(bot, column, row), 0) << "map " << trial << ": it gave up where there is a way";
    EXPECT_TRUE(drive.reason() == ReasonCode::Unreachable || drive.reason() == ReasonCode::Trapped);
    (can ? stuck : sealed) += 1;
  }
  EXPECT_GT(reached, 60);
  EXPECT_GT(sealed, 5);
  EXPECT_LE(stuck, 2);
}

/// The experience of somebody who has been everywhere.
std::vector<ExperiencePart> full_knowledge(const GridBot& bot) {
  grid::RiskMap map(16, {});
  for (int row = -1; row <= bot.rows(); ++row) {
    for (int column = -1; column <= bot.columns(); ++column) {
      map.grow_around({column, row});
      if (bot.blocked(column, row)) {
        map.fail({column, row}, 0);
      } else {
        map.cross({column, row});
      }
    }
  }
  return stored_parts(map, grid::RiskMap::encode);
}

TEST(DynamicMapRouter, DrivesTheOptimumOnAKnownMap) {
  std::mt19937 chance(5);
  int driven = 0;
  for (int trial = 0; trial < 60; ++trial) {
    GridBot bot = random_bot(chance, 20, 5 + trial % 25);
    const int column = static_cast<int>(chance() % 20);
    const int row = static_cast<int>(chance() % 20);
    if (bot.blocked(column, row) || (bot.column == column && bot.row == row)) continue;
    const double best = least_cost(bot, column, row);
    if (best < 0) continue;
    Drive drive(bot);
    ASSERT_TRUE(drive.module().load(1, full_knowledge(bot)));
    ASSERT_EQ(drive.go(column, row), RequestStatus::Satisfied);
    EXPECT_NEAR(bot.weighted, best, 1e-6);
    EXPECT_EQ(bot.bumps, 0);
    ++driven;
  }
  EXPECT_GT(driven, 30);
}

}  // namespace
}  // namespace ganglion
