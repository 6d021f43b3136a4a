#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "ganglion/base/file.h"
#include "ganglion/base/hash.h"
#include "ganglion/record/mcap/fields.h"
#include "ganglion/record/mcap/reader.h"
#include "ganglion/record/mcap/writer.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

struct Got {
  std::string topic;
  mcap::Message message;
  std::string data;
};

MessageSink collect(std::vector<Got>& into) {
  return [&into](const mcap::Channel& channel, const mcap::Message& message) {
    into.push_back({channel.topic, message, std::string(message.data)});
  };
}

/// A folder of its own for each test.
class Mcap : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / ("ganglion_mcap_" + std::string(test->name()) + std::to_string(::getpid()));
    fs::create_directories(folder_);
    options_.durable = false;
    options_.now_ns = [this] { return now_ns_; };
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path path() const { return folder_ / "a.mcap"; }
  std::string content() const { return *read_file(path()); }

  /// Three chunks of two messages on two channels, an attachment and metadata; the bytes on disk after each chunk.
  std::vector<std::uint64_t> write_sample() {
    auto writer = *McapWriter::create(path(), std::move(options_));
    const auto schema = writer.add_schema("test.Note", "jsonschema", R"({"type":"object"})");
    const auto notes = writer.add_channel("/notes", schema, "json", {{"unit", "m"}, {"robot", "0"}});
    const auto raw = writer.add_channel("/raw", 0, "x-raw");
    writer.attach("robot.toml", "application/toml", "format = 1\n");
    writer.metadata("test", {{"seed", "7"}});
    std::vector<std::uint64_t> ends;
    for (std::uint32_t i = 0; i < 3; ++i) {
      writer.write(notes, 1000 * i, 1000 * i + 1, i, "{\"i\":" + std::to_string(i) + "}");
      writer.write(raw, 1000 * i + 500, 1000 * i + 500, i, std::string(100, static_cast<char>('a' + i)));
      writer.flush_chunk();
      ends.push_back(writer.bytes_written());
    }
    EXPECT_TRUE(writer.close());
    return ends;
  }

  fs::path folder_;
  std::int64_t now_ns_ = 0;
  McapWriterOptions options_;
};

TEST(Crc32, IsTheOneOfTheStandards) { EXPECT_EQ(mcap::crc32("123456789"), 0xcbf43926u); }  // published check value

TEST_F(Mcap, ReadsBackWhatWasWritten) {
  write_sample();
  std::vector<Got> got;
  const auto file = read_mcap(path(), Recover::No, collect(got));
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_TRUE(file->damages.empty());
  ASSERT_EQ(got.size(), 6u);
  EXPECT_EQ(file->messages, 6u);
  EXPECT_EQ(got[4].topic, "/notes");
  EXPECT_EQ(got[4].data, R"({"i":2})");
  EXPECT_EQ(got[4].message.log_time_ns, 2000u);
  EXPECT_EQ(got[4].message.publish_time_ns, 2001u);
  EXPECT_EQ(got[4].message.sequence, 2u);
  EXPECT_EQ(got[5].data, std::string(100, 'c'));
  EXPECT_EQ(file->schemas.at(1).name, "test.Note");
  EXPECT_EQ(file->channels.at(1).metadata, (mcap::Fields{{"unit", "m"}, {"robot", "0"}}));
  EXPECT_EQ(file->channels.at(2).schema, 0);
  ASSERT_EQ(file->attachments.size(), 1u);
  EXPECT_EQ(file->attachments[0].bytes, "format = 1\n");
  ASSERT_EQ(file->metadata.size(), 1u);
  EXPECT_EQ(file->metadata[0].fields, (mcap::Fields{{"seed", "7"}}));
  EXPECT_EQ(file->library, "ganglion");
}

TEST_F(Mcap, FillsTheFooterAsTheSpecificationSays) {
  write_sample();
  const std::string bytes = content();
  ASSERT_TRUE(bytes.starts_with("\x89MCAP0\r\n") && bytes.ends_with("\x89MCAP0\r\n"));
  // Footer: opcode, u64 length 20, summary_start, summary_offset_start, summary_crc; then 8 bytes of magic.
  const std::size_t footer = bytes.size() - 8 - 29;
  EXPECT_EQ(bytes[footer], 0x02);
  mcap::FieldReader fields(std::string_view(bytes).substr(footer + 1));
  EXPECT_EQ(fields.u64(), 20u);
  const std::uint64_t summary_start = fields.u64();
  const std::uint64_t offset_start = fields.u64();
  EXPECT_EQ(fields.u32(), mcap::crc32(std::string_view(bytes).substr(summary_start, footer + 25 - summary_start)));
  EXPECT_EQ(bytes[summary_start], 0x03);  // schemas come first
  EXPECT_EQ(bytes[offset_start], 0x0e);
  // Data end stands right before the summary: opcode, length 4, CRC of all bytes before it.
  const std::size_t data_end = summary_start - 13;
  EXPECT_EQ(bytes[data_end], 0x0f);
  mcap::FieldReader end(std::string_view(bytes).substr(data_end + 9));
  EXPECT_EQ(end.u32(), mcap::crc32(std::string_view(bytes).substr(0, data_end)));
}

