#include "ganglion/grid/way/steered_way.h"

#include <array>
#include <cmath>
#include <limits>

#include "ganglion/sim/world/ground_terrain.h"
#include "ganglion/sim/world/world_for_test.h"

namespace ganglion {
namespace {

using Cell = CellGrid::Cell;
const double kRoot2 = std::sqrt(2.0);
constexpr double kInf = std::numeric_limits<double>::infinity();

CellGrid grid_of(const std::string& text) {
  return *CellGrid::make(sim::GroundTerrain(sim::ground_of(text)), 0.5, 0.2);
}

/// Columns x rows cells of 0.5 m from the origin, walls round them and nothing within.
std::string room(int columns, int rows) {
  return "[[wall]]\nclosed = true\npoints = [[0, 0], [" + std::to_string(0.5 * columns) + ", 0], [" +
         std::to_string(0.5 * columns) + ", " + std::to_string(0.5 * rows) + "], [0, " + std::to_string(0.5 * rows) +
         "]]\n";
}

std::string block(int column, int row) {
  return "[[box]]\nx_m = " + std::to_string(0.5 * column + 0.25) + "\ny_m = " + std::to_string(0.5 * row + 0.25) +
         "\nlength_m = 0.3\nwidth_m = 0.3\n";
}

double way_m(const CellGrid& grid, int max_turn, Cell from, int heading, Cell to) {
  return SteeredWay::make(grid, max_turn)->shortest_m(grid, from, heading, to);
}

TEST(SteeredWay, GoesStraightAheadAsAnyRobotWould) {
  const CellGrid grid = grid_of(room(5, 5));
  EXPECT_NEAR(way_m(grid, 1, {0, 0}, 0, {4, 0}), 2, 1e-12);
  EXPECT_NEAR(way_m(grid, 1, {0, 0}, 1, {4, 4}), 2 * kRoot2, 1e-12);
  EXPECT_EQ(way_m(grid, 1, {2, 2}, 3, {2, 2}), 0);
}

TEST(SteeredWay, ReachesWhatIsRightBehindInOneStepBack) {
  const CellGrid grid = grid_of(room(5, 5));
  for (int heading : {7, 0, 1}) EXPECT_NEAR(way_m(grid, 1, {2, 2}, heading, {1, 2}), 0.5, 1e-12) << heading;
}

TEST(SteeredWay, TakesTwoStepsToTheCellBesideUnlessItTurnsFarEnough) {
  // North-east and back west: two straight steps end on a cell of the same colour of a chessboard, as two diagonals do.
  const CellGrid grid = grid_of(room(5, 5));
  EXPECT_NEAR(way_m(grid, 1, {2, 2}, 0, {2, 3}), 0.5 * (1 + kRoot2), 1e-12);
  EXPECT_NEAR(way_m(grid, 2, {2, 2}, 0, {2, 3}), 0.5, 1e-12);
  EXPECT_NEAR(way_m(grid, 4, {2, 2}, 0, {2, 3}), 0.5, 1e-12);
}

TEST(SteeredWay, LeavesADeadEndBackwards) {
  const CellGrid grid = grid_of(room(4, 1));
  EXPECT_NEAR(way_m(grid, 1, {0, 0}, 4, {3, 0}), 1.5, 1e-12);  // nose in the dead end
  EXPECT_NEAR(way_m(grid, 1, {0, 0}, 3, {3, 0}), 1.5, 1e-12);
}

TEST(SteeredWay, FindsNoWayWhereATurnHasNoRoom) {
  const CellGrid corridor = grid_of(room(4, 1));
  EXPECT_EQ(way_m(corridor, 1, {0, 0}, 2, {3, 0}), kInf);  // across the corridor
  EXPECT_NEAR(way_m(corridor, 2, {0, 0}, 2, {3, 0}), 1.5, 1e-12);
  // A bend of two corridors one cell wide: east to (1, 0), then north. The box of (0, 1) leaves no diagonal.
  const CellGrid bend = grid_of(room(2, 2) + block(0, 1));
  EXPECT_EQ(way_m(bend, 1, {0, 0}, 0, {1, 1}), kInf);
  EXPECT_NEAR(way_m(bend, 2, {0, 0}, 0, {1, 1}), 1, 1e-12);
}

TEST(SteeredWay, TurnsRoundInTheRoomThatThereIs) {
  // A bend with one more cell at its outer side, (2, 0): past the corner nothing is gained, as 90 deg stay 90 deg.
  const CellGrid stub = grid_of(room(3, 2) + block(0, 1) + block(2, 1));
  EXPECT_EQ(way_m(stub, 1, {0, 0}, 0, {1, 1}), kInf);
  // With (2, 1) free as well: past the corner to (2, 0), back north-west to (1, 1): its heading turns by 45 deg.
  const CellGrid wide = grid_of(room(3, 2) + block(0, 1));
  EXPECT_NEAR(way_m(wide, 1, {0, 0}, 0, {1, 1}), 0.5 * (2 + kRoot2), 1e-12);
}

TEST(SteeredWay, FindsNoWayFromOrToCellsThatAreNotFree) {
  const CellGrid grid = grid_of(room(3, 3) + block(1, 1));
  EXPECT_EQ(way_m(grid, 4, {1, 1}, 0, {0, 0}), kInf);
  EXPECT_EQ(way_m(grid, 4, {0, 0}, 0, {1, 1}), kInf);
  EXPECT_EQ(way_m(grid, 4, {0, 0}, 0, {9, 9}), kInf);
}

TEST(SteeredWay, RefusesOtherTurnsAndTooManyCells) {
  const CellGrid grid = grid_of(room(3, 3));
  for (int turn : {-1, 0, 3, 5}) EXPECT_EQ(SteeredWay::make(grid, turn).error().code, ErrorCode::BadParameter);
  const CellGrid large =
      *CellGrid::make(sim::GroundTerrain(sim::ground_of(room(100, 100))), 0.04, 30);  // 1250 x 1250, none of them free
  EXPECT_EQ(SteeredWay::make(large, 1).error().code, ErrorCode::TooLarge);
}

/// Lengths [cells] to every cell from one pose, by relaxing every step again and again until nothing gets shorter.
/// Headings as vectors, turns as angles between them: nothing in common with the search under test.
std::vector<double> relaxed(const CellGrid& grid, int turn, Cell from, int heading) {
  const int columns = grid.columns(), rows = grid.rows();
  auto at = [&](Cell cell, int h) { return static_cast<std::size_t>((cell.row * columns + cell.column) * 8 + h); };
  std::vector<double> length(static_cast<std::size_t>(columns) * rows * 8, kInf);
  length[at(from, heading)] = 0;
  for (bool shorter = true; shorter;) {
    shorter = false;
    for (int i = 0; i < columns * rows * 8; ++i) {
      const Cell cell{i / 8 % columns, i / 8 / columns};
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) {
          if (!grid.step_free(cell, {cell.column + dx, cell.row + dy})) continue;
          for (const int motion : {1, -1}) {
            const double rad = std::atan2(motion * dy, motion * dx);
            const double change = std::fabs(std::remainder(rad - i % 8 * kPi / 4, 2 * kPi));
            if (change > turn * kPi / 4 + 1e-6) continue;
            const int after = static_cast<int>(std::lround(rad / (kPi / 4)) + 8) % 8;
            double& best = length[at({cell.column + dx, cell.row + dy}, after)];
            const double candidate = length[static_cast<std::size_t>(i)] + std::sqrt(dx * dx + dy * dy);
            if (candidate < best - 1e-9) {
              best = candidate;
              shorter = true;
            }
          }
        }
      }
    }
  }
  return length;
}

