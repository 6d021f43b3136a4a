// The five skills that the paper asks of AmDmr (results, section 5), on a robot that steers like a car.
#include <gtest/gtest.h>

#include <random>

#include "ganglion/acting/dynamic_map_router/testing/grid_bot.h"

namespace ganglion {
namespace {

using testing::Drive;
using testing::GridBot;

/// A trap that opens towards the robot, the goal behind it.
const std::vector<std::string> kTrap = {
    "....................",  //
    "....................",  //
    "....########........",  //
    "...........#........",  //
    "...........#........",  //
    "...........#........",  //
    "...........#........",  //
    "...........#........",  //
    "....########........",  //
    "....................",  //
    "....................",
};

/// The way of the last of twenty trips out of the trap; checks that it touches nothing and that trips get better.
double last_trip_through_trap(const DynamicMapRouterConfig& config) {
  GridBot bot(kTrap);
  Drive drive(bot, config);
  std::vector<double> lengths;
  std::vector<int> bumps;
  for (int trip = 0; trip < 20; ++trip) {
    bot.column = 1, bot.row = 5, bot.heading = 0, bot.bumps = 0, bot.length = 0;
    drive.tick();  // carried back to the start
    EXPECT_EQ(drive.go(15, 5), RequestStatus::Satisfied);
    lengths.push_back(bot.length);
    bumps.push_back(bot.bumps);
  }
  EXPECT_GT(bumps.front(), 0);
  EXPECT_LE(lengths[1], lengths[0]);
  EXPECT_LT(lengths.back(), lengths[0]);
  EXPECT_EQ(bumps.back(), 0);
  EXPECT_EQ(bot.illegal, 0);
  return lengths.back();
}

// The least, to row 1 or its mirror image: SE, S, S, SE to column 3, nine along to column 12, NE, N, NE, NE.
constexpr double kLeastThroughTrap = 12 + 5 * std::numbers::sqrt2;

TEST(DynamicMapRouter, MapsBetterWithTime) {
  DynamicMapRouterConfig config = Drive::small();
  EXPECT_LE(last_trip_through_trap(config), kLeastThroughTrap + 2 + 1e-9);  // a known way is worth a small detour
  config.price.unexplored.inferred = false;
  EXPECT_NEAR(last_trip_through_trap(config), kLeastThroughTrap, 1e-9);  // what may be shorter is always tried
}

TEST(DynamicMapRouter, FindsAnotherWayWhenTheKnownOneIsBlocked) {
  GridBot bot({
      "...............",  //
      "...............",  //
      ".......#.......",  //
      ".......#.......",  //
      ".......#.......",  //
      "...............",  //
      "...............",
  });
  Drive drive(bot);
  for (int trip = 0; trip < 8; ++trip) {
    bot.column = 2, bot.row = 3, bot.heading = 0;
    drive.tick();
    ASSERT_EQ(drive.go(12, 3), RequestStatus::Satisfied);
  }
  // Once more, and whichever side of the wall it has come to know, that side is shut in front of it.
  bot.column = 2, bot.row = 3, bot.heading = 0, bot.bumps = 0;
  drive.tick();
  int shut = -1;
  drive.before_tick = [&] {
    if (bot.column != 6 || shut >= 0) return;
    shut = bot.row < 3 ? 1 : 5;
    bot.blocks = {{7, bot.row < 3 ? 0 : 6}, {7, shut}};
  };
  ASSERT_EQ(drive.go(12, 3), RequestStatus::Satisfied);
  ASSERT_GE(shut, 0);
  EXPECT_GT(bot.bumps, 0);
  EXPECT_EQ(drive.cell(7, shut).label, grid::Label::Occupied);
  EXPECT_EQ(drive.cell(7, shut).nature, grid::Nature::Dynamic);
}

TEST(DynamicMapRouter, ReachesItsGoalsAmongObstaclesThatChangePlaces) {
  GridBot bot(std::vector<std::string>(16, std::string(16, '.')));
  std::mt19937 chance(3);
  Drive drive(bot);
  int tick = 0;
  drive.before_tick = [&] {
    if (++tick % 5 != 0) return;  // twenty obstacles, each anywhere but on the robot and its goals
    bot.blocks.clear();
    while (bot.blocks.size() < 20) {
      const int column = static_cast<int>(chance() % 16);
      const int row = static_cast<int>(chance() % 16);
      const bool corner = (column < 3 || column > 12) && (row < 3 || row > 12);
      if (!corner && (column != bot.column || row != bot.row)) bot.blocks.insert({column, row});
    }
  };
  for (int trip = 0; trip < 20; ++trip) {
    const bool there = trip % 2 == 0;
    ASSERT_EQ(drive.go(there ? 14 : 1, there ? 14 : 1, 500), RequestStatus::Satisfied) << trip;
  }
  EXPECT_GT(bot.bumps, 10);
}

TEST(DynamicMapRouter, LeavesANarrowPlaceForTheRoomThatAHalfTurnNeeds) {
  // Heading into a dead end, the goal far behind: back into the room, turn there, drive on forwards.
  GridBot bot({
      "##############################",  //
      "#........................#####",  //
      "#........................#####",  //
      "#............................#",  //
      "#........................#####",  //
      "#........................#####",  //
      "##############################",
  });
  bot.column = 25, bot.row = 3;
  Drive drive(bot);
  ASSERT_EQ(drive.go(28, 3), RequestStatus::Satisfied);
  bot.backward_steps = 0, bot.steps = 0;
  ASSERT_EQ(drive.go(1, 3), RequestStatus::Satisfied);
  EXPECT_GE(bot.backward_steps, 4);  // cells 27, 26, 25, 24: no room to turn before
  EXPECT_LE(bot.backward_steps, 12);
  EXPECT_EQ(bot.heading, 4);
  EXPECT_EQ(bot.illegal, 0);
}

TEST(DynamicMapRouter, BacksOutOfADeadEnd) {
  GridBot bot({
      "##########",  //
      "#........#",  //
      "#........#",  //
      "####.#####",  //
      "####.#####",  //
      "####.#####",  //
      "####.#####",  //
      "##########",
  });
  bot.column = 4, bot.row = 1, bot.heading = 6;
  Drive drive(bot);
  ASSERT_EQ(drive.go(7, 6), RequestStatus::Satisfied);
  EXPECT_GE(bot.backward_steps, 4);
  EXPECT_EQ(bot.illegal, 0);
}

TEST(DynamicMapRouter, GoesBackAlongItsWayWhenNothingElseIsLeft) {
  // The passage closes in front of the robot while its goal lies at the end of it.
  GridBot bot({"####################", "#..................#", "####################"});
  bot.column = 1, bot.row = 1;
  Drive drive(bot);
  bool closed = false;
  drive.before_tick = [&] {
    if (bot.column == 12 && !closed) {
      bot.blocks.insert({13, 1});
      closed = true;
    }
  };
  int least = 12;
  bool went_back = false;
  drive.bench().ask({18, 1});
  for (int i = 0; i < 400 && drive.bench().request().status == RequestStatus::Pending; ++i) {
    drive.before_tick();
    drive.tick();
    went_back |= drive.output("phase") == 3;
    if (closed) least = std::min(least, bot.column);
    if (went_back && bot.column < 8) bot.blocks.clear();  // the obstacle moves on
  }
  EXPECT_TRUE(went_back);
  EXPECT_LT(least, 8);
  EXPECT_EQ(drive.bench().request().status, RequestStatus::Satisfied);
}

}  // namespace
}  // namespace ganglion
