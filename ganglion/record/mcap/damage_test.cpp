#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "ganglion/base/hash.h"
#include "ganglion/record/mcap/fields.h"
#include "ganglion/record/mcap/testing/mcap_file.h"

namespace ganglion {
namespace {

class McapDamage : public McapTest {};

TEST_F(McapDamage, ReadsWhatIsWholeWhereverTheFileWasCut) {
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

TEST_F(McapDamage, SeesEveryFlippedBit) {
  write_sample();
  const std::string bytes = content();
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
    std::vector<Got> got;
    EXPECT_FALSE(parse_mcap(damaged, "a.mcap", Recover::No, collect(got))) << at;
  }
}

TEST_F(McapDamage, LeavesOutADamagedChunkAndReadsTheOthers) {
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

TEST_F(McapDamage, SurvivesMutations) {
  write_sample();
  mutate_and_read(content(), 5000);
  mutate_and_read(unchecked_file(), 20000);
}

}  // namespace
}  // namespace ganglion
