#include "ganglion/sim/simulation/neighbours.h"

#include <gtest/gtest.h>

#include "ganglion/random/draws.h"

namespace ganglion::sim {
namespace {

/// Asks all robots.
std::vector<std::uint32_t> scan(const Neighbours& all, Vector2 place, double range_m, std::size_t left_out) {
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < all.discs().size(); ++i) {
    const bool near = (all.discs()[i].position - place).squared() <= range_m * range_m;
    if (near && i != left_out) found.push_back(static_cast<std::uint32_t>(i));
  }
  return found;
}

TEST(Neighbours, AreThoseThatAScanOfAllFinds) {
  Draws draws({3, 0, 0, 1}, 0);
  for (const auto& [robots, side_m] :
       {std::pair(1, 5.0), std::pair(2, 1000.0), std::pair(50, 0.0), std::pair(300, 30.0)}) {
    Neighbours neighbours;
    neighbours.make_room(static_cast<std::size_t>(robots), 0.4, 3.3);
    auto somewhere = [&, side_m = side_m] {
      const double x = draws.uniform(-side_m, side_m);
      return Vector2{x, draws.uniform(0, side_m)};
    };
    for (std::size_t i = 0; i < neighbours.discs().size(); ++i) neighbours.put(i, {somewhere(), 0.1});
    neighbours.sort();
    for (int round = 0; round < 200; ++round) {
      const auto robot = static_cast<std::size_t>(draws.below(static_cast<std::uint32_t>(robots)));
      const Vector2 here = neighbours.discs()[robot].position;
      for (const double range_m : {0.3, 3.3, 40.0}) {
        const auto found = neighbours.within(here, range_m, robot);
        EXPECT_EQ(std::vector<std::uint32_t>(found.begin(), found.end()), scan(neighbours, here, range_m, robot));
      }
      // They move after they were sorted: a little, as lists allow, or far.
      neighbours.put(robot, {here + somewhere() * (round < 100 ? 0.001 : 0.05), 0.1});
      if (round % 20 == 0) neighbours.sort_if_needed();
    }
  }
}

}  // namespace
}  // namespace ganglion::sim
