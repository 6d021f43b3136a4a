#include "ganglion/sim/world/plan/plan.h"

#include "ganglion/base/file.h"
#include "ganglion/sim/world/map/flat_yaml.h"
#include "ganglion/sim/world/map/grey_image.h"
#include "ganglion/sim/world/world_for_test.h"

namespace ganglion::sim {
namespace {

const char* const kWhole = R"(name = "Office"
area = [-1, -1, 9, 7]
[[wall]]
points = [[0, 0], [8, 0], [8, 6], [0, 6]]
closed = true
material = "smooth"
label = "outer walls"
[[box]]
id = "desk"
x_m = 2
y_m = 1
length_m = 1.6
width_m = 0.8
yaw_deg = 30
material = "soft"
[[disc]]
x_m = 5
y_m = 3
radius_m = 0.2
structural = true
[[polygon]]
points = [[6, 4], [7, 4], [7, 5]]
[[mover]]
id = "cart"
length_m = 0.5
width_m = 0.4
yaw_deg = 90
places = [[1, 4], [3, 4]]
change_after_s = [5, 10]
[[mover]]
id = "person"
radius_m = 0.25
path = [[4, 1], [7, 1]]
speed_mps = 1
loop = true
[[spawn]]
id = "start"
x_m = 1
y_m = 2
yaw_deg = 180
)";

TEST(WorldFile, IsReadItemByItem) {
  const auto ground = ground_of(kWhole);
  ASSERT_TRUE(ground);
  const GroundPlan& plan = ground->plan();
  EXPECT_EQ(ground->name(), "Office");
  EXPECT_EQ(ground->bounds(), (Box2{{-1, -1}, {9, 7}}));
  ASSERT_EQ(plan.shapes.size(), 4u);
  EXPECT_EQ(plan.shapes[0].material, Material::Smooth);
  EXPECT_TRUE(plan.shapes[0].structural);
  EXPECT_EQ(plan.shapes[1].id, "desk");
  EXPECT_FALSE(plan.shapes[1].structural);
  EXPECT_EQ(plan.shapes[1].material, Material::Soft);
  EXPECT_TRUE(plan.shapes[2].structural);
  ASSERT_EQ(plan.movers.size(), 2u);
  EXPECT_EQ(plan.movers[0].places[1].position, (Vector2{3, 4}));
  EXPECT_NEAR(plan.movers[0].places[1].yaw.deg(), 90, 1e-12);
  EXPECT_TRUE(plan.movers[1].loop);
  EXPECT_NEAR(ground->spawn("start")->pose.yaw.deg(), 180, 1e-12);
  EXPECT_EQ(ground->spawn("nowhere"), nullptr);
}

TEST(WorldFile, GivesItsMaterialToAllThatStandsAndNamesNone) {
  const auto ground = ground_of("material = \"smooth\"\n" + std::string(kWhole));
  ASSERT_TRUE(ground);
  const GroundPlan& plan = ground->plan();
  EXPECT_EQ(plan.shapes[1].material, Material::Soft);    // says so itself
  EXPECT_EQ(plan.shapes[2].material, Material::Smooth);  // the disc
  EXPECT_EQ(plan.shapes[3].material, Material::Smooth);  // the polygon
  EXPECT_EQ(plan.movers[0].material, Material::Rough);   // people and crates are not built
  EXPECT_EQ(ground->cast({5, 2}, {0, 1}, 3)->material, Material::Smooth);
}

std::string problems_of(const std::string& text) {
  Problems problems;
  const auto ground = Ground::parse("format = 1\n" + text, "w.toml", problems);
  EXPECT_EQ(ground.has_value(), problems.empty());
  return problems.text();
}

TEST(WorldFile, TellsEveryProblemWithItsPlace) {
  EXPECT_EQ(problems_of("[[wall]]\n"
                        "points = [[0, 0], [1, 2, 3]]\n"
                        "materal = \"soft\"\n"
                        "[[box]]\n"
                        "id = \"desk\"\n"
                        "x_m = 2\n"
                        "y_m = 20000\n"
                        "length_m = 0\n"
                        "width_m = 1\n"
                        "[[disc]]\n"
                        "id = \"desk\"\n"
                        "x_m = 1\n"
                        "y_m = 1\n"
                        "radius_m = \"big\"\n"
                        "material = \"sof\"\n"
                        "[[wal]]\n"),
            "w.toml:3:19: each of points must be a point [x, y] of two numbers\n"
            "w.toml:4:11: \"materal\" is no key here; did you mean \"material\"?\n"
            "w.toml:8:7: desk: y_m is 20000, must be in [-10000, 10000]\n"
            "w.toml:9:12: desk: length_m is 0, must be in [0.0001, 20000]\n"
            "w.toml:12:6: the id \"desk\" is taken: each item needs its own\n"
            "w.toml:15:12: desk: radius_m is a text, must be a number\n"
            "w.toml:16:12: desk: material is \"sof\"; did you mean \"soft\"?\n"
            "w.toml:17:1: \"wal\" is no key here; did you mean \"wall\"?\n");
}

TEST(WorldFile, RefusesShapesThatAreNone) {
  auto expect = [](const std::string& text, const std::string& part) {
    EXPECT_NE(problems_of(text).find(part), std::string::npos) << text << "\n" << problems_of(text);
  };
  expect("[[wall]]\npoints = [[0, 0]]\n", "w.toml:3:10: points must be a list of at least 2 points");
  expect("[[wall]]\n", "points is missing");
  expect("[[wall]]\npoints = [[0, 0], [1, 0], [1, 0]]\n", "w.toml:3:27: points 1 and 2 of points are the same");
  expect("[[wall]]\npoints = [[0, 0], [1, 0], [0, 0]]\nclosed = true\n", "the last joins the first by itself");
  expect("[[polygon]]\npoints = [[0, 0], [1, 1], [2, 2]]\n", "has no area");
  expect("[[polygon]]\npoints = [[0, 0], [1, 1], [1, 0], [0, 1]]\n", "crosses or touches itself: edges 0-1 and 2-3");
  expect("[[wall]]\npoints = [[0, nan], [1, 1]]\n", "beyond 10000 m");
  expect("area = [0, 0, 0, 1]\n", "must not be empty");
  expect("[[spawn]]\nx_m = 0\ny_m = 0\n", "id is missing");
  expect("[[box]]\nx_m=0\ny_m=0\nlength_m=1\nwidth_m=1\n[[spawn]]\nid = \"s\"\nx_m = 0.3\ny_m = 0\n",
         "w.toml:7:1: spawn \"s\" at (0.3, 0) lies inside a solid");
}

TEST(WorldFile, RefusesMoversThatCannotMove) {
  auto expect = [](const std::string& keys, const std::string& part) {
    const std::string text = "[[mover]]\nid = \"m\"\n" + keys;
    EXPECT_NE(problems_of(text).find(part), std::string::npos) << text << "\n" << problems_of(text);
  };
  expect("radius_m = 1\n", "either places = ");
  expect("radius_m = 1\nplaces = [[0, 0]]\npath = [[0, 0], [1, 1]]\nspeed_mps = 1\n", "either places = ");
  expect("radius_m = 1\nlength_m = 1\nplaces = [[0, 0]]\n", "a mover is a disc or a box");
  expect("radius_m = 1\nplaces = [[0, 0], [1, 1]]\n", "change_after_s = [min, max] is missing");
  expect("radius_m = 1\nplaces = [[0, 0], [1, 1]]\nchange_after_s = [3, 1]\n", "smaller number last");
  expect("radius_m = 1\nplaces = [[0, 0], [1, 1]]\nchange_after_s = [0, 1]\n", "> 0");
  expect("radius_m = 1\npath = [[0, 0], [0, 0]]\nspeed_mps = 1\n", "are the same");
  expect("radius_m = 1\npath = [[0, 0], [1, 0]]\n", "speed_mps is missing");
  EXPECT_EQ(problems_of("[[mover]]\nid = \"m\"\nradius_m = 1\nplaces = [[0, 0]]\n"), "");
}

TEST(WorldFile, IsChangedByOverridesAndNamesThem) {
  const auto path = std::filesystem::temp_directory_path() / fmt::format("ganglion_plan_{}.toml", ::getpid());
  ASSERT_TRUE(write_file(path, std::string("format = 1\n") + kWhole));
  Problems problems;
  const config::Override good[] = {{"box.desk.x_m", "4"}};
  const auto ground = Ground::load(path, problems, good);
  ASSERT_TRUE(ground) << problems.text();
  EXPECT_NEAR(ground->clearance({4, 1}, 1), -0.4, 1e-12);  // the desk's middle, 0.4 m within its long side
  const config::Override bad[] = {{"box.desk.x_m", "x"}, {"box.dsk.x_m", "1"}};
  EXPECT_FALSE(Ground::load(path, problems, bad));
  EXPECT_NE(problems.text().find("--set box.desk.x_m=x: desk: x_m is a text"), std::string::npos) << problems.text();
  EXPECT_NE(problems.text().find("did you mean \"desk\"?"), std::string::npos) << problems.text();
  std::filesystem::remove(path);
}

TEST(WorldFile, NamesAMapThatIsNotThere) {
  const auto path = std::filesystem::path(::testing::TempDir()) / "mapless_world.toml";
  std::ofstream(path) << "format = 1\nmap = \"none.yaml\"\n";
  Problems problems;
  EXPECT_FALSE(Ground::load(path, problems));
  EXPECT_NE(problems.text().find("mapless_world.toml:2:7: "), std::string::npos) << problems.text();
  EXPECT_NE(problems.text().find("none.yaml"), std::string::npos) << problems.text();
  std::filesystem::remove(path);
}

TEST(Ground, HoldsItsLimits) {
  GroundPlan plan;
  plan.shapes.push_back({.points = std::vector<Vector2>(kMaxSegments + 2)});
  for (double x = 0; Vector2 & point : plan.shapes[0].points) point = {x += 0.01, 0};
  Problems problems;
  EXPECT_EQ(Ground::make(std::move(plan), problems).error().code, ErrorCode::TooLarge);
  EXPECT_NE(problems.text().find("200001 straight pieces of surface; the limit is 200000"), std::string::npos);
  EXPECT_EQ(problems.text(Language::Spanish), "tiene 200001 tramos rectos de superficie; el límite es 200000\n");
}

TEST(Ground, HoldsItsLimitsForSpeckledMaps) {
  GroundPlan plan;
  std::vector<Occupancy> cells(1000 * 1000);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i] = (i / 1000 + i) % 2 == 0 ? Occupancy::Free : Occupancy::Occupied;
  }
  plan.map = OccupancyMap(1000, 1000, 0.1, {}, std::move(cells));
  Problems problems;
  EXPECT_EQ(Ground::make(std::move(plan), problems).error().code, ErrorCode::TooLarge);
}

