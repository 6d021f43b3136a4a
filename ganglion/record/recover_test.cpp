#include "ganglion/record/recover.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/record/run_file.h"
#include "ganglion/record/run_recorder.h"

namespace ganglion {
namespace {

constexpr int kChunks = 4, kRowsPerChunk = 3;

class RecoverRun : public FolderTest {
 protected:
  static McapWriterOptions options() {
    McapWriterOptions options;
    options.durable = false;
    options.now_ns = [] { return std::int64_t{0}; };
    return options;
  }

  std::filesystem::path whole() const { return folder_ / "whole.mcap"; }
  std::filesystem::path saved() const { return folder_ / "saved.mcap"; }

  /// A run of four chunks of three rows and a pose; notes where its parts end on the disk.
  std::string record() {
    auto recorder = *RunRecorder::create(whole(), {.name = "cut", .seed = 7, .tick_s = 0.5}, options());
    described_ = recorder.bytes_written();
    recorder.attach("robot.toml", "format = 1\n");
    attached_ = recorder.bytes_written();
    const int table = recorder.add_table("/robot0/signals", std::vector<SignalColumn>{{"range", "m"}});
    std::uint32_t tick = 0;
    for (int chunk = 0; chunk < kChunks; ++chunk) {
      for (int row = 0; row < kRowsPerChunk; ++row, ++tick) {
        recorder.write_row(table, tick, 0.5 * tick, std::vector<double>{1.0 + tick});
      }
      recorder.write_json("/robot0/pose", "foxglove.PoseInFrame", 0.5 * (tick - 1), "{}");
      recorder.flush();
      ends_.push_back(recorder.bytes_written());
    }
    EXPECT_TRUE(recorder.finish({.digest = "00ff", .verdict = Verdict::Succeeded, .reason = {"goal", "meta"}}));
    return *read_file(whole());
  }

