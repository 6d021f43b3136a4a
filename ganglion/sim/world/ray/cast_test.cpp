#include <algorithm>
#include <cmath>
#include <optional>

#include "ganglion/sim/world/world_for_test.h"

namespace ganglion::sim {
namespace {

const double kRoot2 = std::sqrt(2.0);
constexpr double kInf = std::numeric_limits<double>::infinity();

void expect_hit(const std::optional<Hit>& hit, double range_m, Vector2 normal) {
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range_m, range_m, 1e-12);
  EXPECT_NEAR(hit->normal.x, normal.x, 1e-12);
  EXPECT_NEAR(hit->normal.y, normal.y, 1e-12);
}

const char* const kBox = "[[box]]\nx_m = 5\ny_m = 0\nlength_m = 2\nwidth_m = 2\nmaterial = \"smooth\"\n";

TEST(Cast, MeetsTheNearSideOfABox) {
  const World world = world_of(kBox);
  expect_hit(world.cast({0, 0}, {1, 0}, 10), 4, {-1, 0});
  expect_hit(world.cast({5, -7}, {0, 1}, 10), 6, {0, -1});
  EXPECT_EQ(world.cast({0, 0}, {1, 0}, 10)->material, Material::Smooth);
  EXPECT_FALSE(world.cast({0, 0}, {-1, 0}, 10));
  EXPECT_FALSE(world.cast({0, 1.001}, {1, 0}, 10));
}

TEST(Cast, MeetsATurnedBoxOnItsSlope) {
  const World world = world_of(std::string(kBox) + "yaw_deg = 45\n");
  // The left corner is (5 - sqrt 2, 0); the upper left side climbs from there at 45 degrees.
  expect_hit(world.cast({0, 0.5}, {1, 0}, 10), 5 - kRoot2 + 0.5, {-1 / kRoot2, 1 / kRoot2});
}

TEST(Cast, MeetsADiscWhereThePythagoreanTriangleSays) {
  const World world = world_of("[[disc]]\nx_m = 5\ny_m = 0\nradius_m = 1\n");
  expect_hit(world.cast({0, 0}, {1, 0}, 10), 4, {-1, 0});
  expect_hit(world.cast({0, 0.6}, {1, 0}, 10), 4.2, {-0.8, 0.6});
  EXPECT_FALSE(world.cast({0, 1.0001}, {1, 0}, 10));
}

TEST(Cast, MeetsASlantingWallFromEitherSide) {
  const World world = world_of("[[wall]]\npoints = [[0, 2], [2, 0]]\n");
  expect_hit(world.cast({0, 0}, {1 / kRoot2, 1 / kRoot2}, 10), kRoot2, {-1 / kRoot2, -1 / kRoot2});
  expect_hit(world.cast({2, 2}, {-1 / kRoot2, -1 / kRoot2}, 10), kRoot2, {1 / kRoot2, 1 / kRoot2});
}

TEST(Cast, RunsPastAWallItIsParallelTo) {
  const World world = world_of("[[wall]]\npoints = [[1, 0], [3, 0]]\n[[wall]]\npoints = [[4, -1], [4, 1]]\n");
  expect_hit(world.cast({0, 0}, {1, 0}, 10), 4, {-1, 0});     // in the wall's own line
  expect_hit(world.cast({0, 1e-9}, {1, 0}, 10), 4, {-1, 0});  // beside it
}

TEST(Cast, MeetsTheCornerWhenItRunsAlongTheSideOfABox) {
  expect_hit(world_of(kBox).cast({0, 1}, {1, 0}, 10), 4, {-1, 0});
}

TEST(Cast, HitsAtOnceFromInsideASolid) {
  expect_hit(world_of(kBox).cast({5, 0.2}, {0, 1}, 10), 0, {0, -1});
  expect_hit(world_of("[[disc]]\nx_m = 5\ny_m = 0\nradius_m = 1\n").cast({5.5, 0}, {1, 0}, 10), 0, {-1, 0});
  const World triangle = world_of("[[polygon]]\npoints = [[0, 0], [0, 2], [2, 0]]\n");  // given clockwise
  expect_hit(triangle.cast({0.5, 0.5}, {1, 0}, 10), 0, {-1, 0});
}

TEST(Cast, SeesTheInnerSideOfAClosedWall) {
  const World world = world_of("[[wall]]\npoints = [[0, 0], [4, 0], [4, 3], [0, 3]]\nclosed = true\n");
  expect_hit(world.cast({1, 1}, {1, 0}, 10), 3, {-1, 0});
  expect_hit(world.cast({1, 1}, {0, -1}, kInf), 1, {0, 1});
}

TEST(Cast, CountsASurfaceAtItsLastCentimetreAndNotBeyond) {
  const World world = world_of(kBox);
  EXPECT_TRUE(world.cast({0, 0}, {1, 0}, 4));
  EXPECT_FALSE(world.cast({0, 0}, {1, 0}, std::nextafter(4.0, 0.0)));
  EXPECT_FALSE(world.cast({0, 0}, {1, 0}, 0));
}

TEST(Cast, GivesNothingForRaysThatAreNoRays) {
  const World world = world_of(kBox);
  const double nan = std::nan("");
  EXPECT_FALSE(world.cast({nan, 0}, {1, 0}, 10));
  EXPECT_FALSE(world.cast({0, 0}, {nan, nan}, 10));
  EXPECT_FALSE(world.cast({kInf, 0}, {-1, 0}, kInf));
  EXPECT_FALSE(world.cast({0, 0}, {0, 0}, 10));
  EXPECT_FALSE(world.cast({0, 0}, {1, 0}, nan));
}

TEST(Cast, NeverLeaksThroughACornerOrAJoint) {
  std::string points;
  for (int i = 0; i < 40; ++i) {  // a wavy closed wall
    const double angle = 2 * kPi * i / 40, radius = 3 + (i % 2);
    points += fmt::format("[{}, {}],", radius * std::cos(angle), radius * std::sin(angle));
  }
  const World world = world_of("[[wall]]\nclosed = true\npoints = [" + points + "]\n");
  Draws draws({1, 0, 0, 1}, 0);
  for (int i = 0; i < 20'000; ++i) {
    const double x = draws.uniform(-2, 2);
    const Vector2 from{x, draws.uniform(-2, 2)};
    const Vector2 corner = world.ground().plan().shapes.front().points[i % 40];
    const Vector2 way = corner - from;
    ASSERT_TRUE(world.cast(from, way * (1 / way.length()), 20)) << from.x << " " << from.y;
  }
}

TEST(Cast, ThatOnlyBrushesACornerIsNotInsideTheBox) {
  const World world = world_of(std::string(kBox) + "yaw_deg = 20\n");
  Draws draws({2, 0, 0, 1}, 0);
  for (int i = 0; i < 20'000; ++i) {
    const double x = draws.uniform(0, 10);
    const Vector2 from{x, draws.uniform(-5, 5)};
    if ((from - Vector2{5, 0}).length() < 2) continue;  // half the diagonal is 1.41 m
    const Vector2 way = world.ground().plan().shapes.front().points[i % 4] - from;
    const auto hit = world.cast(from, way * (1 / way.length()), 20);
    if (hit) {
      ASSERT_GT(hit->range_m, 0.5) << from.x << " " << from.y;
    }
  }
}

TEST(FarWall, LooksThroughFurniture) {
  const auto ground = ground_of(std::string(kBox) + "[[wall]]\npoints = [[9, -1], [9, 1]]\n");
  EXPECT_NEAR(ground->far_wall_m({0, 0}, {1, 0}), 9, 1e-12);
  EXPECT_EQ(ground->far_wall_m({0, 0}, {0, 1}), kInf);
}

/// What every textbook has: solves from + t * d = a + u * (b - a).
double textbook_range(Vector2 from, Vector2 d, Vector2 a, Vector2 b) {
  const Vector2 e = b - a, w = a - from;
  const double determinant = -d.x * e.y + d.y * e.x;
  if (determinant == 0) return kInf;
  const double t = (-w.x * e.y + w.y * e.x) / determinant, u = (d.x * w.y - d.y * w.x) / determinant;
  return t >= 0 && u >= 0 && u <= 1 ? t : kInf;
}

double textbook_range(Vector2 from, Vector2 d, const Disc& disc) {
  const Vector2 m = from - disc.position;
  const double b = m.x * d.x + m.y * d.y, c = m.x * m.x + m.y * m.y - disc.radius_m * disc.radius_m;
  if (b * b - c < 0) return kInf;
  const double near = -b - std::sqrt(b * b - c);
  return near >= 0 ? near : kInf;
}

double brute_force(const GroundPlan& plan, Vector2 from, Vector2 d, bool structural_only) {
  double best = kInf;
  for (const Shape& shape : plan.shapes) {
    if (structural_only && !shape.structural) continue;
    if (shape.kind == ShapeKind::Disc) best = std::min(best, textbook_range(from, d, shape.disc));
    const bool ring = shape.closed || shape.kind != ShapeKind::Wall;
    for (std::size_t i = 0; i + (ring ? 0 : 1) < shape.points.size(); ++i) {
      best = std::min(best, textbook_range(from, d, shape.points[i], shape.points[(i + 1) % shape.points.size()]));
    }
  }
  return best;
}

TEST(Cast, AgreesWithALoopOverAllSurfaces) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const World world = random_world(seed, seed % 2 == 0 ? 12 : 150, seed % 3 != 0);
    Draws draws({seed, 0, 0, 2}, 0);
    for (int i = 0; i < 2000; ++i) {
      const double x = draws.uniform(-3, 23);
      const Vector2 from{x, draws.uniform(-3, 23)}, d = direction(draws.uniform(-3.2, 3.2));
      if (world.ground().inside_solid(from)) continue;
      const double limit = i % 2 == 0 ? 3.0 : kInf, expected = brute_force(world.ground().plan(), from, d, false);
      const auto hit = world.cast(from, d, limit);
      ASSERT_EQ(hit.has_value(), expected < kInf && expected <= limit) << "seed " << seed << ", ray " << i;
      if (hit) {
        ASSERT_NEAR(hit->range_m, expected, 1e-9) << "seed " << seed << ", ray " << i;
        ASSERT_LT(hit->normal.dot(d), 0);
      }
      const double wall = brute_force(world.ground().plan(), from, d, true);
      ASSERT_NEAR(std::min(world.ground().far_wall_m(from, d), 1e6), std::min(wall, 1e6), 1e-9);
    }
  }
}