TEST(Ground, StaysSmallWhenEveryWallCrossesAllOfIt) {
  GroundPlan plan;
  Shape fan;
  for (int i = 0; i < 50'000; ++i) fan.points.push_back({i % 2 * 20'000.0 - 10'000, (i * 7919 % 20'000) - 10'000.0});
  plan.shapes.push_back(std::move(fan));
  Problems problems;
  const auto ground = Ground::make(std::move(plan), problems);
  ASSERT_TRUE(ground) << problems.text();
  EXPECT_TRUE(ground->cast({0.5, 0.5}, {0, 1}, 1e5));
}

TEST(Ground, WithoutAnythingIsAnOpenFieldAboutItsStart) {
  EXPECT_EQ(ground_of("")->bounds(), (Box2{{-10, -10}, {10, 10}}));
  EXPECT_EQ(ground_of("[[spawn]]\nid = \"a\"\nx_m = 50\ny_m = 0\n")->bounds(), (Box2{{40, -10}, {60, 10}}));
  EXPECT_FALSE(ground_of("")->cast({0, 0}, {1, 0}, 1e9));
  EXPECT_EQ(ground_of("")->clearance({0, 0}, 3), 3);
  EXPECT_EQ(world_of("").slide({0, 0}, {1, 2}, 0.1).position, (Vector2{1, 2}));
}