TEST(SteeredWay, IsAsShortAsRelaxingEveryStepSays) {
  int farther = 0, cut_off = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Draws draws({seed, 0, 0, 3}, 0);
    auto below = [&](int n) { return static_cast<int>(draws.below(static_cast<std::uint32_t>(n))); };
    const int columns = 3 + below(4), rows = 3 + below(4);
    std::string text = room(columns, rows);
    for (int n = below(columns * rows / 2); n > 0; --n) {
      const int column = below(columns);
      text += block(column, below(rows));
    }
    const CellGrid grid = grid_of(text);
    const auto free_cells = grid.free_cells();
    if (free_cells.empty()) continue;
    const Cell from = free_cells[static_cast<std::size_t>(below(static_cast<int>(free_cells.size())))];
    const int heading = below(8);
    for (int turn : {1, 2, 4}) {
      const auto expected = relaxed(grid, turn, from, heading);
      SteeredWay way = *SteeredWay::make(grid, turn);
      for (int i = 0; i < columns * rows; ++i) {
        const Cell to{i % columns, i / columns};
        const auto first = expected.begin() + i * 8;
        const double length_m = way.shortest_m(grid, from, heading, to),
                     best = 0.5 * *std::min_element(first, first + 8);
        if (std::isinf(best)) {
          ASSERT_EQ(length_m, kInf) << "seed " << seed << " turn " << turn << " cell " << i;
        } else {
          ASSERT_NEAR(length_m, best, 1e-9) << "seed " << seed << " turn " << turn << " cell " << i;
        }
        const double on_the_spot_m = grid.shortest_m(from, to);
        if (turn == 4) {
          ASSERT_EQ(length_m, on_the_spot_m) << "seed " << seed << " cell " << i;
        }
        farther += std::isfinite(length_m) && length_m > on_the_spot_m + 1e-9 ? 1 : 0;
        cut_off += std::isinf(length_m) && std::isfinite(on_the_spot_m) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(farther, 50);  // or the grids tell the turns apart too rarely
  EXPECT_GT(cut_off, 10);
}

}  // namespace
}  // namespace ganglion
