#include <cmath>
#include <set>

#include "ganglion/sim/world/world_for_test.h"

namespace ganglion::sim {
namespace {

const char* const kJumper = R"(
[[mover]]
id = "crate"
length_m = 0.5
width_m = 0.5
places = [[1, 1], [3, 1], [5, 1]]
change_after_s = [2, 4]
)";

std::vector<double> jump_times(World& world, std::uint64_t seed, std::span<const Disc> robots = {}) {
  world.reset(seed, 0);
  std::vector<double> times;
  for (std::uint32_t tick = 0; tick < 1000; ++tick) {
    const Vector2 before = world.movers()[0].pose.position;
    world.advance(tick, tick * 0.1, 0.1, robots);
    if (!(world.movers()[0].pose.position == before)) times.push_back(tick * 0.1);
  }
  return times;
}

TEST(Mover, StartsAtItsFirstPlaceAndJumpsAfterTheStatedTimes) {
  World world = world_of(kJumper);
  EXPECT_EQ(world.movers()[0].pose.position, (Vector2{1, 1}));
  const auto times = jump_times(world, 1);
  ASSERT_GT(times.size(), 20u);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double pause = times[i] - (i == 0 ? 0 : times[i - 1]);
    EXPECT_GE(pause, 2 - 0.1 - 1e-9);
    EXPECT_LE(pause, 4 + 0.1 + 1e-9);
  }
  world.reset(1, 0);
  EXPECT_EQ(world.movers()[0].pose.position, (Vector2{1, 1}));
}

TEST(Mover, RepeatsItselfForTheSameSeedOnly) {
  World world = world_of(kJumper), fresh = world_of(kJumper);
  const auto first = jump_times(world, 1), other = jump_times(world, 2), again = jump_times(world, 1);
  EXPECT_EQ(first, again);
  EXPECT_EQ(first, jump_times(fresh, 1));
  EXPECT_NE(first, other);
}

TEST(Mover, NeverJumpsOntoARobot) {
  World world = world_of(kJumper);
  const Disc robots[] = {{{3.4, 1}, 0.2}};  // overlaps the second place by 5 cm
  world.reset(3, 0);
  std::set<double> seen;
  for (std::uint32_t tick = 0; tick < 2000; ++tick) {
    world.advance(tick, tick * 0.1, 0.1, robots);
    seen.insert(world.movers()[0].pose.position.x);
  }
  EXPECT_EQ(seen, (std::set<double>{1, 5}));
}

TEST(Mover, StaysWhileEveryOtherPlaceIsTakenAndGoesSoonAfter) {
  World world = world_of(kJumper);
  const Disc robots[] = {{{3, 1}, 0.2}, {{5, 1}, 0.2}};
  EXPECT_TRUE(jump_times(world, 1, robots).empty());
  world.advance(1000, 100, 0.1, {});
  EXPECT_NE(world.movers()[0].pose.position, (Vector2{1, 1}));
}

TEST(Mover, TakesAPlaceBesideAnotherButNotItsOwn) {
  World world = world_of(R"(
[[mover]]
id = "a"
length_m = 0.5
width_m = 0.5
places = [[0.25, 0.25], [0.75, 0.25], [1.0, 0.5]]
change_after_s = [0.1, 0.1]
[[mover]]
id = "b"
length_m = 0.5
width_m = 0.5
places = [[1.25, 0.25]]
)");
  std::set<double> seen;
  for (std::uint32_t tick = 0; tick < 500; ++tick) {
    world.advance(tick, tick * 0.1, 0.1, {});
    seen.insert(world.movers()[0].pose.position.x);
  }
  EXPECT_EQ(seen, (std::set<double>{0.25, 0.75}));  // the third place overlaps b, the second only touches it
}

const char* const kWalker =
    "[[mover]]\nid = \"person\"\nradius_m = 0.25\npath = [[0, 0], [2, 0], [2, 1]]\nspeed_mps = 0.5\n";

