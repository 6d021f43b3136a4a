#include "ganglion/sim/world/map/occupancy_map.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/file.h"
#include "ganglion/sim/world/map/flat_yaml.h"
#include "ganglion/sim/world/map/grey_image.h"
#include "ganglion/sim/world/way/free_space.h"
#include "ganglion/sim/world/world_for_test.h"

namespace ganglion::sim {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone afterwards.
class MapFiles : public testing::Test {
 protected:
  MapFiles() : folder_(fs::temp_directory_path() / fmt::format("ganglion_map_{}_{}", ::getpid(), name())) {}
  ~MapFiles() override { fs::remove_all(folder_); }
  static std::string name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }
  fs::path write(const std::string& file, const std::string& content) const {
    EXPECT_TRUE(write_file(folder_ / file, content));
    return folder_ / file;
  }
  /// Writes the picture and a YAML file for it, with more lines as asked.
  Result<OccupancyMap> load(const std::string& pgm, const std::string& more = kPlain) const {
    write("m.pgm", pgm);
    Problems problems;
    return OccupancyMap::load(write("m.yaml", "image: m.pgm\n" + more), problems);
  }
  static constexpr const char* kPlain =
      "resolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  fs::path folder_;
};

using Counts = std::array<std::size_t, 3>;

TEST_F(MapFiles, HaveTheirTopRowFirstAndTheirOriginAtTheLowerLeft) {
  const auto map = load("P2\n# made by hand\n3 2 # columns, rows\n255\n0 205 254\n254 254 254\n");
  ASSERT_TRUE(map) << map.error().text();
  EXPECT_EQ(map->at(0, 1), Occupancy::Occupied);
  EXPECT_EQ(map->at(1, 1), Occupancy::Unknown);  // 50 / 255 = 0.19608 is not below 0.196
  EXPECT_EQ(map->at(2, 1), Occupancy::Free);
  EXPECT_EQ(map->at(0, 0), Occupancy::Free);
  EXPECT_EQ(map->at(Vector2{1.2, 2.7}), Occupancy::Occupied);
  EXPECT_EQ(map->at(Vector2{1.2, 2.3}), Occupancy::Free);
  EXPECT_EQ(map->at(Vector2{0.9, 2.3}), Occupancy::Unknown);  // beyond the picture
  EXPECT_EQ(map->bounds(), (Box2{{1, 2}, {2.5, 3}}));
  EXPECT_EQ(map->counts(), (Counts{4, 1, 1}));
}

TEST_F(MapFiles, TakeThresholdsStrictlyAndNegate) {
  // Shades with maximum 100: value 35 gives 0.65, 36 gives 0.64, 80 gives 0.2, 81 gives 0.19.
  const std::string pgm = "P2 4 1 100 35 34 80 81\n";
  const std::string limits = "resolution: 1\norigin: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.2\n";
  const auto map = load(pgm, limits + "negate: 0\n");
  ASSERT_TRUE(map) << map.error().text();
  EXPECT_EQ(map->at(0, 0), Occupancy::Unknown);
  EXPECT_EQ(map->at(1, 0), Occupancy::Occupied);
  EXPECT_EQ(map->at(2, 0), Occupancy::Unknown);
  EXPECT_EQ(map->at(3, 0), Occupancy::Free);
  const auto negative = load(pgm, limits + "negate: 1\n");
  ASSERT_TRUE(negative);
  EXPECT_EQ(negative->at(3, 0), Occupancy::Occupied);  // 0.81
  EXPECT_EQ(negative->at(0, 0), Occupancy::Unknown);   // 0.35
}

TEST_F(MapFiles, MayBeBinaryOfOneOrTwoBytes) {
  const auto one = load(std::string("P5 2 1 255\n\x00\xFE", 13));
  ASSERT_TRUE(one) << one.error().text();
  EXPECT_EQ(one->counts(), (Counts{1, 1, 0}));
  const auto two = load(std::string("P5\n2 1\n65535\n\xFF\xFF\x00\xFF", 17));  // high byte first: white, nearly black
  ASSERT_TRUE(two) << two.error().text();
  EXPECT_EQ(two->at(0, 0), Occupancy::Free);
  EXPECT_EQ(two->at(1, 0), Occupancy::Occupied);
}

