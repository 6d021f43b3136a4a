#include "ganglion/sim/world/world_for_test.h"

namespace ganglion::sim {
namespace {

/// A room of 8 x 6 m with a box and a column; a crate that jumps, a person on a path, another who strolls.
const char* const kHall = R"(
[[wall]]
points = [[0, 0], [8, 0], [8, 6], [0, 6]]
closed = true
[[wall]]
points = [[6, 2.9], [6, 3.1]]
[[box]]
x_m = 2
y_m = 2
length_m = 1
width_m = 1
[[disc]]
x_m = 4
y_m = 2
radius_m = 0.5
[[mover]]
id = "crate"
length_m = 0.6
width_m = 0.4
places = [[1, 4], [2, 4], [3, 4]]
change_after_s = [1, 2]
[[mover]]
id = "person"
radius_m = 0.25
path = [[1, 5], [7, 5]]
speed_mps = 1
loop = true
[[mover]]
id = "guest"
radius_m = 0.2
area = [5, 3.5, 7.5, 4.5]
x_m = 7
y_m = 4
speed_mps = 1
)";
constexpr std::size_t kCrate = 0, kPerson = 1, kGuest = 2;

std::string refusal(World& world, std::size_t mover, Vector2 point, std::span<const Disc> robots = {}) {
  const Vector2 before = world.movers()[mover].pose.position;
  const auto put = world.put_mover(mover, point, robots);
  if (put) return "";
  EXPECT_EQ(world.movers()[mover].pose.position, before) << "what is refused is not done";
  return put.error().what.en;
}

TEST(PutMover, LeavesItWhereItWasPutForTheRestOfTheRun) {
  World world = world_of(kHall);
  ASSERT_TRUE(world.put_mover(kCrate, {5, 1}, {}));
  ASSERT_TRUE(world.put_mover(kPerson, {4, 3}, {}));
  for (std::uint32_t tick = 0; tick < 200; ++tick) world.advance(tick, tick * 0.1, 0.1, {});
  EXPECT_EQ(world.movers()[kCrate].pose.position, (Vector2{5, 1}));
  EXPECT_EQ(world.movers()[kPerson].pose.position, (Vector2{4, 3}));
  EXPECT_NEAR(world.cast({5, 0.3}, {0, 1}, 10)->range_m, 0.5, 1e-12) << "and is met there";
  world.reset(0, 0);
  EXPECT_EQ(world.movers()[kCrate].pose.position, (Vector2{1, 4}));
  for (std::uint32_t tick = 0; tick < 200; ++tick) world.advance(tick, tick * 0.1, 0.1, {});
  EXPECT_NE(world.movers()[kPerson].pose.position, (Vector2{1, 5})) << "another episode knows nothing of it";
}

TEST(PutMover, LetsOneThatStrollsGoOnFromThere) {
  World world = world_of(kHall);
  for (std::uint32_t tick = 0; tick < 20; ++tick) world.advance(tick, tick * 0.1, 0.1, {});
  ASSERT_TRUE(world.put_mover(kGuest, {5, 3}, {}));
  Vector2 before = {5, 3};
  for (std::uint32_t tick = 20; tick < 60; ++tick) {
    world.advance(tick, tick * 0.1, 0.1, {});
    EXPECT_LE((world.movers()[kGuest].pose.position - before).length(), 0.1 + 1e-9) << "on foot";
    before = world.movers()[kGuest].pose.position;
  }
  EXPECT_GT((before - Vector2{5, 3}).length(), 0.3);
}

TEST(PutMover, TakesAPlaceRightAtAWallButNoneWithinIt) {
  World world = world_of(kHall);
  EXPECT_EQ(refusal(world, kCrate, {0.3, 0.2}), "");
  EXPECT_NE(refusal(world, kCrate, {0.29, 0.2}).find("\"crate\" cannot stand at (0.29, 0.20): a wall"),
            std::string::npos);
  EXPECT_EQ(refusal(world, kPerson, {7.75, 5.75}), "");
  EXPECT_NE(refusal(world, kPerson, {7.76, 5.75}), "");
}

TEST(PutMover, SeesWallsAndSolidsThatItWouldSwallowOrSinkInto) {
  World world = world_of(kHall);
  EXPECT_NE(refusal(world, kCrate, {6, 3}), "") << "all of the short wall would be within it";
  EXPECT_NE(refusal(world, kPerson, {2, 2}), "") << "all of it would be within the box";
  EXPECT_NE(refusal(world, kCrate, {4, 2}), "") << "all of it would be within the column";
  EXPECT_NE(refusal(world, kCrate, {4.75, 2}), "") << "5 cm within the column";
  EXPECT_EQ(refusal(world, kCrate, {4.81, 2}), "");
  EXPECT_EQ(refusal(world, kCrate, {2.81, 2}), "");
}

TEST(PutMover, RefusesRobotsOtherMoversAndTheOutside) {
  World world = world_of(kHall);
  const Disc robots[] = {{{7, 1}, 0.2}, {{5, 1}, 0.2}};
  EXPECT_NE(refusal(world, kCrate, {5.45, 1}, robots).find("robot 1 is there"), std::string::npos);
  EXPECT_EQ(refusal(world, kCrate, {5.51, 1}, robots), "");
  EXPECT_NE(refusal(world, kPerson, {5.51, 1.4}).find("\"crate\" is there"), std::string::npos);
  EXPECT_NE(refusal(world, kPerson, {8.5, 1}).find("(8.50, 1.00) lies outside of the world, from (0, 0) to (8, 6)"),
            std::string::npos);
}

}  // namespace
}  // namespace ganglion::sim
