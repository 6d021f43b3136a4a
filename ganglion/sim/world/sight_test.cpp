// Rays cast side by side find what World::cast() finds one by one, to the bit, in every form of the lanes.
#include "ganglion/sim/world/sight.h"

#include <cstring>

#include "ganglion/sim/world/world_for_test.h"

namespace ganglion::sim {
namespace {

constexpr double kReach_m = 3;
constexpr double kSpread_m = 0.15;

std::vector<Disc> random_discs(Draws& draws, Vector2 about, int count) {
  std::vector<Disc> discs;
  for (int i = 0; i < count; ++i) {
    const Vector2 away = direction(draws.uniform(-kPi, kPi)) * draws.uniform(0.5, 3);
    discs.push_back({about + away, draws.uniform(0.05, 0.3)});
  }
  return discs;
}

/// What a ray meets first, surface by surface.
Hit one_by_one(const World& world, const std::vector<Disc>& others, const Ray& ray, double max_range_m) {
  const auto fixed = world.cast(ray.from, ray.direction, max_range_m);
  Hit best = fixed.value_or(Hit{kNoHit, {}, Material::Rough});
  for (const Disc& other : others) {
    const double range_m = range_to_disc(ray, other);
    if (!(range_m < best.range_m && range_m <= max_range_m)) continue;
    const Vector2 out = ray.from + ray.direction * range_m - other.position;
    best = {range_m, out * (1 / other.radius_m), Material::Rough};
  }
  return best;
}

::testing::AssertionResult same_bits(const Hit& a, const Hit& b) {
  auto equal = [](double x, double y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  if (equal(a.range_m, b.range_m) && equal(a.normal.x, b.normal.x) && equal(a.normal.y, b.normal.y) &&
      a.material == b.material) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure() << a.range_m << " (" << a.normal.x << ", " << a.normal.y << ") or " << b.range_m
                                       << " (" << b.normal.x << ", " << b.normal.y << ")";
}

/// Twelve single rays on a rim, and a cone of seven from one point of it.
struct Eyes {
  std::vector<Ray> rays;
  RayFan fan;
  std::vector<std::size_t> places;
  std::size_t singles = 0, cone = 0;
};
Eyes eyes(Vector2 at) {
  Eyes eyes;
  for (int k = 0; k < 12; ++k) {
    const Vector2 out = direction(k * kPi / 6);
    eyes.rays.push_back({at + out * kSpread_m, out});
  }
  for (int k = 0; k < 7; ++k) eyes.rays.push_back({at + Vector2{0, kSpread_m}, direction(0.9 + 0.1 * k)});
  for (std::size_t n = 0; n < eyes.rays.size(); ++n) {
    eyes.places.push_back(eyes.fan.add(eyes.rays[n], kReach_m));
    if (n == 11) eyes.singles = eyes.fan.close_group(false);
  }
  eyes.cone = eyes.fan.close_group(true);
  return eyes;
}

void compare(const World& world, Vector2 centre, Draws& draws, const Lanes& form) {
  const std::vector<Disc> others = random_discs(draws, centre, 9);
  Sight sight(world.shared_ground(), kReach_m, kSpread_m, others.size(), form);
  sight.look(world, centre, others);
  Eyes own = eyes(centre);
  for (const std::size_t group : {own.singles, own.cone}) sight.cast(own.fan, group, {}, {1, 0});
  for (std::size_t n = 0; n < own.rays.size(); ++n) {
    const Hit expected = one_by_one(world, others, own.rays[n], kReach_m);
    EXPECT_TRUE(same_bits(sight.hit(own.fan, own.places[n]), expected)) << form.name << ", ray " << n;
  }
  for (int n = 0; n < 20; ++n) {  // mirrored rays begin anywhere
    const Ray ray{centre + direction(draws.uniform(-kPi, kPi)) * draws.uniform(0, 2),
                  direction(draws.uniform(-kPi, kPi))};
    if (world.clearance(ray.from, 1) <= 0) continue;  // in the open, as all mirrored rays
    ASSERT_TRUE(sight.covers(ray.from, 1));
    EXPECT_TRUE(same_bits(sight.cast(ray, 1), one_by_one(world, others, ray, 1))) << form.name;
  }
}

TEST(Sight, FindsWhatRaysFindOneByOneInEveryForm) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const World world = random_world(seed, 60, true);
    for (const Lanes* form : available_lanes()) {
      Draws draws({seed, 0, 0, 99}, 0);
      for (int n = 0; n < 20; ++n) {
        const double x = draws.uniform(0, 20);
        const Vector2 centre{x, draws.uniform(0, 20)};
        if (world.clearance(centre, 1) < kSpread_m) continue;  // robots stand outside solids
        compare(world, centre, draws, *form);
      }
    }
  }
}

TEST(Sight, WalksWhereACellSeesTooMuch) {
  std::string text = "name = \"w\"\n";
  for (int n = 0; n < 200; ++n)
    text +=
        "[[wall]]\npoints = [[" + std::to_string(n * 0.02) + ", 1], [" + std::to_string(n * 0.02 + 0.01) + ", 1.5]]\n";
  const World world = world_of(text);
  EXPECT_FALSE(world.ground().near_surfaces(kReach_m, kSpread_m)->at({2, 1.2}).listed);
  for (const Lanes* form : available_lanes()) {
    Draws draws({5, 0, 0, 99}, 0);
    compare(world, {2.005, 0.5}, draws, *form);
  }
}

TEST(Sight, SeesMoversWhereTheyStand) {
  const World world = world_of(
      "name = \"w\"\n[[wall]]\npoints = [[3, -5], [3, 5]]\n"
      "[[mover]]\nid = \"m\"\nradius_m = 0.5\nplaces = [[2, 0], [9, 9]]\nchange_after_s = [5, 6]\n");
  for (const Lanes* form : available_lanes()) {
    Draws draws({5, 0, 0, 99}, 0);
    compare(world, {0.5, 0}, draws, *form);
    Sight sight(world.shared_ground(), kReach_m, kSpread_m, 0, *form);
    sight.look(world, {0.5, 0}, {});
    EXPECT_NEAR(sight.cast({{0.5, 0}, {1, 0}}, 3).range_m, 1, 1e-12);
  }
}

TEST(Sight, ListsTheFarSidesOfASolidForMirroredRaysOnly) {
  const World world = world_of(
      "name = \"w\"\n[[box]]\nx_m = 2\ny_m = 0\nlength_m = 1\nwidth_m = 1\n[[wall]]\npoints = [[0, -2], [0, 2]]\n");
  const auto list = world.ground().near_surfaces(kReach_m, kSpread_m)->at({0.1, 0.1});
  // The cell is x 0..0.5, y 0..0.5, and rays begin up to 0.15 m off it: level with the box's upper side at y = 0.5, so
  // that this one stays; behind the lower side at y = -0.5 and the far one.
  EXPECT_EQ(list.facing.size(), 3u);  // the wall, the box's near side, its upper side
  EXPECT_EQ(list.averted.size(), 2u);
}

}  // namespace
}  // namespace ganglion::sim