TEST(Mover, FollowsItsPathAtItsSpeedAndStopsAtTheEnd) {
  World world = world_of(kWalker);
  double time_s = 0;
  auto advance_to = [&](double end_s) {
    for (; time_s < end_s - 1e-9; time_s += 0.1) world.advance(0, time_s, 0.1, {});
    return world.movers()[0].pose.position;
  };
  EXPECT_NEAR(advance_to(1).x, 0.5, 1e-9);
  const Vector2 round_the_corner = advance_to(5);
  EXPECT_NEAR(round_the_corner.x, 2, 1e-9);
  EXPECT_NEAR(round_the_corner.y, 0.5, 1e-9);
  EXPECT_EQ(advance_to(20), (Vector2{2, 1}));
}

TEST(Mover, ReturnsToTheFirstPointWhenItLoops) {
  World world = world_of(std::string(kWalker) + "loop = true\n");
  // Once round: 2 + 1 + sqrt 5 m at 0.5 m/s.
  const double round_s = (3 + std::sqrt(5.0)) / 0.5;
  world.advance(0, 0, round_s, {});
  EXPECT_NEAR(world.movers()[0].pose.position.length(), 0, 1e-9);
  world.advance(1, round_s, 1, {});
  EXPECT_NEAR(world.movers()[0].pose.position.x, 0.5, 1e-9);
}

TEST(Mover, WaitsBeforeARobotAndGoesOn) {
  World world = world_of(kWalker);
  const Disc robots[] = {{{1, 0}, 0.15}};
  for (std::uint32_t tick = 0; tick < 100; ++tick) {
    world.advance(tick, tick * 0.1, 0.1, robots);
    ASSERT_GE((world.movers()[0].pose.position - robots[0].position).length(), 0.4);
  }
  EXPECT_NEAR(world.movers()[0].pose.position.x, 0.6, 0.051);
  world.advance(100, 10, 1, {});
  EXPECT_GT(world.movers()[0].pose.position.x, 1);
}

TEST(Mover, DoesNotLeapOverARobotInOneLongStep) {
  World world = world_of(kWalker);
  const Disc robots[] = {{{1, 0.3}, 0.15}};
  world.advance(0, 0, 4, robots);
  EXPECT_EQ(world.movers()[0].pose.position, (Vector2{0, 0}));
}

TEST(Mover, IsSeenAndMeasuredWhereItStandsNow) {
  World world = world_of(kJumper);
  EXPECT_NEAR(world.cast({0, 1}, {1, 0}, 10)->range_m, 0.75, 1e-12);
  EXPECT_NEAR(world.clearance({0, 1}, 10), 0.75, 1e-12);
  EXPECT_NEAR(world.clearance({1, 1.1}, 10), -0.15, 1e-12);
  EXPECT_EQ(world.cast({1, 1}, {1, 0}, 10)->range_m, 0);
  const World copy = world;
  while (world.movers()[0].pose.position.x == 1) world.advance(50, 50, 1, {});
  EXPECT_GT(world.cast({0, 1}, {1, 0}, 10)->range_m, 2);
  EXPECT_NEAR(copy.cast({0, 1}, {1, 0}, 10)->range_m, 0.75, 1e-12);
  EXPECT_EQ(world.ground().far_wall_m({0, 1}, {1, 0}), std::numeric_limits<double>::infinity());
}

TEST(Mover, IsTurnedAsItsYawSays) {
  const World world =
      world_of("[[mover]]\nid = \"door\"\nlength_m = 2\nwidth_m = 0.1\nyaw_deg = 90\nplaces = [[3, 0]]\n");
  EXPECT_NEAR(world.cast({0, 0.9}, {1, 0}, 10)->range_m, 2.95, 1e-12);
  EXPECT_FALSE(world.cast({0, 1.1}, {1, 0}, 10));
}

}  // namespace
}  // namespace ganglion::sim
