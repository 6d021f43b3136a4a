#include "ganglion/sim/world/way/free_space.h"

#include "ganglion/sim/world/world_for_test.h"

namespace ganglion::sim {
namespace {

// Two rooms of 4 x 4 m and 2 x 4 m, a door of 0.6 m between them.
const char* const kRooms = R"(
[[wall]]
points = [[0, 0], [6, 0], [6, 4], [0, 4]]
closed = true
[[wall]]
points = [[4, 0], [4, 1]]
[[wall]]
points = [[4, 1.6], [4, 4]]
)";

TEST(FreeSpace, IsTheLargestPartThatADiscCanMoveIn) {
  FreeSpace space(ground_of(kRooms), 0.05);
  EXPECT_NEAR(space.largest_part_area_m2(), 24, 1e-9);
  // A disc of 0.5 m does not pass the door: its centre has 3 x 3 m of the larger room.
  EXPECT_NEAR(space.largest_part_area_m2(0.5), 9, 0.4);
  // One of 0.2 m passes: 3.6 x 3.6 + 1.6 x 3.6 + the door of at least 0.2 x 0.4.
  EXPECT_NEAR(space.largest_part_area_m2(0.2), 18.72 + 0.2 * 0.4, 0.8);
  EXPECT_EQ(space.largest_part_area_m2(3), 0);
}

TEST(FreeSpace, SeesWallsThinnerThanItsCells) {
  FreeSpace space(ground_of("[[wall]]\npoints = [[0, 0], [3, 0], [3, 1], [0, 1]]\nclosed = true\n"
                            "[[wall]]\npoints = [[1, 0], [1, 1]]\n"),
                  0.1);
  EXPECT_NEAR(space.largest_part_area_m2(), 2, 1e-9);
}

TEST(FreeSpace, KeepsOutOfSolids) {
  FreeSpace space(
      ground_of("[[wall]]\npoints = [[0, 0], [3, 0], [3, 2], [0, 2]]\nclosed = true\n"
                "[[box]]\nx_m = 1.5\ny_m = 1\nlength_m = 1\nwidth_m = 1\n"));
  EXPECT_NEAR(space.largest_part_area_m2(), 5, 1e-9);
}

TEST(FreeSpace, SamplesEvenlyWithTheClearanceAskedFor) {
  const auto ground = ground_of(kRooms);
  FreeSpace space(ground);
  Draws draws({1, 0, 0, 1}, 0);
  int left = 0;
  constexpr int kDrawn = 4000;
  for (int i = 0; i < kDrawn; ++i) {
    const Vector2 point = space.sample(0.5, draws);
    ASSERT_GE(ground->clearance(point, 1), 0.5);
    ASSERT_LT(point.x, 4);  // the smaller room is cut off for this clearance
    left += point.x < 2 ? 1 : 0;
  }
  EXPECT_NEAR(left, kDrawn / 2, 4 * 32);  // four deviations of a fair coin: sqrt(4000) / 2 = 32
}

TEST(FreeSpace, DrawsTheSamePointsForTheSameStream) {
  FreeSpace space(ground_of(kRooms)), other(ground_of(kRooms));
  Draws a({7, 1, 2, 3}, 0), b({7, 1, 2, 3}, 0);
  other.largest_part_area_m2(0.1);  // what was asked before does not matter
  for (int i = 0; i < 20; ++i) EXPECT_EQ(space.sample(0.2, a), other.sample(0.2, b));
}

}  // namespace
}  // namespace ganglion::sim