TEST_F(Mcap, ReadsWhatIsWholeWhereverTheFileWasCut) {
  const auto ends = write_sample();
  const std::string bytes = content();
  for (std::size_t cut = 0; cut < bytes.size(); ++cut) {
    std::vector<Got> got;
    const std::string_view part = std::string_view(bytes).substr(0, cut);
    EXPECT_FALSE(parse_mcap(part, "a.mcap", Recover::No, collect(got))) << cut;
    got.clear();
    const auto file = parse_mcap(part, "a.mcap", Recover::Yes, collect(got));
    if (cut < 8) {
      EXPECT_FALSE(file);
      continue;
    }
    ASSERT_TRUE(file) << cut;
    EXPECT_FALSE(file->damages.empty());
    const auto whole =
        static_cast<std::size_t>(std::count_if(ends.begin(), ends.end(), [&](auto end) { return end <= cut; }));
    EXPECT_GE(got.size(), 2 * whole) << cut;
    EXPECT_LE(got.size(), std::min<std::size_t>(6, 2 * whole + 2)) << cut;
    for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i].message.log_time_ns, 500 * i);
  }
}

TEST_F(Mcap, SeesEveryFlippedBit) {
  write_sample();
  const std::string bytes = content();
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
    std::vector<Got> got;
    EXPECT_FALSE(parse_mcap(damaged, "a.mcap", Recover::No, collect(got))) << at;
  }
}

TEST_F(Mcap, LeavesOutADamagedChunkAndReadsTheOthers) {
  const auto ends = write_sample();
  std::string bytes = content();
  bytes[ends[0] + 70] = static_cast<char>(bytes[ends[0] + 70] ^ 0x40);  // in the packed bytes of the second chunk
  std::vector<Got> got;
  const auto file = parse_mcap(bytes, "a.mcap", Recover::Yes, collect(got));
  ASSERT_TRUE(file);
  EXPECT_FALSE(file->damages.empty());
  ASSERT_EQ(got.size(), 4u);
  EXPECT_EQ(got[2].message.log_time_ns, 2000u);
}

/// The same records in a chunk that is neither packed nor checked, so that mutations reach the innermost fields.
std::string unchecked_file() {
  std::string records;
  mcap::FieldWriter inner(records);
  auto record = inner.begin_record(mcap::Opcode::Schema);
  inner.u16(1);
  for (const char* text : {"test.Note", "jsonschema", "{}"}) inner.string(text);
  inner.end_record(record);
  record = inner.begin_record(mcap::Opcode::Channel);
  inner.u16(1);
  inner.u16(1);
  for (const char* text : {"/notes", "json"}) inner.string(text);
  inner.map({{"unit", "m"}});
  inner.end_record(record);
  for (std::uint32_t i = 0; i < 3; ++i) {
    record = inner.begin_record(mcap::Opcode::Message);
    inner.u16(1);
    inner.u32(i);
    inner.u64(i);
    inner.u64(i);
    inner.bytes("{}");
    inner.end_record(record);
  }
  std::string bytes(mcap::kMagic);
  mcap::FieldWriter out(bytes);
  record = out.begin_record(mcap::Opcode::Header);
  out.string("");
  out.string("");
  out.end_record(record);
  record = out.begin_record(mcap::Opcode::Chunk);
  out.u64(0);
  out.u64(2);
  out.u64(records.size());
  out.u32(0);
  out.string("");
  out.u64(records.size());
  out.bytes(records);
  out.end_record(record);
  return bytes;
}

void mutate_and_read(const std::string& bytes, int rounds) {
  std::mt19937_64 random(1);
  std::size_t used = 0;
  const MessageSink sink = [&](const mcap::Channel& channel, const mcap::Message& message) {
    used += channel.topic.size() + hash_bytes(std::as_bytes(std::span(message.data))) % 2;
  };
  for (int round = 0; round < rounds; ++round) {
    std::string damaged = bytes;
    for (std::size_t i = 0; i <= random() % 4; ++i)
      damaged[8 + random() % (bytes.size() - 8)] = static_cast<char>(random());
    if (random() % 4 == 0) damaged.resize(random() % bytes.size());
    static_cast<void>(parse_mcap(damaged, "a.mcap", Recover::No, sink));
    static_cast<void>(parse_mcap(damaged, "a.mcap", Recover::Yes, sink));
    static_cast<void>(parse_mcap(damaged, "a.mcap", Recover::Yes, {}));
  }
  EXPECT_GT(used, 0u);
}

TEST_F(Mcap, SurvivesMutations) {
  write_sample();
  mutate_and_read(content(), 5000);
  mutate_and_read(unchecked_file(), 20000);
}