/// A file with some bytes changed, dropped, doubled or swapped for what tends to break readers.
std::string mutated(std::string text, Draws& draws) {
  constexpr std::array<std::string_view, 10> kNasty = {
      "nan", "inf", "-1e308", "1e-320", "[[", "]", "\"", "\xFF", "99999999999999999999", "\n"};
  const std::uint32_t changes = 1 + draws.below(4);
  for (std::uint32_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = draws.below(static_cast<std::uint32_t>(text.size()));
    const std::size_t span = std::min<std::size_t>(1 + draws.below(6), text.size() - at);
    switch (draws.below(4)) {
      case 0:
        text[at] = static_cast<char>(draws.below(256));
        break;
      case 1:
        text.erase(at, span);
        break;
      case 2:
        text.insert(at, text.substr(at, span * 4));
        break;
      default:
        text.replace(at, span, kNasty[draws.below(kNasty.size())]);
    }
  }
  return text;
}

TEST(WorldFile, NeverCrashesWhenItIsDamaged) {
  Draws draws({1, 2, 3, 4}, 5);
  const std::string whole = std::string("format = 1\n") + kWhole;
  int broken = 0;
  for (int i = 0; i < 300; ++i) {
    Problems problems;
    const auto ground = Ground::parse(mutated(whole, draws), "w.toml", problems);
    ASSERT_EQ(ground.has_value(), problems.empty());
    broken += ground ? 0 : 1;
    if (!ground) continue;
    World world(std::make_shared<const Ground>(*ground));
    for (std::uint32_t tick = 0; tick < 20; ++tick) world.advance(tick, tick, 1, {});
    world.cast({1, 1}, {1, 0}, 100);
    world.slide({1, 1}, {1, 0}, 0.2);
  }
  EXPECT_GT(broken, 150);
  EXPECT_LT(broken, 300);
}

