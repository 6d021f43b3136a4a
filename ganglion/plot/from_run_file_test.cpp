#include "ganglion/plot/from_run_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "ganglion/plot/draw_all.h"
#include "ganglion/plot/json_view.h"
#include "ganglion/random/draws.h"
#include "ganglion/record/exhibit/exhibit_codec.h"
#include "ganglion/record/run_recorder.h"

namespace ganglion::plot {
namespace {

// 2 columns x 2 rows, 3 bytes a cell: label, risk, inhibited.
// Row 0: {1, 0, 0} {2, 255, 7}; row 1: {0, 0, 0} {128, 51, 0}.
constexpr const char* kGrid =
    R"({"pose":{"position":{"x":-1,"y":2,"z":0}},"column_count":2,"cell_size":{"x":0.3,"y":0.3},"row_stride":6,)"
    R"("cell_stride":3,"fields":[{"name":"label","offset":0,"type":1},{"name":"risk","offset":1,"type":1},)"
    R"({"name":"inhibited","offset":2,"type":1}],"data":"AQAAAv8HAAAAgDMA"})";

constexpr const char* kScene =
    R"({"name":"room","bounds":[0,0,6,5],"shapes":[{"class":"wall","kind":"wall","points":[[0,0],[6,0],[6,5]],"closed":true},)"
    R"({"class":"furniture","kind":"disc","x":2,"y":2,"radius":0.5},{"class":"wall","kind":"box","points":[[1,1],[2,1],[2,2]],"closed":true}],)"
    R"("map":{"origin":[1,2,0],"resolution":0.05,"columns":100,"rows":80,"occupied":[[0,0,100,1]],"unknown":[]},)"
    R"("movers":[{"id":"cart","points":[[0,0],[1,0],[1,1]],"pose":[1,1,0]}],"spawns":[{"id":"a","pose":[1,2,3]}],)"
    R"("floor":[{"points":[[0,0],[1,0],[0,1]],"slip":0.2},{"x":4,"y":4,"radius":0.25}],"bumps":[[[0,3],[1,3]]],)"
    R"("beacons":[{"id":"lamp","x":5,"y":4}]})";

constexpr const char* kRun =
    R"({"robots":[{"name":"nimrod","length_m":0.24,"width_m":0.2,"radius_m":0,"sensors":[{"id":"sonar_left","kind":"sonar",)"
    R"("x_m":0.1,"y_m":0.08,"yaw_rad":0.1,"cone_rad":0.5,"max_range_m":3,"signal":"sonar_left"},{"id":"compass","max_range_m":0}]}],)"
    R"("coordinators":[{"id":"arbiter","candidates":["escape.command","avoid"]}]})";

RunFile sample_file() {
  RunFile file;
  file.info = {.name = "nimrod", .seed = 3, .tick_s = 0.1};
  file.outcome =
      ganglion::RunOutcome{"abc", Verdict::Succeeded, {"arrived", "llegó"}, "path_m <= 2", {{"path_m", 1.5}}};
  file.tables.push_back({"/robot0/signals",
                         {{"truth.x_m", "m"},
                          {"truth.y_m", "m"},
                          {"truth.yaw_rad", "rad"},
                          {"truth.touching", ""},
                          {"arbiter.active", ""},
                          {"arbiter.wanted.avoid", ""},
                          {"escape.active", ""}},
                         {0, 1},
                         {0.0, 0.1},
                         {1, 2, 0.5, 0, -1, 0, 0, 1.1, 2, 0.5, 1, 0, 1, 1}});
  file.json["/run"].messages = {{0, kRun}};
  file.json["/scene"].messages = {{0, kScene}};
  file.json["/movers"].messages = {{0, R"({"movers":[{"id":"cart","x_m":1,"y_m":1,"yaw_rad":0}]})"},
                                   {0.05, R"({"movers":[{"id":"cart","x_m":2,"y_m":1,"yaw_rad":0}]})"}};
  file.json["/robot0/map/router"].messages = {{0.1, kGrid}};
  file.json["/robot0/route/router"].messages = {{0.1, R"({"points":[[1,2],[3,4]]})"}};
  file.json["/robot0/goals"].messages = {
      {0, R"({"index":0,"x_m":1,"y_m":2,"state":"set","reason":""})"},
      {0.1, R"({"index":0,"x_m":1,"y_m":2,"state":"withdrawn","reason":"walled_in"})"}};
  file.json["/log"].messages = {{0.1, R"({"level":3,"name":"router","message":"withdrawn"})"}};
  return file;
}

TEST(ViewOfARunFile, HoldsOutcomeTrackAndBody) {
  const RunView run = from_run_file(sample_file());
  EXPECT_EQ(run.name, "nimrod");
  EXPECT_DOUBLE_EQ(run.duration_s, 0.2);
  ASSERT_TRUE(run.outcome);
  EXPECT_EQ(run.outcome->reason.en, "arrived");
  EXPECT_EQ(run.outcome->reason.es, "llegó");
  EXPECT_EQ(run.outcome->criterion.en, "path_m <= 2");
  ASSERT_EQ(run.robots.size(), 1u);
  EXPECT_EQ(run.robots[0].track.x_m, (std::vector<double>{1, 1.1}));
  EXPECT_EQ(run.robots[0].track.touching, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(run.robots[0].length_m, 0.24);
  ASSERT_EQ(run.robots[0].sensors.size(), 1u);  // the compass looks nowhere
  EXPECT_EQ(run.robots[0].sensors[0].mount.position, (Vector2{0.1, 0.08}));
}

TEST(ViewOfARunFile, TellsWhoDroveAndWhoWantedTo) {
  const RunView run = from_run_file(sample_file());
  ASSERT_EQ(run.robots[0].coordinations.size(), 1u);
  const Coordination& arbiter = run.robots[0].coordinations[0];
  EXPECT_EQ(arbiter.candidates, (std::vector<std::string>{"escape", "avoid"}));
  EXPECT_EQ(arbiter.active, (std::vector<std::int16_t>{-1, 0}));
  EXPECT_EQ(arbiter.wanted,
            (std::vector<std::uint8_t>{0, 0, 1, 1}));  // escape by escape.active, avoid by arbiter.wanted
  EXPECT_TRUE(arbiter.shares.empty());
}

TEST(ViewOfARunFile, ShowsWhatLiesOnTheFloorAndWhatStandsAboveIt) {
  const Scene scene = from_run_file(sample_file()).scene;
  ASSERT_EQ(scene.zones.size(), 2u);
  EXPECT_EQ(scene.zones[0].points, (std::vector<Vector2>{{0, 0}, {1, 0}, {0, 1}}));
  for (const Vector2 p : scene.zones[1].points) EXPECT_NEAR((p - Vector2{4, 4}).length(), 0.25, 1e-12);
  ASSERT_EQ(scene.bumps.size(), 1u);
  EXPECT_EQ(scene.bumps[0].points, (std::vector<Vector2>{{0, 3}, {1, 3}}));
  EXPECT_EQ(scene.beacons, (std::vector<Vector2>{{5, 4}}));
}

TEST(ViewOfARunFile, TellsWallsFurnitureAndPillarsApart) {
  const Scene scene = from_run_file(sample_file()).scene;
  ASSERT_EQ(scene.walls.size(), 1u);
  EXPECT_TRUE(scene.walls[0].closed);
  ASSERT_EQ(scene.furniture.size(), 1u);
  for (const Vector2 p : scene.furniture[0].points) EXPECT_NEAR((p - Vector2{2, 2}).length(), 0.5, 1e-12);
  EXPECT_EQ(scene.solids.size(), 1u);
  ASSERT_TRUE(scene.map);
  EXPECT_EQ(scene.map->occupied.at(0).columns, 100);
  ASSERT_TRUE(scene.bounds);
  EXPECT_EQ(scene.bounds->upper, (Vector2{6, 5}));
}

TEST(ViewOfARunFile, FollowsTheMovers) {
  const Scene scene = from_run_file(sample_file()).scene;
  ASSERT_EQ(scene.movers.size(), 1u);
  EXPECT_EQ(scene.movers[0].times_s, (std::vector<double>{0, 0.05}));
  EXPECT_EQ(scene.movers[0].poses[1].position, (Vector2{2, 1}));
}

TEST(ViewOfARunFile, ReadsWhatWasShownInsteadOfWhatOldFilesHave) {
  RunFile file = sample_file();
  file.exhibits["/robot0/exhibit/all/marks/goals"] = {{0.1, encode({{"Goals", "Objetivos"}, shown::Marks{}})}};
  const RunView run = from_run_file(file);
  ASSERT_EQ(run.exhibits.size(), 1u);
  EXPECT_EQ(run.exhibits[0].owner, (ExhibitOwner{0, "all"}));
  EXPECT_EQ(run.exhibits[0].title().es, "Objetivos");
  ASSERT_EQ(run.events.size(), 1u);
  EXPECT_EQ(run.events[0].severity, Severity::Warning);
  EXPECT_EQ(run.events[0].text, (Sentence{"router: withdrawn", ""}));
}

TEST(ViewOfARunFile, HasEventsInBothLanguagesWhereTheFileHas) {
  RunFile file = sample_file();
  file.json["/log"].messages = {{0.1, R"({"level":3,"name":"router","message":"withdrawn","message_es":"retirada"})"}};
  EXPECT_EQ(from_run_file(file).events.at(0).text, (Sentence{"router: withdrawn", "router: retirada"}));
}

TEST(ViewOfARunFile, CountsWhatItCannotRead) {
  RunFile file = sample_file();
  file.json["/log"].messages.push_back({0, "{"});
  file.exhibits["/robot0/exhibit/a/marks/b"] = {{0.2, "no such message"}};
  const RunView run = from_run_file(file);
  ASSERT_EQ(run.events.size(), 2u);
  EXPECT_NE(run.events[1].text.en.find("2 messages"), std::string::npos);
}

TEST(ViewOfARunFile, SurvivesMutatedMessages) {
  Draws draws(StreamId{.seed = 7}, 0);
  for (int round = 0; round < 400; ++round) {
    RunFile file = sample_file();
    for (auto& [topic, content] : file.json)
      for (JsonMessage& message : content.messages)
        for (int k = 0; k < 3; ++k) {
          const auto at = static_cast<std::size_t>(draws.uniform() * static_cast<double>(message.text.size()));
          message.text[at] = static_cast<char>(32 + draws.uniform() * 95);
        }
    const RunView run = from_run_file(file);
    bounds_of(run);
  }
}

TEST(DrawAll, WritesEveryPictureInThreeFormatsFromARecordedRun) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / fmt::format("ganglion_draw_all_{}", getpid());
  const std::filesystem::path path = folder / "run.mcap";
  std::filesystem::create_directories(folder);
  const RunFile sample = sample_file();
  auto recorder = RunRecorder::create(path, sample.info);
  ASSERT_TRUE(recorder) << recorder.error().what.en;
  const int table = recorder->add_table("/robot0/signals", sample.tables[0].columns);
  for (std::size_t row = 0; row < 2; ++row)
    recorder->write_row(table, static_cast<std::uint32_t>(row), 0.1 * static_cast<double>(row),
                        sample.tables[0].row(row));
  for (const auto& [topic, content] : sample.json)
    for (const JsonMessage& message : content.messages)
      recorder->write_json(topic, "ganglion.Any", message.time_s, message.text);
  ASSERT_TRUE(recorder->finish(*sample.outcome));
  const auto file = RunFile::read(path);
  ASSERT_TRUE(file) << file.error().what.en;
  const auto files = draw_all(from_run_file(*file), folder / "pictures", Language::English);
  ASSERT_TRUE(files) << files.error().what.en;
  EXPECT_EQ(files->size(), 4u * 3u);  // trajectory, map, behaviours, signals
  for (const auto& picture : *files) EXPECT_GT(std::filesystem::file_size(picture), 500u) << picture;
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace ganglion::plot