TEST_F(Mcap, ClosesAChunkOnceItsOldestMessageIsASecondOld) {
  auto writer = *McapWriter::create(path(), std::move(options_));
  const auto channel = writer.add_channel("/a", 0, "x");
  writer.flush_chunk();  // the channel is on its way: only messages count from here on
  const auto before = writer.bytes_written();
  writer.write(channel, 0, 0, 0, "one");
  now_ns_ = 999'999'999;
  writer.write(channel, 1, 1, 1, "two");
  EXPECT_EQ(writer.bytes_written(), before);
  now_ns_ = 1'000'000'000;
  writer.write(channel, 2, 2, 2, "three");
  EXPECT_GT(writer.bytes_written(), before);
  std::vector<Got> got;
  ASSERT_TRUE(read_mcap(path(), Recover::Yes, collect(got)));  // while it is still being written
  EXPECT_EQ(got.size(), 3u);
}

TEST_F(Mcap, ClosesAChunkOfAMebibyte) {
  auto writer = *McapWriter::create(path(), std::move(options_));
  const auto channel = writer.add_channel("/a", 0, "x");
  const std::string data(1024, 'x');
  const auto before = writer.bytes_written();
  for (int i = 0; i < 993; ++i) writer.write(channel, 0, 0, 0, data);  // 993 * (9 + 22 + 1024) = 1047615 < 2^20
  EXPECT_EQ(writer.bytes_written(), before);
  writer.write(channel, 0, 0, 0, data);
  EXPECT_GT(writer.bytes_written(), before);
}

TEST_F(Mcap, TellsAFullDiskAndCarriesOnWithoutIt) {
  options_.durable = true;
  auto writer = *McapWriter::create("/dev/full", std::move(options_));
  const auto channel = writer.add_channel("/a", 0, "x");
  for (std::uint32_t i = 0; i < 10; ++i) writer.write(channel, i, i, i, "data");
  const auto closed = writer.close();
  ASSERT_FALSE(closed);
  EXPECT_EQ(closed.error().code, ErrorCode::Unreadable);
  EXPECT_NE(closed.error().text().find("/dev/full: cannot be written: No space left"), std::string::npos);
}

TEST_F(Mcap, SaysFromWhenOnAFileIsFullAndStaysReadable) {
  options_.max_unpacked_bytes = 1000;
  auto writer = *McapWriter::create(path(), std::move(options_));
  const auto channel = writer.add_channel("/a", 0, "x");
  for (std::uint32_t i = 0; i < 20; ++i) writer.write(channel, i, i, i, std::string(100, 'x'));
  const auto closed = writer.close();
  ASSERT_FALSE(closed);
  EXPECT_NE(closed.error().message.find("nothing from"), std::string::npos);
  std::vector<Got> got;
  EXPECT_TRUE(read_mcap(path(), Recover::No, collect(got)));
  EXPECT_EQ(got.size(), 7u);  // 7 * (9 + 22 + 100) = 917 bytes; with an eighth 1048
}

TEST_F(Mcap, RefusesAChunkThatUnpacksBeyondTheLimit) {
  std::string bytes(mcap::kMagic);
  mcap::FieldWriter out(bytes);
  auto record = out.begin_record(mcap::Opcode::Header);
  out.string("");
  out.string("");
  out.end_record(record);
  record = out.begin_record(mcap::Opcode::Chunk);
  out.u64(0);
  out.u64(0);
  out.u64(std::uint64_t{1} << 60);
  out.u32(0);
  out.string("zstd");
  out.u64(4);
  out.bytes("bomb");
  out.end_record(record);
  std::vector<Got> got;
  const auto file = parse_mcap(bytes, "bomb.mcap", Recover::No, collect(got));
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::TooLarge);
}

TEST_F(Mcap, ReadsMessagesOutsideChunksAndWithoutASummary) {
  std::string bytes(mcap::kMagic);
  mcap::FieldWriter out(bytes);
  const auto end = [&](std::size_t record) { out.end_record(record); };
  auto record = out.begin_record(mcap::Opcode::Header);
  out.string("");
  out.string("other");
  end(record);
  record = out.begin_record(mcap::Opcode::Channel);
  out.u16(0);
  out.u16(0);
  out.string("/a");
  out.string("json");
  out.map({});
  end(record);
  record = out.begin_record(mcap::Opcode::Message);
  out.u16(0);
  out.u32(1);
  out.u64(5);
  out.u64(5);
  out.bytes("{}");
  end(record);
  record = out.begin_record(mcap::Opcode::DataEnd);
  out.u32(0);
  end(record);
  record = out.begin_record(mcap::Opcode::Footer);
  out.u64(0);
  out.u64(0);
  out.u32(0);
  end(record);
  out.bytes(mcap::kMagic);
  std::vector<Got> got;
  const auto file = parse_mcap(bytes, "other.mcap", Recover::No, collect(got));
  ASSERT_TRUE(file) << file.error().text();
  ASSERT_EQ(got.size(), 1u);
  EXPECT_EQ(got[0].data, "{}");
}

}  // namespace
}  // namespace ganglion