TEST_F(MapFiles, TurnAboutTheirOrigin) {
  const auto map = load("P2 2 1 255 254 0\n",
                        "resolution: 1\norigin: [5, 5, 1.5707963267948966]\nnegate: 0\noccupied_thresh: 0.65\n"
                        "free_thresh: 0.196\n");
  ASSERT_TRUE(map) << map.error().text();
  // The map's x axis points to the world's +y, its y axis to -x.
  EXPECT_EQ(map->at(Vector2{4.5, 5.5}), Occupancy::Free);
  EXPECT_EQ(map->at(Vector2{4.5, 6.5}), Occupancy::Occupied);
  EXPECT_EQ(map->at(Vector2{5.5, 5.5}), Occupancy::Unknown);
}

TEST_F(MapFiles, SayWhereTheyAreWrong) {
  const std::string pgm = "P2 1 1 255 0\n";
  auto text = [&](const std::string& yaml) {
    const auto map = load(pgm, yaml);
    return map ? std::string("fine") : map.error().text();
  };
  EXPECT_NE(text("resolution: 0\norigin: [0,0,0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n")
                .find("m.yaml:2:13: resolution is 0"),
            std::string::npos);
  EXPECT_NE(text("resolution: 1\norigin: [0,0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n")
                .find("m.yaml:3:9: origin must be a list of 3 numbers"),
            std::string::npos);
  EXPECT_NE(text("resolution: 1\norigin: [0,0,0]\nnegate: 0\noccupied_thresh: 0.6\n").find("free_thresh is missing"),
            std::string::npos);
  EXPECT_NE(text(std::string(kPlain) + "mode: scale\n").find("m.yaml:7:7: mode is scale"), std::string::npos);
  EXPECT_NE(text(std::string(kPlain) + "  nested: 1\n").find("m.yaml:7:3:"), std::string::npos);
  EXPECT_NE(text(std::string(kPlain) + "negate: 0\n").find("m.yaml:7:1: negate is given twice"), std::string::npos);
  EXPECT_NE(text("resolution: 1\norigin: [9999.5,0,0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n")
                .find("beyond 10000 m"),
            std::string::npos);
  EXPECT_NE(text("image: other.pgm\n").find("given twice"), std::string::npos);
  Problems problems;
  EXPECT_EQ(OccupancyMap::load(folder_ / "none.yaml", problems).error().code, ErrorCode::NotFound);
  EXPECT_EQ(load("P2 1 1 255\n").error().code, ErrorCode::Corrupt);
  EXPECT_EQ(load("P2 1 1 255 256\n").error().code, ErrorCode::Corrupt);
  EXPECT_EQ(load("P5 3 3 255\n12345678").error().code, ErrorCode::Corrupt);
  EXPECT_EQ(load("P6 1 1 255 0 0 0\n").error().code, ErrorCode::Unsupported);
  EXPECT_EQ(load("P5 0 1 255\n").error().code, ErrorCode::Syntax);
  EXPECT_EQ(load("P5 9000 9000 255\n").error().code, ErrorCode::TooLarge);
  EXPECT_EQ(load("P5 99999999999999999999 1 255\n").error().code, ErrorCode::Syntax);
}

TEST_F(MapFiles, TellAllThatIsWrongAtOnce) {
  write("m.pgm", "P2 1 1 255 0\n");
  Problems problems;
  const auto path = write("m.yaml", "image: m.pgm\nresolution: x\norigin: [0, 0, 0]\nnegate: 2\nfree_thresh: 0.2\n");
  EXPECT_FALSE(OccupancyMap::load(path, problems));
  EXPECT_EQ(problems.text(), fmt::format("{0}: occupied_thresh is missing\n"
                                         "{0}:2:13: resolution is x, must be a number from 0.0001 to 1000\n"
                                         "{0}:4:9: negate is 2, must be 0 or 1\n",
                                         path.string()));
}

