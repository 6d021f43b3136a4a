#include <gtest/gtest.h>

#include "ganglion/record/mcap/fields.h"
#include "ganglion/record/mcap/testing/mcap_file.h"

namespace ganglion {
namespace {

class McapReading : public McapTest {};

TEST_F(McapReading, ReadsBackWhatWasWritten) {
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

TEST_F(McapReading, RefusesAChunkThatUnpacksBeyondTheLimit) {
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

TEST_F(McapReading, ReadsMessagesOutsideChunksAndWithoutASummary) {
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