TEST(MapFile, NeverCrashesWhenItIsDamaged) {
  Draws draws({5, 4, 3, 2}, 1);
  const std::string yaml =
      "image: m.pgm\nresolution: 0.05 # m\norigin: [-1, '2', 0.3]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: "
      "0.2\n";
  std::string pgm = "P5\n# a map\n20 10\n255\n";
  for (int i = 0; i < 200; ++i) pgm += static_cast<char>(i % 3 == 0 ? 0 : 254);
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("ganglion_damaged_{}", ::getpid());
  for (const char* kind : {"yaml", "pgm"}) {  // the other file of each pair stays whole
    ASSERT_TRUE(write_file(folder / kind / "m.yaml", yaml));
    ASSERT_TRUE(write_file(folder / kind / "m.pgm", pgm));
  }
  int broken = 0;
  for (int i = 0; i < 300; ++i) {
    const char* kind = i % 2 == 0 ? "yaml" : "pgm";
    ASSERT_TRUE(write_file(folder / kind / (std::string("m.") + kind), mutated(i % 2 == 0 ? yaml : pgm, draws)));
    Problems problems;
    broken += Ground::load(folder / kind / "m.yaml", problems) ? 0 : 1;
  }
  EXPECT_GT(broken, 100);
  EXPECT_LT(broken, 300);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace ganglion::sim
