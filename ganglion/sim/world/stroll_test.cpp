#include <cmath>

#include "ganglion/sim/world/world_for_test.h"

namespace ganglion::sim {
namespace {

const std::string kRoom =
    "[[wall]]\npoints = [[0, 0], [6, 0], [6, 4], [0, 4]]\nclosed = true\n[[wall]]\npoints = [[3, 0], [3, 2.5]]\n";
const std::string kPerson =
    "[[mover]]\nid = \"person\"\nradius_m = 0.25\nx_m = 1\ny_m = 1\narea = [0, 0, 6, 4]\nspeed_mps = 0.8\n"
    "pause_s = [1, 3]\n";

/// Where it stands after each tenth of a second.
std::vector<Vector2> stroll(World& world, std::uint64_t seed, int ticks, std::span<const Disc> robots = {}) {
  world.reset(seed, 0);
  std::vector<Vector2> places;
  for (int tick = 0; tick < ticks; ++tick) {
    world.advance(static_cast<std::uint32_t>(tick), tick * 0.1, 0.1, robots);
    places.push_back(world.movers()[0].pose.position);
  }
  return places;
}

TEST(Stroll, WalksStraightFromGoalToGoalWithPauses) {
  World world = world_of(kRoom + kPerson);
  EXPECT_EQ(world.movers()[0].pose.position, (Vector2{1, 1}));
  const auto places = stroll(world, 1, 6000);
  int still = 0, pauses = 0, longest = 0, walking = 0;
  for (std::size_t n = 1; n < places.size(); ++n) {
    const double step_m = (places[n] - places[n - 1]).length();
    ASSERT_LE(step_m, 0.08 + 1e-9);
    walking += step_m > 0 ? 1 : 0;
    if (step_m > 0 && still > 0) {
      ++pauses;
      EXPECT_GE(still, 8);  // 1 s at least, short of what the steps cut off at both ends
      EXPECT_LE(still, 31);
    }
    still = step_m > 0 ? 0 : still + 1;
    longest = std::max(longest, still);
  }
  EXPECT_GT(pauses, 50);
  EXPECT_GT(walking, 3000);
}

/// What is said of a person who begins there.
std::string said_of(const std::string& start, const std::string& shape = "radius_m = 0.25") {
  Problems problems;
  const std::string mover =
      "[[mover]]\nid = \"person\"\n" + shape + "\n" + start + "area = [0, 0, 6, 4]\nspeed_mps = 0.8\n";
  const auto ground = Ground::parse(
      "format = 1\n" + kRoom + "[[box]]\nx_m = 5\ny_m = 1\nlength_m = 1\nwidth_m = 1\n" + mover, "room.toml", problems);
  EXPECT_EQ(ground.has_value(), problems.empty());
  return problems.text();
}

TEST(Stroll, IsRefusedWithItsPlaceWhereItBeginsInAWall) {
  EXPECT_EQ(said_of("x_m = 1\ny_m = 0.25\n"), "") << "it may touch one";
  EXPECT_TRUE(
      said_of("x_m = 1\ny_m = 0.1\n").starts_with("room.toml:12:1: mover \"person\" begins at (1, 0.1) in a wall"))
      << said_of("x_m = 1\ny_m = 0.1\n");
  EXPECT_NE(said_of("x_m = 3.1\ny_m = 1\n"), "");
  EXPECT_NE(said_of("x_m = 5\ny_m = 1\n"), "") << "far from every surface, but within the box";
  EXPECT_NE(said_of("x_m = 1\ny_m = 0.1\n", "length_m = 0.6\nwidth_m = 0.4"), "");
  EXPECT_EQ(said_of("x_m = 1\ny_m = 0.25\n", "length_m = 0.6\nwidth_m = 0.4"), "");
}

TEST(Stroll, KeepsOffWalls) {
  World world = world_of(kRoom + kPerson);
  const Ground& ground = world.ground();
  bool left = false, right = false;
  for (const Vector2 place : stroll(world, 2, 10000)) {
    ASSERT_GE(ground.clearance(place, 1), 0.25 - 1e-6);
    left = left || place.x < 2;
    right = right || place.x > 4;
  }
  EXPECT_TRUE(left && right);  // it found the way round the end of the wall
}

TEST(Stroll, RepeatsItselfForTheSameSeedOnlyWhateverTheSteps) {
  World world = world_of(kRoom + kPerson), fresh = world_of(kRoom + kPerson);
  const auto first = stroll(world, 1, 500);
  EXPECT_EQ(first, stroll(fresh, 1, 500));
  EXPECT_NE(first, stroll(world, 2, 500));
}

TEST(Stroll, NeverWalksOntoARobot) {
  const Disc robots[] = {{{1.5, 1.5}, 0.3}, {{4.5, 2}, 0.3}, {{3, 3.2}, 0.1}};
  for (const char* avoids : {"nothing", "robots"}) {
    World world = world_of(kRoom + kPerson + "avoids = \"" + avoids + "\"\n");
    for (const Vector2 place : stroll(world, 3, 5000, robots)) {
      for (const Disc& robot : robots) ASSERT_GE((place - robot.position).length(), robot.radius_m + 0.25);
    }
  }
}

TEST(Stroll, GoesOnAgainstARobotOrTurnsAway) {
  // In a corridor a robot stands in the way: who avoids nothing waits before it, who avoids robots turns back.
  const std::string corridor =
      "[[wall]]\npoints = [[0, 0], [20, 0], [20, 0.6], [0, 0.6]]\nclosed = true\n"
      "[[mover]]\nid = \"person\"\nradius_m = 0.25\nx_m = 5\ny_m = 0.3\narea = [0.3, 0.29, 19.7, 0.31]\n"
      "speed_mps = 1\n";
  const Disc robots[] = {{{10, 0.3}, 0.2}};
  World blind = world_of(corridor), polite = world_of(corridor + "avoids = \"robots\"\n");
  int waiting_blind = 0, waiting_polite = 0;
  for (const Vector2 place : stroll(blind, 1, 3000, robots)) waiting_blind += place.x > 9.4 ? 1 : 0;
  for (const Vector2 place : stroll(polite, 1, 3000, robots)) waiting_polite += place.x > 9.4 ? 1 : 0;
  EXPECT_GT(waiting_blind, 2500);
  EXPECT_LT(waiting_polite, 100);
}

TEST(Stroll, StandsWhereThereIsNoWay) {
  World world = world_of(
      "[[wall]]\npoints = [[0, 0], [0.55, 0], [0.55, 0.55], [0, 0.55]]\nclosed = true\n"
      "[[mover]]\nid = \"person\"\nradius_m = 0.25\nx_m = 0.27\ny_m = 0.27\narea = [2, 2, 3, 3]\n"
      "speed_mps = 1\n");
  for (const Vector2 place : stroll(world, 1, 100)) ASSERT_EQ(place, (Vector2{0.27, 0.27}));
}

}  // namespace
}  // namespace ganglion::sim