TEST_F(MapFiles, AreRoughUnlessTheirWorldSaysOtherwise) {
  ASSERT_TRUE(load("P2\n3 1\n255\n254 254 0\n"));  // free from x = 1 to 2, a wall behind
  const auto material = [&](const std::vector<config::Override>& overrides) {
    Problems problems;
    const auto ground = Ground::load(folder_ / "m.yaml", problems, overrides);
    EXPECT_TRUE(ground) << problems.text();
    return ground->cast({1.5, 2.25}, {1, 0}, 3)->material;
  };
  EXPECT_EQ(material({}), Material::Rough);
  EXPECT_EQ(material({{"material", "smooth"}}), Material::Smooth);
}

TEST_F(MapFiles, NameThePictureThatIsNotThere) {
  Problems problems;
  const auto path = write("m.yaml", std::string("image: other.pgm\n") + kPlain);
  const auto map = OccupancyMap::load(path, problems);
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().place, (Place{path.string(), 1, 8}));
}

TEST(FlatYaml, ReadsQuotesCommentsAndListsOfEitherForm) {
  const auto entries =
      parse_flat_yaml("# head\n---\na: \"x # y\" # z\nb:\n  - 1\n  - '2'\nc: [ 1, -2.5 ,3 ]\r\n", "f.yaml");
  ASSERT_TRUE(entries) << entries.error().text();
  ASSERT_EQ(entries->size(), 3u);
  EXPECT_EQ((*entries)[0].items, (std::vector<std::string>{"x # y"}));
  EXPECT_EQ((*entries)[1].items, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ((*entries)[2].items, (std::vector<std::string>{"1", "-2.5", "3"}));
  EXPECT_EQ((*entries)[2].place, (Place{"f.yaml", 7, 4}));
}

OccupancyMap map_of(int columns, int rows, const std::string& cells_top_row_first) {
  std::vector<Occupancy> cells;
  for (int row = rows - 1; row >= 0; --row) {
    for (int column = 0; column < columns; ++column) {
      const char c = cells_top_row_first[static_cast<std::size_t>(row) * columns + column];
      cells.push_back(c == '.' ? Occupancy::Free : (c == '#' ? Occupancy::Occupied : Occupancy::Unknown));
    }
  }
  return OccupancyMap(columns, rows, 1, Pose2{}, std::move(cells));
}

TEST(OccupancyMap, BordersItsFreeCellsWithMergedRunsSolidOnTheLeft) {
  const auto borders = map_of(3, 2, "..#...").borders(100);
  using Line = std::pair<Vector2, Vector2>;
  std::vector<Line> expected = {
      {{3, 0}, {0, 0}}, {{2, 1}, {3, 1}}, {{0, 2}, {2, 2}},  // lower edge, under the block, upper edge
      {{0, 0}, {0, 2}}, {{2, 2}, {2, 1}}, {{3, 1}, {3, 0}},  // left edge, left of the block, right edge
  };
  ASSERT_EQ(borders.size(), expected.size());
  for (const Line& line : expected) {
    // Walking from first to second with the solid on the left: turned round where written the other way.
    const bool found = std::count(borders.begin(), borders.end(), line) == 1;
    const bool reversed = std::count(borders.begin(), borders.end(), Line{line.second, line.first}) == 1;
    EXPECT_TRUE(found || reversed) << line.first.x << "," << line.first.y;
  }
  for (const auto& [from, to] : borders) {
    const Vector2 along = (to - from) * (1 / (to - from).length());
    const Vector2 left = (from + to) * 0.5 + along.left() * 0.5;
    const OccupancyMap map = map_of(3, 2, "..#...");
    EXPECT_NE(map.at(left), Occupancy::Free);
    EXPECT_EQ(map.at(left - along.left()), Occupancy::Free);
  }
}

TEST(OccupancyMap, IsSolidWhereUnknownAndBeyondThePicture) {
  GroundPlan plan;
  plan.map = map_of(4, 1, "..?.");
  Problems problems;
  const World world(std::make_shared<const Ground>(*Ground::make(std::move(plan), problems)));
  EXPECT_NEAR(world.cast({0.5, 0.5}, {1, 0}, 10)->range_m, 1.5, 1e-12);
  EXPECT_NEAR(world.cast({0.5, 0.5}, {-1, 0}, 10)->range_m, 0.5, 1e-12);
  EXPECT_EQ(world.cast({2.5, 0.5}, {1, 0}, 10)->range_m, 0);
  EXPECT_LT(world.clearance({2.5, 0.5}, 1), 0);
  EXPECT_LT(world.clearance({0.5, 1.5}, 1), 0);
  EXPECT_NEAR(world.slide({0.5, 0.5}, {5, 0}, 0.25).position.x, 1.75, 2e-9);
}

/// Walks cell by cell along a ray through the raster, in steps far smaller than a cell: slow, and blind to our borders.
double stepped_range(const OccupancyMap& map, Vector2 from, Vector2 d, double limit_m, double step_m) {
  for (double range = 0; range < limit_m; range += step_m) {
    if (map.at(from + d * range) != Occupancy::Free) return range;
  }
  return limit_m;
}

struct Listed {
  const char* name;
  Counts counts;  // free, occupied, unknown
  int share_percent;
};
constexpr Listed kListed[] = {
    {"aces_from_log", {79763, 9385, 238426}, 98},    {"brsu_c069", {43757, 4055, 265532}, 98},
    {"fr079_from_log", {38507, 8063, 29088}, 96},    {"hospital_section", {334302, 74481, 72315}, 100},
    {"intel_from_log", {50405, 7994, 38633}, 99},    {"nav2_depot", {179481, 5947, 0}, 97},
    {"willow_full_010", {134715, 6961, 165508}, 99},
};

class RealMap : public testing::TestWithParam<Listed> {
 protected:
  std::shared_ptr<const Ground> load() {
    Problems problems;
    auto ground = Ground::load(data_folder() / "maps" / (std::string(GetParam().name) + ".yaml"), problems);
    EXPECT_TRUE(ground) << problems.text();
    return ground ? std::make_shared<const Ground>(std::move(*ground)) : nullptr;
  }
  static bool absent() { return data_folder().empty(); }
};
#define SKIP_WITHOUT_DATA() \
  if (absent()) GTEST_SKIP() << "NOT CHECKED: no public data in ../shared/data or $GANGLION_DATA"

TEST_P(RealMap, HasTheListedCellsAndLargestPart) {
  SKIP_WITHOUT_DATA();
  const auto ground = load();
  ASSERT_TRUE(ground);
  const OccupancyMap& map = *ground->plan().map;
  EXPECT_EQ(map.counts(), GetParam().counts);
  FreeSpace space(ground, map.resolution_m());  // its raster is then the map's
  const double free_m2 = static_cast<double>(map.counts()[0]) * map.resolution_m() * map.resolution_m();
  EXPECT_EQ(std::lround(100 * space.largest_part_area_m2() / free_m2), GetParam().share_percent);
}

TEST_P(RealMap, AnswersRaysAsItsCellsDo) {
  SKIP_WITHOUT_DATA();
  const auto ground = load();
  ASSERT_TRUE(ground);
  FreeSpace space(ground);
  Draws draws({4, 0, 0, 4}, 0);
  for (int i = 0; i < 300; ++i) {
    const Vector2 from = space.sample(0.1, draws), d = direction(draws.uniform(-3.2, 3.2));
    const auto hit = ground->cast(from, d, 10);
    const double range_m = hit ? hit->range_m : 10;
    // The walker may step over a corner's tip, so it can only see farther, and never nearer.
    EXPECT_GE(stepped_range(*ground->plan().map, from, d, 10, 1e-3), range_m - 1e-9);
    if (hit) {
      EXPECT_NE(ground->plan().map->at(from + d * range_m - hit->normal * 1e-6), Occupancy::Free);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Listed, RealMap, testing::ValuesIn(kListed),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace ganglion::sim
