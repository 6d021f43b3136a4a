#include "ganglion/plot/old_run_file.h"

#include <gtest/gtest.h>

#include "ganglion/base/base64.h"
#include "ganglion/plot/json_view.h"

namespace ganglion::plot {
namespace {

// 2 columns x 2 rows, 3 bytes a cell: label, risk, inhibited.
// Row 0: {1, 0, 0} {2, 255, 7}; row 1: {0, 0, 0} {128, 51, 0}.
constexpr const char* kGrid =
    R"({"pose":{"position":{"x":-1,"y":2,"z":0}},"column_count":2,"cell_size":{"x":0.3,"y":0.3},"row_stride":6,)"
    R"("cell_stride":3,"fields":[{"name":"label","offset":0,"type":1},{"name":"risk","offset":1,"type":1},)"
    R"({"name":"inhibited","offset":2,"type":1}],"data":"AQAAAv8HAAAAgDMA"})";
constexpr std::uint8_t kNone = shown::kUnknownCell;

TEST(OldMap, BecomesAFieldOfFourLayers) {
  const auto field = old_map(*parse_object(kGrid));
  ASSERT_TRUE(field);
  EXPECT_EQ(field->origin, (Vector2{-1, 2}));
  EXPECT_EQ(field->cell, (Vector2{0.3, 0.3}));
  EXPECT_EQ(field->columns, 2);
  EXPECT_EQ(field->rows, 2);
  EXPECT_EQ(field->cells[0], (std::vector<std::uint8_t>{127, 254, kNone, 127}));  // empty, occupied, -, empty
  EXPECT_EQ(field->cells[1], (std::vector<std::uint8_t>{0, 254, kNone, 51}));
  EXPECT_EQ(field->cells[3], (std::vector<std::uint8_t>{0, 254, kNone, 0}));
  EXPECT_EQ(field->layers[0].class_of(254)->title.es, "celda ocupada");
}

TEST(OldMap, TellsDynamicFromALayerOfStaticCells) {
  auto grid = *parse_object(kGrid);
  grid["fields"][2]["name"] = "static";
  const auto field = old_map(grid);
  ASSERT_TRUE(field);
  EXPECT_EQ(field->cells[2], (std::vector<std::uint8_t>{0, 254, kNone, 0}));  // the unexplored cell is neither
}

TEST(OldMap, IsRefusedWhereItsSizeIsNotThatOfItsData) {
  const auto grid = *parse_object(kGrid);
  for (const auto& [key, value] : {std::pair{"column_count", 1e18},
                                   {"column_count", 0.0},
                                   {"row_stride", 3.0},
                                   {"row_stride", 1e300},
                                   {"cell_stride", 0.0}}) {
    auto broken = grid;
    broken[key] = value;
    EXPECT_FALSE(old_map(broken)) << key << " " << value;
  }
}

/// A grid of 4 x 1 cells of 0.5 m, all empty, with these inhibitions.
std::string inhibited_json(double x_m, const std::vector<std::uint8_t>& inhibited) {
  std::vector<std::uint8_t> bytes;
  for (const std::uint8_t one : inhibited) bytes.insert(bytes.end(), {1, one});
  return fmt::format(
      R"({{"pose":{{"position":{{"x":{},"y":0}}}},"column_count":{},"cell_size":{{"x":0.5}},"row_stride":{},"cell_stride":2,)"
      R"("fields":[{{"name":"label","offset":0,"type":1}},{{"name":"inhibited","offset":1,"type":1}}],"data":"{}"}})",
      x_m, inhibited.size(), 2 * inhibited.size(), base64(bytes));
}

/// A robot that drives 1 m along x in 1 s, and its maps at these times.
RunFile driven(const std::vector<JsonMessage>& maps) {
  RunFile file;
  ganglion::SignalTable table{"/robot0/signals", {{"truth.x_m", "m"}, {"truth.y_m", "m"}}, {}, {}, {}};
  for (std::uint32_t i = 0; i <= 10; ++i) {
    table.ticks.push_back(i);
    table.times_s.push_back(i * 0.1);
    table.values.insert(table.values.end(), {i * 0.1, 0.25});
  }
  file.tables.push_back(table);
  file.json["/robot0/map/router"].messages = maps;
  return file;
}

std::vector<shown::Shape> attempts_in(const RunFile& file) {
  std::size_t unread = 0;
  for (const ExhibitTrack& track : old_exhibits(file, unread)) {
    if (track.name == "attempts") return track.at<shown::Marks>(1e9)->shapes;
  }
  return {};
}

TEST(OldAttempts, GoFromWhereTheRobotWasNearestToTheCellThatWasInhibited) {
  const auto attempts =
      attempts_in(driven({{0, inhibited_json(0, {0, 0, 0, 0})}, {1, inhibited_json(0, {0, 3, 0, 0})}}));
  ASSERT_EQ(attempts.size(), 1u);
  EXPECT_EQ(attempts[0].role, Role::Tried);
  EXPECT_EQ(attempts[0].points[1], (Vector2{0.75, 0.25}));
  EXPECT_NEAR(attempts[0].points[0].x, 0.75, 0.06);
}

TEST(OldAttempts, AreNotRepeatedWhileAnInhibitionLastsButOnceItLapsed) {
  std::vector<JsonMessage> maps = {{0, inhibited_json(0, {0, 3, 0, 0})}, {0.5, inhibited_json(0, {0, 2, 0, 0})}};
  EXPECT_EQ(attempts_in(driven(maps)).size(), 1u);
  maps.push_back({0.6, inhibited_json(0, {0, 0, 0, 0})});
  maps.push_back({0.7, inhibited_json(0, {0, 5, 0, 0})});
  EXPECT_EQ(attempts_in(driven(maps)).size(), 2u);
}

TEST(OldAttempts, FollowACellThroughTheGrowthOfItsMap) {
  const std::string grown = inhibited_json(-0.5, {0, 0, 3, 0, 0});  // the same cell, one column further right
  EXPECT_EQ(attempts_in(driven({{0, inhibited_json(0, {0, 3, 0, 0})}, {1, grown}})).size(), 1u);
}

TEST(OldGoals, TellWhatBecameOfEach) {
  RunFile file = driven({});
  file.json.erase("/robot0/map/router");
  const auto goal = [](double time_s, int index, const char* state) {
    return JsonMessage{time_s, fmt::format(R"({{"index":{},"x_m":{},"y_m":2,"state":"{}"}})", index, index + 1, state)};
  };
  file.json["/robot0/goals"].messages = {goal(0, 0, "set"),       goal(1, 0, "reached"), goal(1, 1, "set"),
                                         goal(2, 1, "withdrawn"), goal(2, 2, "set"),     goal(3, 2, "replaced"),
                                         goal(3, 9, "set")};  // which is none
  std::size_t unread = 0;
  const auto tracks = old_exhibits(file, unread);
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(unread, 1u);
  const auto& shapes = tracks[0].at<shown::Marks>(9)->shapes;
  ASSERT_EQ(shapes.size(), 3u);
  EXPECT_EQ(shapes[0].role, Role::Reached);
  EXPECT_EQ(shapes[1].role, Role::GivenUp);
  EXPECT_EQ(shapes[2].role, Role::Past);
  EXPECT_EQ(shapes[2].points[0], (Vector2{3, 2}));
  EXPECT_EQ(shapes[2].label.en, "3");
  EXPECT_EQ(tracks[0].at<shown::Marks>(0.5)->shapes[0].role, Role::Goal);
}

TEST(OldRoutes, ArePlans) {
  RunFile file = driven({});
  file.json.erase("/robot0/map/router");
  file.json["/robot0/route/router"].messages = {{0.1, R"({"points":[[1,2],[3,4]]})"}, {0.2, R"({"points":[]})"}};
  std::size_t unread = 0;
  const auto tracks = old_exhibits(file, unread);
  ASSERT_EQ(tracks.size(), 1u);
  EXPECT_EQ(tracks[0].owner.name, "router");
  EXPECT_EQ(tracks[0].at<shown::Marks>(0.15)->shapes.at(0).points, (std::vector<Vector2>{{1, 2}, {3, 4}}));
  EXPECT_TRUE(tracks[0].at<shown::Marks>(1)->shapes.empty());
}

}  // namespace
}  // namespace ganglion::plot
