#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <cmath>

#include "ganglion/sim/world/world_for_test.h"

namespace ganglion::sim {
namespace {

constexpr double kGap_m = 2e-9;

TEST(Slide, KeepsTheWayAlongAWall) {
  const World world = world_of("[[wall]]\npoints = [[-10, 1], [10, 1]]\n");
  const auto slide = world.slide({0, 0}, {1, 2}, 0.2);
  EXPECT_TRUE(slide.touched);
  EXPECT_NEAR(slide.position.x, 1, 1e-12);
  EXPECT_NEAR(slide.position.y, 0.8, kGap_m);
  EXPECT_EQ(slide.normal, (Vector2{0, -1}));
}

TEST(Slide, GoesStraightWhereNothingStands) {
  const World world = world_of("[[wall]]\npoints = [[-10, 1], [10, 1]]\n");
  const auto slide = world.slide({0, 0}, {3, 0.7}, 0.2);
  EXPECT_FALSE(slide.touched);
  EXPECT_EQ(slide.position, (Vector2{3, 0.7}));
}

TEST(Slide, DoesNotTouchAWallItRunsAlong) {
  const World world = world_of("[[wall]]\npoints = [[-10, 1], [10, 1]]\n");
  const Vector2 resting = world.slide({0, 0}, {0, 2}, 0.2).position;
  const auto along = world.slide(resting, {0.3, 0}, 0.2);
  EXPECT_FALSE(along.touched);
  EXPECT_EQ(along.position.x, resting.x + 0.3);
  EXPECT_FALSE(world.slide(resting, {0.1, -0.1}, 0.2).touched);
}

TEST(Slide, DoesNotStumbleOverTheJointsOfAWall) {
  std::string points;
  for (int i = -20; i <= 20; ++i)
    points += fmt::format("[{}, {}],", i * 0.3, 1 + i * 0.1);  // one straight slanting line
  const World world = world_of("[[wall]]\npoints = [" + points + "]\n");
  const Vector2 along = Vector2{3, 1} * (1 / std::sqrt(10.0));
  Vector2 at = world.slide({-4, -1}, {0, 1.5}, 0.2).position;
  const Vector2 start = at;
  for (int step = 0; step < 100; ++step) at = world.slide(at, along * 0.05 + along.left() * 0.02, 0.2).position;
  EXPECT_NEAR((at - start).dot(along), 5, 1e-7);
}

TEST(Slide, StopsHeadOnAndInCorners) {
  const World world = world_of("[[wall]]\npoints = [[-3, 1], [2, 1], [2, -3]]\n");
  const auto stall = world.slide({0, 0}, {0, 5}, 0.2);
  EXPECT_NEAR(stall.position.x, 0, kGap_m);
  EXPECT_NEAR(stall.position.y, 0.8, kGap_m);
  const auto corner = world.slide({0, 0}, {5, 6}, 0.2);
  EXPECT_NEAR(corner.position.x, 1.8, kGap_m);
  EXPECT_NEAR(corner.position.y, 0.8, kGap_m);
  EXPECT_EQ(corner.normal, (Vector2{0, -1}));  // the wall it ran against more squarely
}

TEST(Slide, StopsInAnAcuteCorner) {
  const World world = world_of("[[wall]]\npoints = [[-3, 0], [0, 0], [-3, 1.5]]\n");
  Vector2 at{-2, 0.5};
  for (int i = 0; i < 50; ++i) at = world.slide(at, {0.3, 0.01}, 0.1).position;
  EXPECT_NEAR(at.y, 0.1, kGap_m);
  // Between two walls at an angle w the centre rests radius / tan(w / 2) from the corner, tan w = 1/2.
  EXPECT_NEAR(at.x, -0.1 / std::tan(std::atan(0.5) / 2), 1e-7);
}

TEST(Slide, IsNotSqueezedIntoANarrowCornerByPushingOn) {
  const World world = world_of("[[wall]]\npoints = [[-3, 0], [0, 0], [-3, 0.5]]\n");
  Draws draws({1, 0, 0, 1}, 0);
  Vector2 at{-2, 0.2};
  for (int i = 0; i < 5000; ++i) {
    at = world.slide(at, direction(draws.uniform(-0.6, 0.6)) * 0.05, 0.1).position;
    ASSERT_GE(world.clearance(at, 1), 0.1) << "push " << i;
  }
}

TEST(Slide, RoundsTheEndOfAWall) {
  const World world = world_of("[[wall]]\npoints = [[0, 0], [0, -5]]\n");
  const auto slide = world.slide({-1, 0.3}, {1, 0}, 0.5);  // touches the end at (-0.4, 0.3): a 3-4-5 triangle
  EXPECT_TRUE(slide.touched);
  EXPECT_NEAR(slide.normal.x, -0.8, 1e-8);
  EXPECT_NEAR(slide.normal.y, 0.6, 1e-8);
  // 0.4 m are left; of them 0.6 x 0.4 along the tangent (0.6, 0.8).
  EXPECT_NEAR(slide.position.x, -0.4 + 0.24 * 0.6, 1e-8);
  EXPECT_NEAR(slide.position.y, 0.3 + 0.24 * 0.8, 1e-8);
}

TEST(Slide, PassesNoThinWallHoweverFast) {
  const World world = world_of("[[wall]]\npoints = [[1, -5], [1, 5]]\n[[disc]]\nx_m = 0\ny_m = 3\nradius_m = 0.001\n");
  EXPECT_NEAR(world.slide({0, 0}, {9000, 0}, 0.15).position.x, 0.85, kGap_m);
  EXPECT_NEAR(world.slide({0, 0}, {1e-12, 9000}, 0.15).position.y, 2.849, 1e-6);
}

TEST(Slide, StopsAtOtherRobotsAndAtMovers) {
  const World world = world_of("[[mover]]\nid = \"crate\"\nlength_m = 1\nwidth_m = 1\nplaces = [[3, 0]]\n");
  EXPECT_NEAR(world.slide({0, 0}, {5, 0}, 0.2).position.x, 2.3, kGap_m);
  const Disc others[] = {{{1, 0}, 0.2}};
  EXPECT_NEAR(world.slide({0, 0}, {5, 0}, 0.2, others).position.x, 0.6, kGap_m);
}

TEST(Slide, LetsADiscThatOverlapsLeaveAndGoNoDeeper) {
  const World world = world_of("[[box]]\nx_m = 5\ny_m = 0\nlength_m = 2\nwidth_m = 2\n");
  const Vector2 start{3.9, 0};  // 0.1 m from the side, radius 0.2
  EXPECT_EQ(world.slide(start, {-1, 0}, 0.2).position, (Vector2{2.9, 0}));
  EXPECT_NEAR(world.slide(start, {1, 0}, 0.2).position.x, 3.9, kGap_m);
}

TEST(Slide, StaysWhereItIsForAMotionThatIsNone) {
  const World world = world_of("[[box]]\nx_m = 5\ny_m = 0\nlength_m = 2\nwidth_m = 2\n");
  const double nan = std::nan("");
  EXPECT_EQ(world.slide({1, 2}, {0, 0}, 0.2).position, (Vector2{1, 2}));
  EXPECT_EQ(world.slide({1, 2}, {nan, 1}, 0.2).position, (Vector2{1, 2}));
}

double drawn(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6; }

RC_GTEST_PROP(SlideProperty, NeverEndsInsideASurfaceNorLeavesTheArena, ()) {
  const World world = random_world(*rc::gen::inRange<std::uint64_t>(1, 100'000), 40, true);
  const double radius = drawn(0.02, 0.4), longest = *rc::gen::element(0.05, 0.3, 3.0);
  Vector2 at{drawn(0.5, 19.5), drawn(0.5, 19.5)};
  if (world.clearance(at, 1) < radius) RC_DISCARD();
  double heading = drawn(-3.14, 3.14);
  for (int step = 0; step < 100; ++step) {
    heading += drawn(-0.3, 0.3);
    const Vector2 displacement = direction(heading) * longest;
    const auto slide = world.slide(at, displacement, radius);
    RC_ASSERT(world.clearance(slide.position, 1) >= radius - 1e-9);
    RC_ASSERT((Box2{{0, 0}, {20, 20}}.contains(slide.position)));
    RC_ASSERT((slide.position - at).length() <= displacement.length() + 1e-7);
    if (!slide.touched) RC_ASSERT(slide.position == at + displacement);
    if (slide.touched) RC_ASSERT(std::fabs(slide.normal.length() - 1) < 1e-12);
    at = slide.position;
  }
}

RC_GTEST_PROP(SlideProperty, KeepsTheTangentialWayOnAWallOfAnyDirection, ()) {
  const double angle = drawn(-3.14, 3.14);
  const Vector2 along = direction(angle), middle{drawn(-500, 500), drawn(-500, 500)};
  GroundPlan plan;
  plan.shapes.push_back({.points = {middle - along * 50, middle + along * 50}});
  Problems problems;
  const World world(std::make_shared<const Ground>(*Ground::make(std::move(plan), problems)));
  const double radius = drawn(0.05, 0.5);
  Vector2 at = middle + along.left() * (radius + drawn(1e-6, 0.2));
  for (int step = 0; step < 50; ++step) {
    const Vector2 displacement = along * drawn(-0.3, 0.3) + along.left() * drawn(-0.3, 0.02);
    const Vector2 next = world.slide(at, displacement, radius).position;
    RC_ASSERT(std::fabs((next - at - displacement).dot(along)) < 1e-11);
    RC_ASSERT((next - middle).dot(along.left()) >= radius - 1e-10);
    at = next;
  }
}

}  // namespace
}  // namespace ganglion::sim
