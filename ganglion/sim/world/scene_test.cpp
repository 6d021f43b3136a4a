#include "ganglion/sim/world/scene.h"

#include <nlohmann/json.hpp>

#include "ganglion/sim/world/world_for_test.h"

namespace ganglion::sim {
namespace {

using nlohmann::json;

TEST(Scene, DrawsEveryClassOfThing) {
  World world = world_of(R"(name = "Té"
[[wall]]
points = [[0, 0], [4, 0], [4, 3], [0, 3]]
closed = true
[[disc]]
x_m = 1
y_m = 1
radius_m = 0.33333333
label = "bin"
[[mover]]
id = "cart"
length_m = 1
width_m = 0.5
path = [[2, 2], [3, 2]]
speed_mps = 1
[[spawn]]
id = "start"
x_m = 0.5
y_m = 2.5
)");
  world.advance(0, 0, 0.5, {});
  const json scene = json::parse(scene_json(world));
  EXPECT_EQ(scene["name"], "Té");
  EXPECT_EQ(scene["bounds"], (json{0, 0, 4, 3}));
  EXPECT_EQ(scene["shapes"][0]["class"], "wall");
  EXPECT_EQ(scene["shapes"][0]["points"], (json{{0, 0}, {4, 0}, {4, 3}, {0, 3}}));
  EXPECT_EQ(scene["shapes"][0]["closed"], true);
  EXPECT_EQ(scene["shapes"][1]["class"], "furniture");
  EXPECT_EQ(scene["shapes"][1]["radius"], 0.3333);
  EXPECT_EQ(scene["shapes"][1]["label"], "bin");
  EXPECT_EQ(scene["movers"][0]["pose"], (json{2.5, 2, 0}));
  EXPECT_EQ(scene["movers"][0]["points"], (json{{-0.5, -0.25}, {0.5, -0.25}, {0.5, 0.25}, {-0.5, 0.25}}));
  EXPECT_EQ(scene["spawns"][0]["pose"], (json{0.5, 2.5, 0}));
  EXPECT_FALSE(scene.contains("map"));
}

/// The cells that a list of rectangles covers, each counted as often as it is covered.
std::vector<int> painted(const json& map, const char* layer) {
  std::vector<int> cells(map["columns"].get<std::size_t>() * map["rows"].get<std::size_t>());
  for (const json& r : map[layer]) {
    for (std::size_t row = r[1]; row < r[1].get<std::size_t>() + r[3].get<std::size_t>(); ++row) {
      for (std::size_t column = r[0]; column < r[0].get<std::size_t>() + r[2].get<std::size_t>(); ++column) {
        ++cells.at(row * map["columns"].get<std::size_t>() + column);
      }
    }
  }
  return cells;
}

TEST(Scene, PaintsEachMapCellOnce) {
  GroundPlan plan;
  Draws draws({1, 0, 0, 1}, 0);
  std::vector<Occupancy> cells(40 * 30);
  for (auto& cell : cells) cell = static_cast<Occupancy>(draws.below(3));
  plan.map = OccupancyMap(40, 30, 0.1, {}, cells);
  Problems problems;
  const World world(std::make_shared<const Ground>(*Ground::make(std::move(plan), problems)));
  const json map = json::parse(scene_json(world))["map"];
  const auto occupied = painted(map, "occupied"), unknown = painted(map, "unknown");
  for (std::size_t i = 0; i < cells.size(); ++i) {
    ASSERT_EQ(occupied[i], cells[i] == Occupancy::Occupied ? 1 : 0) << i;
    ASSERT_EQ(unknown[i], cells[i] == Occupancy::Unknown ? 1 : 0) << i;
  }
}

TEST(Scene, OfTheHospitalStaysUnderAMegabyte) {
  if (data_folder().empty()) GTEST_SKIP() << "NOT CHECKED: no public data in ../shared/data or $GANGLION_DATA";
  Problems problems;
  auto ground = Ground::load(data_folder() / "maps" / "hospital_section.yaml", problems);
  ASSERT_TRUE(ground) << problems.text();
  const std::string text = scene_json(World(std::make_shared<const Ground>(std::move(*ground))));
  EXPECT_LT(text.size(), 1'000'000u);
  const auto occupied = painted(json::parse(text)["map"], "occupied");
  EXPECT_EQ(std::count(occupied.begin(), occupied.end(), 1), 74481);
}

}  // namespace
}  // namespace ganglion::sim
