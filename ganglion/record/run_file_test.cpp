#include "ganglion/record/run_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/record/run_recorder.h"

namespace ganglion {
namespace {

const std::vector<SignalColumn> kColumns = {{"sonar_left", "m"}, {"heading", "rad"}, {"mode", ""}};

RunInfo info_of_test() {
  return {.name = "Nimrod, \"corridor\"\nnight",
          .seed = 18446744073709551615u,
          .episode = 3,
          .tick_s = 0.1,
          .controller_hash = "00ff",
          .robots = {"robot0", "robot1"},
          .versions = {{"ganglion", "0.1.0"}, {"sleef", "3.5.1"}}};
}

class RunFileTest : public FolderTest {
 protected:
  std::filesystem::path path() const { return folder_ / "run.mcap"; }

  McapWriterOptions options(std::int64_t step_ns = 0) {
    McapWriterOptions options;
    options.durable = false;
    options.now_ns = [this, step_ns] { return now_ns_ += step_ns; };
    return options;
  }

  RunRecorder record(std::uint32_t ticks, McapWriterOptions writer_options) {
    auto recorder = *RunRecorder::create(path(), info_of_test(), std::move(writer_options));
    recorder.attach("robot.toml", "format = 1\n");
    const int table = recorder.add_table("/robot0/signals", kColumns);
    for (std::uint32_t tick = 0; tick < ticks; ++tick) {
      const double time_s = 0.1 * tick;
      recorder.write_row(table, tick, time_s, std::vector<double>{tick == 1 ? NAN : 0.5 * tick, -INFINITY, 2});
      recorder.write_json("/robot0/pose", "foxglove.PoseInFrame", time_s, "{\"tick\":" + std::to_string(tick) + "}");
    }
    return recorder;
  }