TEST(Clearance, IsTheDistanceToTheNearestSurfaceAndNegativeInside) {
  const World world = world_of(kBox);
  EXPECT_NEAR(world.clearance({3, 0}, 5), 1, 1e-12);
  EXPECT_NEAR(world.clearance({3, 2}, 5), kRoot2, 1e-12);  // to the corner (4, 1)
  EXPECT_EQ(world.clearance({0, 0}, 2), 2);
  EXPECT_NEAR(world.clearance({4.25, 0}, 5), -0.25, 1e-12);
  EXPECT_NEAR(world.clearance({-20, 0}, 100), 24, 1e-12);  // from far outside the drawing
}

TEST(Clearance, IsRightAlongARowOfThings) {
  Draws draws({3, 0, 0, 1}, 0);
  for (int row = 0; row < 200; ++row) {  // a grid of one row: only left and right count
    GroundPlan plan;
    for (int i = 0; i < 6; ++i) {
      plan.shapes.push_back({.kind = ShapeKind::Disc, .disc = {{draws.uniform(0, 20), 0}, 0.01}});
    }
    Problems problems;
    const auto ground = Ground::make(std::move(plan), problems);
    ASSERT_TRUE(ground);
    for (int i = 0; i < 100; ++i) {
      const double x = draws.uniform(-1, 21);
      double expected = kInf;
      for (const Shape& shape : ground->plan().shapes) {
        expected = std::min(expected, std::fabs(std::fabs(x - shape.disc.position.x) - 0.01));
      }
      ASSERT_NEAR(std::fabs(ground->clearance({x, 0}, 100)), expected, 1e-12) << x;
    }
  }
}

TEST(Clearance, AgreesWithALoopOverAllSurfaces) {
  const World world = random_world(5, 150, true);
  Draws draws({9, 0, 0, 2}, 0);
  for (int i = 0; i < 2000; ++i) {
    const double x = draws.uniform(-3, 23);
    const Vector2 point{x, draws.uniform(-3, 23)};
    double expected = kInf;
    for (const Segment& s : world.ground().surfaces().set().segments) {
      const double t = std::clamp((point - s.from).dot(s.to - s.from) / (s.to - s.from).squared(), 0.0, 1.0);
      expected = std::min(expected, (point - s.from - (s.to - s.from) * t).length());
    }
    for (const RoundSurface& r : world.ground().surfaces().set().rounds) {
      expected = std::min(expected, std::fabs((point - r.disc.position).length() - r.disc.radius_m));
    }
    ASSERT_NEAR(std::fabs(world.clearance(point, 0.7)), std::min(expected, 0.7), 1e-9);
    ASSERT_NEAR(std::fabs(world.clearance(point, 70)), expected, 1e-9);
  }
}

}  // namespace
}  // namespace ganglion::sim
