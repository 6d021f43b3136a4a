#include "ganglion/grid/way/cell_grid.h"

#include <fstream>
#include <limits>

#include "ganglion/sim/world/ground_terrain.h"
#include "ganglion/sim/world/world_for_test.h"

namespace ganglion {
namespace {

using Cell = CellGrid::Cell;
const double kRoot2 = std::sqrt(2.0);
constexpr double kInf = std::numeric_limits<double>::infinity();

// 5 x 3 cells of 0.5 m.
const char* const kRoom = "[[wall]]\npoints = [[0, 0], [2.5, 0], [2.5, 1.5], [0, 1.5]]\nclosed = true\n";

CellGrid grid_of(const std::string& text, double radius_m = 0.2) {
  auto grid = CellGrid::make(sim::GroundTerrain(sim::ground_of(text)), 0.5, radius_m);
  EXPECT_TRUE(grid);
  return std::move(*grid);
}

TEST(CellGrid, NumbersCellsFromTheOriginOfTheWorld) {
  const CellGrid grid = grid_of("[[wall]]\npoints = [[-1, -0.5], [1, -0.5], [1, 1], [-1, 1]]\nclosed = true\n");
  EXPECT_EQ(grid.first(), (Cell{-2, -1}));
  EXPECT_EQ(grid.columns(), 4);
  EXPECT_EQ(grid.rows(), 3);
  EXPECT_EQ(grid.cell_at({-0.01, 0.99}), (Cell{-1, 1}));
  EXPECT_EQ(grid.centre({-1, 1}), (Vector2{-0.25, 0.75}));
  EXPECT_EQ(grid.free_cells().size(), 12u);
  EXPECT_FALSE(grid.free({2, 0}));
  EXPECT_FALSE(grid.contains(grid.cell_at({1e300, std::nan("")})));
}

TEST(CellGrid, MeasuresOctileRoutes) {
  const CellGrid grid = grid_of(kRoom);
  EXPECT_NEAR(grid.shortest_m({0, 0}, {4, 2}), 0.5 * (2 + 2 * kRoot2), 1e-12);
  EXPECT_EQ(grid.shortest_m({1, 1}, {1, 1}), 0);
  EXPECT_EQ(grid.shortest_m({0, 0}, {4, 3}), kInf);
}

TEST(CellGrid, CutsNoCorners) {
  // A box in cell (1, 0): from (0, 0) to (2, 0) the way is up, over, down: 4 straight steps, no diagonal.
  const CellGrid grid =
      grid_of(std::string(kRoom) + "[[box]]\nx_m = 0.75\ny_m = 0.25\nlength_m = 0.3\nwidth_m = 0.3\n");
  EXPECT_FALSE(grid.free({1, 0}));
  EXPECT_NEAR(grid.shortest_m({0, 0}, {2, 0}), 2, 1e-12);
  EXPECT_FALSE(grid.step_free({0, 0}, {1, 1}));
  EXPECT_TRUE(grid.step_free({0, 1}, {1, 2}));
}

TEST(CellGrid, CutsNoCornerOfACellThatOnlyASmallThingTakes) {
  // The post is 0.35 m from the diagonal's middle, far out of a small robot's way; its cell is taken all the same.
  const CellGrid grid = grid_of(std::string(kRoom) + "[[disc]]\nx_m = 0.75\ny_m = 0.25\nradius_m = 0.05\n", 0.1);
  EXPECT_FALSE(grid.free({1, 0}));
  EXPECT_TRUE(grid.free({1, 1}));
  EXPECT_FALSE(grid.step_free({0, 0}, {1, 1}));
}

TEST(CellGrid, StepsThroughNoThinWall) {
  const CellGrid grid = grid_of(std::string(kRoom) + "[[wall]]\npoints = [[1, 0], [1, 1]]\n");
  EXPECT_TRUE(grid.free({1, 0}));
  EXPECT_TRUE(grid.free({2, 0}));
  EXPECT_FALSE(grid.step_free({1, 0}, {2, 0}));
  // From (1, 0) round the wall's end: up to (1, 2), over, down to (2, 0); the wall's end stands in the diagonals' way.
  EXPECT_NEAR(grid.shortest_m({1, 0}, {2, 0}), 0.5 * 5, 1e-12);
}

TEST(CellGrid, LetsARobotAsWideAsItsCellStandBetweenWalls) {
  EXPECT_EQ(grid_of(kRoom, 0.25).free_cells().size(), 15u);
  EXPECT_EQ(grid_of(kRoom, 0.26).free_cells().size(), 3u);  // only the middle of the room
}

TEST(CellGrid, FindsNoWayIntoASealedRoomAndSaysWhatCanBeReached) {
  const CellGrid grid = grid_of(std::string(kRoom) + "[[wall]]\npoints = [[1, 0], [1, 1.5]]\n");
  EXPECT_EQ(grid.shortest_m({0, 0}, {3, 0}), kInf);
  EXPECT_EQ(grid.reachable_from({0, 0}).size(), 6u);
  EXPECT_EQ(grid.reachable_from({4, 2}).size(), 9u);
  EXPECT_TRUE(grid.reachable_from({9, 9}).empty());
}

TEST(CellGrid, GoesRoundBlockedCellsWithoutPassingTheirCorners) {
  const CellGrid grid = grid_of(kRoom);
  const Cell blocked[] = {{1, 0}, {1, 1}};
  EXPECT_NEAR(grid.shortest_m({0, 0}, {2, 0}, blocked), 0.5 * 6, 1e-12);
  const Cell wall[] = {{1, 0}, {1, 1}, {1, 2}, {77, 0}};
  EXPECT_EQ(grid.shortest_m({0, 0}, {2, 0}, wall), kInf);
  EXPECT_EQ(grid.reachable_from({0, 0}, wall).size(), 3u);
  CellGrid::Workspace work = grid.make_workspace();
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(grid.shortest_m({0, 0}, {2, 0}, blocked, work), 3, 1e-12);
    EXPECT_NEAR(grid.shortest_m({0, 0}, {2, 0}, {}, work), 1, 1e-12);
  }
}

TEST(CellGrid, KnowsTheCellsThatMoversTake) {
  const std::string mover = "[[mover]]\nid = \"crate\"\nlength_m = 0.5\nwidth_m = 0.5\nplaces = [[0.75, 0.75]]\n";
  const sim::World world = sim::world_of(std::string(kRoom) + mover);
  const CellGrid grid = *CellGrid::make(sim::GroundTerrain(world.shared_ground()), 0.5, 0.2);
  EXPECT_EQ(grid.taken_by_movers(sim::GroundTerrain(world.shared_ground(), &world)), (std::vector<Cell>{{1, 1}}));
  const CellGrid wide = *CellGrid::make(sim::GroundTerrain(world.shared_ground()), 0.5, 0.24);
  EXPECT_EQ(wide.taken_by_movers(sim::GroundTerrain(world.shared_ground(), &world)).size(), 1u);
}

TEST(CellGrid, RefusesSizesThatMakeNoSense) {
  const auto ground = sim::ground_of(kRoom);
  EXPECT_EQ(CellGrid::make(sim::GroundTerrain(ground), 0, 0.1).error().code, ErrorCode::BadParameter);
  EXPECT_EQ(CellGrid::make(sim::GroundTerrain(ground), std::nan(""), 0.1).error().code, ErrorCode::BadParameter);
  EXPECT_EQ(CellGrid::make(sim::GroundTerrain(ground), 0.5, -1).error().code, ErrorCode::BadParameter);
  EXPECT_EQ(CellGrid::make(sim::GroundTerrain(ground), 1e-5, 0.1).error().code, ErrorCode::TooLarge);
}

/// A MovingAI map as an occupancy map of cells of 1 m. The files count rows from the top.
sim::OccupancyMap read_octile_map(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string word, line;
  int rows = 0, columns = 0;
  file >> word >> word >> word >> rows >> word >> columns >> word;
  std::vector<sim::Occupancy> cells(static_cast<std::size_t>(rows) * columns);
  for (int row = 0; row < rows; ++row) {
    file >> line;
    for (int column = 0; column < columns; ++column) {
      const bool free = std::string_view(".GS").find(line.at(column)) != std::string_view::npos;
      cells[static_cast<std::size_t>(rows - 1 - row) * columns + column] =
          free ? sim::Occupancy::Free : sim::Occupancy::Occupied;
    }
  }
  return sim::OccupancyMap(columns, rows, 1, Pose2{}, std::move(cells));
}

TEST(CellGrid, FindsThePublishedOptimaOfTheMovingAiMaps) {
  const auto folder = sim::data_folder() / "movingai";
  if (sim::data_folder().empty()) GTEST_SKIP() << "NOT CHECKED: no public data in ../shared/data or $GANGLION_DATA";
  for (const std::string name : {"arena.map", "lak303d.map"}) {
    sim::GroundPlan plan;
    plan.map = read_octile_map(folder / name);
    const int rows = plan.map->rows();
    Problems problems;
    const auto ground = sim::Ground::make(std::move(plan), problems);
    ASSERT_TRUE(ground) << problems.text();
    const sim::GroundTerrain terrain(std::make_shared<const sim::Ground>(*ground));
    const CellGrid grid = *CellGrid::make(terrain, 1, 0.4);
    CellGrid::Workspace work = grid.make_workspace();
    std::ifstream queries(folder / (name + ".scen"));
    std::string line;
    std::getline(queries, line);
    for (int i = 0; std::getline(queries, line); ++i) {
      if (i % 150 != 0) continue;
      const auto field = split(line, '\t');
      auto at = [&](int k) { return static_cast<int>(*parse_number(field[static_cast<std::size_t>(k)])); };
      const double optimum = *parse_number(trimmed(field[8]));
      const double found = grid.shortest_m({at(4), rows - 1 - at(5)}, {at(6), rows - 1 - at(7)}, {}, work);
      ASSERT_NEAR(found, optimum, 1e-5 * (1 + optimum)) << name << " query " << i;
    }
  }
}

}  // namespace
}  // namespace ganglion