  std::int64_t now_ns_ = 0;
};

TEST_F(RunFileTest, ReadsBackWhatWasRecorded) {
  auto recorder = record(3, options());
  ASSERT_TRUE(recorder.finish({.digest = "abc",
                               .verdict = Verdict::Succeeded,
                               .reason = {"goal", "meta"},
                               .criterion = "a > 1",
                               .measures = {{"b", 0.1}, {"a", NAN}}}));
  const auto run = RunFile::read(path());
  ASSERT_TRUE(run) << run.error().text();
  EXPECT_TRUE(run->damages.empty());
  EXPECT_EQ(run->info.name, "Nimrod, \"corridor\"\nnight");
  EXPECT_EQ(run->info.seed, 18446744073709551615u);
  EXPECT_EQ(run->info.episode, 3u);
  EXPECT_EQ(run->info.tick_s, 0.1);
  EXPECT_EQ(run->info.controller_hash, "00ff");
  EXPECT_EQ(run->info.robots, info_of_test().robots);
  EXPECT_EQ(run->info.versions, info_of_test().versions);
  ASSERT_TRUE(run->outcome);
  EXPECT_EQ(run->outcome->digest, "abc");
  EXPECT_EQ(run->outcome->verdict, Verdict::Succeeded);
  EXPECT_EQ(run->outcome->reason, (Sentence{"goal", "meta"}));
  EXPECT_EQ(run->outcome->criterion, "a > 1");
  ASSERT_EQ(run->outcome->measures.size(), 2u);
  EXPECT_EQ(run->outcome->measures[0], (std::pair<std::string, double>("b", 0.1)));
  EXPECT_TRUE(std::isnan(run->outcome->measures[1].second));
  ASSERT_NE(run->attachment("robot.toml"), nullptr);
  EXPECT_EQ(run->attachment("robot.toml")->bytes, "format = 1\n");
}

TEST_F(RunFileTest, GivesTablesByNameAndJsonByTopic) {
  auto recorder = record(3, options());
  recorder.add_table("/robot1/signals", kColumns);  // of a robot that never sent anything
  ASSERT_TRUE(recorder.finish({}));
  const auto run = RunFile::read(path());
  ASSERT_TRUE(run) << run.error().text();
  const SignalTable* table = run->table("/robot0/signals");
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->columns, kColumns);
  EXPECT_EQ(table->ticks, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(table->times_s, (std::vector<double>{0, 0.1, 0.2}));
  EXPECT_EQ(table->at(2, *table->column("sonar_left")), 1);
  EXPECT_TRUE(std::isnan(table->at(1, 0)));
  EXPECT_EQ(table->at(1, *table->column("heading")), -INFINITY);
  EXPECT_FALSE(table->column("sonar_right"));
  ASSERT_NE(run->table("/robot1/signals"), nullptr);
  EXPECT_EQ(run->table("/robot1/signals")->rows(), 0u);
  const JsonTopic& pose = run->json.at("/robot0/pose");
  EXPECT_EQ(pose.schema_name, "foxglove.PoseInFrame");
  ASSERT_EQ(pose.messages.size(), 3u);
  EXPECT_EQ(pose.messages[2].text, "{\"tick\":2}");
  EXPECT_NEAR(pose.messages[2].time_s, 0.2, 1e-9);
}

TEST_F(RunFileTest, HasNoOutcomeWhenTheRunWasCut) {
  auto recorder = record(50, options(20'000'000));  // 20 ms from message to message: a chunk every second
  const std::filesystem::path file = recorder.path();
  const auto run = RunFile::read(file, Recover::Yes);  // as if the power had failed now
  ASSERT_TRUE(run) << run.error().text();
  EXPECT_FALSE(run->outcome);
  EXPECT_EQ(run->info.name, info_of_test().name);
  EXPECT_FALSE(run->damages.empty());
  ASSERT_NE(run->table("/robot0/signals"), nullptr);
  EXPECT_GE(run->table("/robot0/signals")->rows(), 24u);
  EXPECT_TRUE(run->without_gaps);
  EXPECT_FALSE(RunFile::read(file));
}

TEST_F(RunFileTest, OfOneSeedHasTheSameBytes) {
  ASSERT_TRUE(record(1000, options()).finish({}));
  const std::string first = *read_file(path());
  now_ns_ = 123'456'789;
  ASSERT_TRUE(record(1000, options()).finish({}));
  EXPECT_EQ(*read_file(path()), first);
}

TEST_F(RunFileTest, ReadsTheSummaryWithoutTheMessages) {
  ASSERT_TRUE(record(3, options()).finish({.digest = "abc"}));
  const auto run = RunFile::read_summary(path());
  ASSERT_TRUE(run) << run.error().text();
  EXPECT_EQ(run->outcome->digest, "abc");
  EXPECT_EQ(run->info.seed, info_of_test().seed);
  EXPECT_TRUE(run->json.empty());
}

TEST_F(RunFileTest, RefusesAnMcapFileThatIsNoRun) {
  ASSERT_TRUE(McapWriter::create(path())->close());
  const auto run = RunFile::read(path());
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, ErrorCode::Unsupported);
  EXPECT_EQ(run.error().place.file, path().string());
}

TEST_F(RunFileTest, RefusesARowOfTheWrongLength) {
  auto writer = *McapWriter::create(path());
  writer.metadata(kRunMetadata, to_fields(info_of_test()));
  const auto channel = writer.add_channel("/robot0/signals", 0, "protobuf", {{"columns", "a\nb"}});
  const std::string_view one_value("\x1a\x08\0\0\0\0\0\0\xf0\x3f", 10);  // 1.0
  writer.write(channel, 0, 0, 0, one_value);
  ASSERT_TRUE(writer.close());
  const auto run = RunFile::read(path());
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, ErrorCode::Corrupt);
  EXPECT_EQ(run.error().what.en, "message 0 of \"/robot0/signals\" is no row of 2 values");
}

TEST(RunOutcome, IsReadBackWithItsVerdictOrWithNone) {
  for (const Verdict verdict : {Verdict::NotJudged, Verdict::Failed, Verdict::Succeeded}) {
    const mcap::Fields fields = to_fields(RunOutcome{.digest = "00", .verdict = verdict, .reason = {"goal", "meta"}});
    const auto named =
        std::count_if(fields.begin(), fields.end(), [](const auto& field) { return field.first == "success"; });
    EXPECT_EQ(named, verdict == Verdict::NotJudged ? 0 : 1);
    const auto outcome = run_outcome_from(fields);
    ASSERT_TRUE(outcome) << outcome.error().text();
    EXPECT_EQ(outcome->verdict, verdict);
  }
}

TEST(RunOutcome, HasNoSpanishWhereTheFileHadNone) {
  const auto outcome = run_outcome_from({{"digest", ""}, {"success", "true"}, {"reason", "duration over"}});
  ASSERT_TRUE(outcome) << outcome.error().text();
  EXPECT_EQ(outcome->reason, (Sentence{"duration over", ""}));
}

TEST(RunOutcome, NamesTheFieldThatIsWrong) {
  const auto outcome = run_outcome_from({{"digest", ""}, {"success", "yes"}, {"reason", ""}});
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().what.en, "metadata \"ganglion.outcome\" has success = \"yes\"; valid: true, false");
  EXPECT_EQ(outcome.error().what.es,
            "el registro de metadatos \"ganglion.outcome\" tiene success = \"yes\"; válidos: true, false");
}

}  // namespace
}  // namespace ganglion
