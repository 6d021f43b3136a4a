#include "ganglion/sim/world/shape/floor.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "ganglion/sim/world/scene.h"
#include "ganglion/sim/world/world_for_test.h"

namespace ganglion::sim {
namespace {

const char* const kFloor = R"(
[[floor]]
id = "ramp"
x_m = 2
y_m = 0
length_m = 4
width_m = 2
slope_deg = 45
height_m = 0.5
slip = 0.3
colour = "#ff8000"
[[floor]]
points = [[3, -1], [3, 1], [5, 0]]
warmer_C = 7
[[floor]]
x_m = -3
y_m = 0
radius_m = 1
slope_deg = 10
uphill_deg = 90
[[bump]]
id = "cable"
points = [[0, 5], [1, 5], [1, 6]]
turn_deg = 8
[[beacon]]
id = "lamp"
x_m = 1
y_m = 2
light_range_m = 4
colour = "#00ff00"
)";

TEST(Floor, KnowsWhatLiesWhere) {
  const auto ground = ground_of(kFloor);
  const Floor& floor = ground->plan().floor;
  EXPECT_EQ(floor.zone_at({-0.01, 0}), nullptr);
  EXPECT_EQ(floor.zone_at({0.01, 0.99})->id, "ramp");
  EXPECT_EQ(floor.zone_at({3.5, 0.2})->warmer_C, 7);  // lies on the ramp: the later one counts
  EXPECT_EQ(floor.zone_at({3.5, 0.9})->id, "ramp");   // beside the triangle
  EXPECT_EQ(floor.colour_at({1, 0}), (Colour{1, 128 / 255.0, 0}));
  EXPECT_EQ(floor.colour_at({1, 3}), kPlainFloor);
  EXPECT_EQ(floor.warmer_C_at({1, 0}), 0);
}

TEST(Floor, RisesFromTheLowestEdgeOfASlope) {
  const auto ground = ground_of(kFloor);
  const Floor& floor = ground->plan().floor;
  EXPECT_NEAR(floor.height_at({0.25, 0.5}), 0.75, 1e-12);  // 0.5 m at x = 0
  EXPECT_NEAR(floor.gradient_at({1, 0}).x, 1, 1e-12);
  EXPECT_NEAR(floor.gradient_at({1, 0}).y, 0, 1e-12);
  EXPECT_NEAR(floor.height_at({-3, 0.5}), 1.5 * 0.17632698, 1e-8);  // tan 10 deg, from y = -1
  EXPECT_EQ(floor.height_at({8, 8}), 0);
}

TEST(Floor, IsNoObstacle) {
  const World world = world_of(kFloor);
  EXPECT_FALSE(world.cast({-9, 0}, {1, 0}, 100));
  EXPECT_EQ(world.clearance({1, 5}, 0.5), 0.5);
  EXPECT_FALSE(world.ground().inside_solid({1, 0}));
}

TEST(Floor, CountsEachCrossingOfABumpOnce) {
  const FloorBump bump{"", {0, -1}, {0, 1}, 0.1};
  EXPECT_TRUE(crosses(bump, {-1, 0}, {1, 0}));
  EXPECT_TRUE(crosses(bump, {1, 0.5}, {-1, 0.5}));
  EXPECT_FALSE(crosses(bump, {-1, 2}, {1, 2}));  // past its end
  EXPECT_FALSE(crosses(bump, {-1, 0}, {-0.1, 0}));
  EXPECT_FALSE(crosses(bump, {0, 0}, {0, 0.5}));                                             // along it
  for (const Vector2 stop : {Vector2{0, 0.3}, Vector2{1e-12, 0.3}, Vector2{-1e-12, 0.3}}) {  // in two steps
    EXPECT_EQ(crosses(bump, {-1, 0.3}, stop) + crosses(bump, stop, {1, 0.3}), 1);
    EXPECT_EQ(crosses(bump, {1, 0.3}, stop) + crosses(bump, stop, {-1, 0.3}), 1);
    EXPECT_NE(crosses(bump, {-1, 0.3}, stop) + crosses(bump, stop, {-1, 0.3}), 1);  // and back
  }
}

TEST(Floor, IsDrawn) {
  const auto scene = nlohmann::json::parse(scene_json(world_of(kFloor)));
  EXPECT_EQ(scene["floor"].size(), 3u);
  EXPECT_EQ(scene["floor"][0]["colour"], "#ff8000");
  EXPECT_EQ(scene["floor"][2]["radius"], 1);
  EXPECT_EQ(scene["bumps"], (nlohmann::json{{{0, 5}, {1, 5}}, {{1, 5}, {1, 6}}}));
  EXPECT_EQ(scene["beacons"][0]["id"], "lamp");
  EXPECT_FALSE(nlohmann::json::parse(scene_json(world_of(""))).contains("floor"));
}

std::string problems_of(const std::string& text) {
  Problems problems;
  const auto ground = Ground::parse("format = 1\n" + text, "w.toml", problems);
  EXPECT_EQ(ground.has_value(), problems.empty());
  return problems.text();
}

TEST(Floor, TellsWhatIsWrongInTheFile) {
  EXPECT_EQ(problems_of("[[floor]]\nx_m = 0\ny_m = 0\nradius_m = 1\nslip = 1.5\ncolour = \"red\"\nslope_deg = 85\n"
                        "slop_deg = 1\n"
                        "[[bump]]\npoints = [[0, 0]]\n"
                        "[[beacon]]\nid = \"b\"\nx_m = 0\ny_m = 0\n"
                        "[[beacon]]\nid = \"c\"\nx_m = 0\ny_m = 0\nword = [1, 2.5]\n"),
            "w.toml:6:8: slip is 1.5, must be in [0, 1]\n"
            "w.toml:7:10: colour is \"red\", must be \"#rrggbb\", two hexadecimal digits each\n"
            "w.toml:8:13: slope_deg is 85, must be in [0, 80]\n"
            "w.toml:9:12: \"slop_deg\" is no key here; did you mean \"slope_deg\"?\n"
            "w.toml:11:10: points must be a list of at least 2 points [[x, y], ...]\n"
            "w.toml:13:6: b: a beacon shines (light_range_m > 0), chirps (word = [1, 2]) or both\n"
            "w.toml:20:8: c: word must be whole numbers, one for each event\n");
}

TEST(Floor, HasLimits) {
  std::string many;
  for (int n = 0; n < 101; ++n) {
    many += "[[beacon]]\nid = \"b" + std::to_string(n) + "\"\nx_m = 0\ny_m = 0\nlight_range_m = 1\n";
  }
  EXPECT_NE(problems_of(many).find("has 101 beacons; the limit is 100"), std::string::npos);
}

TEST(Beacon, ChirpsItsWordOverAndOver) {
  const auto ground =
      ground_of("[[beacon]]\nid = \"b\"\nx_m = 0\ny_m = 0\nword = [4, 9]\nevent_s = 0.5\npause_s = 2\nstart_s = 1\n");
  const Beacon& beacon = ground->plan().beacons[0];
  EXPECT_EQ(beacon.last_chirp(0.99).event, 0);
  EXPECT_EQ(beacon.last_chirp(1).event, 4);
  EXPECT_EQ(beacon.last_chirp(1.49).event, 4);
  EXPECT_EQ(beacon.last_chirp(1.5).event, 9);
  EXPECT_EQ(beacon.last_chirp(3.9).event, 9);  // silence, but that was the last
  EXPECT_NEAR(beacon.last_chirp(3.9).began_s, 1.5, 1e-12);
  EXPECT_EQ(beacon.last_chirp(4).event, 4);
  EXPECT_NEAR(beacon.last_chirp(301.6).began_s, 301.5, 1e-9);  // the 101st word began at 301 s
}

}  // namespace
}  // namespace ganglion::sim
