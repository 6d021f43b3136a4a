// The five skills that the paper asks of AmDmr (results, section 5), on a robot that steers like a car.
#include <gtest/gtest.h>

#include <random>

#include "ganglion/acting/dynamic_map_router/grid_bot.h"

namespace ganglion {
namespace {

using testing::Drive;
using testing::GridBot;

const std::vector<std::string> kRoom = {
    "....................",  //
    "....................",  //
    "....................",  //
    "..........#.........",  //
    "..........#.........",  //
    "..........#.........",  //
    "....#######.........",  //
    "..........#.........",  //
    "..........#.........",  //
    "..........#.........",  //
    "....................",  //
    "....................",
};

TEST(DynamicMapRouter, MapsBetterWithTime) {
  GridBot bot(kRoom);
  bot.column = 6, bot.row = 3;
  Drive drive(bot);
  ASSERT_EQ(drive.go(14, 3), RequestStatus::Satisfied);
  const int first_bumps = bot.bumps;
  const double first_length = bot.length;
  EXPECT_GT(first_bumps, 0);
  bot.column = 6, bot.row = 3, bot.heading = 0, bot.bumps = 0, bot.length = 0;
  drive.tick();  // carried back to the start
  ASSERT_EQ(drive.go(14, 3), RequestStatus::Satisfied);
  EXPECT_LE(bot.length, first_length);
  EXPECT_LT(bot.bumps, first_bumps);
  EXPECT_EQ(bot.illegal, 0);
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
  bot.column = 4, bot.row = 3;
  Drive drive(bot);
  ASSERT_EQ(drive.go(10, 3), RequestStatus::Satisfied);
  ASSERT_EQ(drive.go(4, 3), RequestStatus::Satisfied);
  const bool went_below = drive.module().map().find({7, 1})->label == grid::Label::Empty;
  for (int row = 0; row <= 1; ++row) bot.blocks.insert({7, went_below ? row : 6 - row});
  bot.bumps = 0;
  ASSERT_EQ(drive.go(10, 3), RequestStatus::Satisfied);
  EXPECT_GT(bot.bumps, 0);
  EXPECT_EQ(drive.cell(7, went_below ? 1 : 5).label, grid::Label::Occupied);
  EXPECT_EQ(drive.cell(7, went_below ? 1 : 5).nature, grid::Nature::Dynamic);
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