  std::uint64_t described_ = 0, attached_ = 0;
  std::vector<std::uint64_t> ends_;
};

/// The chunk record comes first, then its indices, which nothing is lost without: so a chunk may be whole a little
/// before the end noted for it.
TEST_F(RecoverRun, SavesEveryWholeChunkWhereverTheFileWasCut) {
  const std::string bytes = record();
  for (std::size_t cut = 0; cut < bytes.size(); ++cut) {
    std::filesystem::remove(saved());  // quicker than writing over it: some file systems then wait for the disk
    const auto recovery = recover_run(std::string_view(bytes).substr(0, cut), "cut.mcap", saved(), options());
    if (cut < described_) {
      ASSERT_FALSE(recovery) << cut;
      ASSERT_FALSE(std::filesystem::exists(saved())) << cut;
      continue;
    }
    ASSERT_TRUE(recovery) << cut << ": " << recovery.error().text();
    ASSERT_FALSE(recovery->damages.empty()) << cut;
    const auto sure = static_cast<std::uint64_t>(
        std::count_if(ends_.begin(), ends_.end(), [&](std::uint64_t end) { return end <= cut; }));
    ASSERT_GE(recovery->chunks, sure) << cut;
    ASSERT_LE(recovery->chunks, std::min<std::uint64_t>(sure + 1, kChunks)) << cut;
    ASSERT_EQ(recovery->messages, recovery->chunks * (kRowsPerChunk + 1)) << cut;
    const auto run = RunFile::read(saved());  // Recover::No: every length, index and checksum is right
    ASSERT_TRUE(run) << cut << ": " << run.error().text();
    EXPECT_EQ(run->info.seed, 7u);
    EXPECT_EQ(run->attachment("robot.toml") != nullptr, cut >= attached_) << cut;
    const std::size_t rows = run->tables.empty() ? 0 : run->tables.front().rows();
    ASSERT_EQ(rows, recovery->chunks * kRowsPerChunk) << cut;
    for (std::size_t row = 0; row < rows; ++row)
      EXPECT_EQ(run->tables.front().at(row, 0), static_cast<double>(row + 1));
    if (rows > 0) {
      EXPECT_EQ(recovery->until_s, 0.5 * static_cast<double>(rows - 1)) << cut;
      EXPECT_EQ(run->json.at("/robot0/pose").schema_name, "foxglove.PoseInFrame");
    }
    ASSERT_EQ(run->outcome.has_value(), recovery->finished) << cut;
  }
}

TEST_F(RecoverRun, LosesNothingOfAWholeFile) {
  record();
  const auto recovery = recover_run(whole(), saved(), options());
  ASSERT_TRUE(recovery) << recovery.error().text();
  EXPECT_TRUE(recovery->damages.empty());
  EXPECT_TRUE(recovery->finished);
  EXPECT_EQ(recovery->chunks, 4u);
  const auto run = RunFile::read(saved());
  ASSERT_TRUE(run) << run.error().text();
  EXPECT_EQ(run->outcome->digest, "00ff");
  EXPECT_EQ(run->tables.front().values, RunFile::read(whole())->tables.front().values);
}

TEST_F(RecoverRun, LeavesOutADamagedChunkOnly) {
  std::string bytes = record();
  bytes[ends_[0] + 70] = static_cast<char>(bytes[ends_[0] + 70] ^ 0x10);  // in the packed bytes of the second chunk
  const auto recovery = recover_run(bytes, "bent.mcap", saved(), options());
  ASSERT_TRUE(recovery) << recovery.error().text();
  EXPECT_EQ(recovery->chunks, 3u);
  const auto run = RunFile::read(saved());
  ASSERT_TRUE(run) << run.error().text();
  EXPECT_EQ(run->tables.front().ticks, (std::vector<std::uint32_t>{0, 1, 2, 6, 7, 8, 9, 10, 11}));
}

TEST_F(RecoverRun, SaysInTheFileThatItWasRecovered) {
  const std::string bytes = record();
  ASSERT_TRUE(recover_run(std::string_view(bytes).substr(0, ends_[1]), "cut.mcap", saved(), options()));
  const auto content = read_mcap(saved(), Recover::No, {});
  ASSERT_TRUE(content);
  const auto found = std::find_if(content->metadata.begin(), content->metadata.end(),
                                  [](const auto& record) { return record.name == kRecoveredMetadata; });
  ASSERT_NE(found, content->metadata.end());
  EXPECT_EQ(found->fields[0], (std::pair<std::string, std::string>("chunks", "2")));
  EXPECT_EQ(found->fields[1], (std::pair<std::string, std::string>("messages", "8")));
  EXPECT_EQ(found->fields[2], (std::pair<std::string, std::string>("until_s", "2.5")));
  EXPECT_NE(found->fields[3].second.find("the file was cut here"), std::string::npos);
}

TEST_F(RecoverRun, NeverWritesOverTheFileItReads) {
  const std::string bytes = record();
  const auto recovery = recover_run(whole(), folder_ / "." / "whole.mcap");
  ASSERT_FALSE(recovery);
  EXPECT_EQ(recovery.error().code, ErrorCode::BadParameter);
  EXPECT_EQ(*read_file(whole()), bytes);
}

TEST_F(RecoverRun, TellsWhereItCannotWrite) {
  const std::string bytes = record();
  std::filesystem::create_directories(saved());
  const auto recovery = recover_run(bytes, "cut.mcap", saved(), options());
  ASSERT_FALSE(recovery);
  EXPECT_EQ(recovery.error().place.file, saved().string());
  EXPECT_TRUE(std::filesystem::is_directory(saved()));
}

TEST_F(RecoverRun, LeavesTheOldFileWhereNothingOfARunIsLeft) {
  ASSERT_TRUE(write_file(saved(), "old"));
  EXPECT_FALSE(recover_run(record().substr(0, 20), "cut.mcap", saved(), options()));
  EXPECT_EQ(*read_file(saved()), "old");
}

}  // namespace
}  // namespace ganglion
