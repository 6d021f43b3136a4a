// Many small maps, held against oracles written without the code under test.
#include <gtest/gtest.h>

#include <array>
#include <queue>
#include <random>
#include <tuple>

#include "ganglion/acting/dynamic_map_router/grid_bot.h"

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

TEST(DynamicMapRouter, ReachesEveryGoalThatCanBeReachedAndWithdrawsFromTheOthers) {
  std::mt19937 chance(11);
  int reachable = 0;
  int sealed = 0;
  for (int trial = 0; trial < 100; ++trial) {
    GridBot bot = random_bot(chance, 20, 10 + trial % 25);
    const int column = static_cast<int>(chance() % 20);
    const int row = static_cast<int>(chance() % 20);
    if (bot.column == column && bot.row == row) continue;
    bot.walls.erase({column, row});
    const bool can = least_cost(bot, column, row) >= 0;
    (can ? reachable : sealed) += 1;
    Drive drive(bot);
    EXPECT_EQ(drive.go(column, row, 20000), can ? RequestStatus::Satisfied : RequestStatus::Withdrawn)
        << "map " << trial << " after " << drive.ticks;
    EXPECT_EQ(bot.illegal, 0);
    if (!can && drive.bench().request().status == RequestStatus::Withdrawn) {
      EXPECT_TRUE(drive.reason() == ReasonCode::Unreachable || drive.reason() == ReasonCode::Trapped);
    }
  }
  EXPECT_GT(reachable, 50);
  EXPECT_GT(sealed, 5);
}

}  // namespace
}  // namespace ganglion
