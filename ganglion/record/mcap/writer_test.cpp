#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include "ganglion/record/mcap/fields.h"
#include "ganglion/record/mcap/testing/mcap_file.h"

namespace ganglion {
namespace {

class McapWriting : public McapTest {};

TEST(Crc32, IsTheOneOfTheStandards) { EXPECT_EQ(mcap::crc32("123456789"), 0xcbf43926u); }  // published check value

TEST_F(McapWriting, FillsTheFooterAsTheSpecificationSays) {
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

TEST_F(McapWriting, ClosesAChunkOnceItsOldestMessageIsASecondOld) {
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
  EXPECT_FALSE(std::filesystem::exists(path()));
  ASSERT_TRUE(read_mcap(writer.path(), Recover::Yes, collect(got)));  // while it is still being written
  EXPECT_EQ(got.size(), 3u);
}

TEST_F(McapWriting, ClosesAChunkOfAMebibyte) {
  auto writer = *McapWriter::create(path(), std::move(options_));
  const auto channel = writer.add_channel("/a", 0, "x");
  const std::string data(1024, 'x');
  const auto before = writer.bytes_written();
  for (int i = 0; i < 993; ++i) writer.write(channel, 0, 0, 0, data);  // 993 * (9 + 22 + 1024) = 1047615 < 2^20
  EXPECT_EQ(writer.bytes_written(), before);
  writer.write(channel, 0, 0, 0, data);
  EXPECT_GT(writer.bytes_written(), before);
}

/// No file of this process gets longer, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit full{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = ::signal(SIGXFSZ, SIG_IGN);
};

TEST_F(McapWriting, TellsAFullDiskAndCarriesOnWithoutIt) {
  for (const auto placing : {mcap::Placing::Replace, mcap::Placing::UnderOwnName}) {
    McapWriterOptions options = options_;
    options.durable = true;
    options.placing = placing;
    const FullDisk full(100);
    auto writer = *McapWriter::create(path(), std::move(options));
    const auto channel = writer.add_channel("/a", 0, "x");
    for (std::uint32_t i = 0; i < 10; ++i) writer.write(channel, i, i, i, "data");
    const auto closed = writer.close();
    ASSERT_FALSE(closed);
    EXPECT_EQ(closed.error().code, ErrorCode::Unwritable);
    EXPECT_NE(closed.error().text().find("mcap: cannot be written: File too large"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(path()));
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()), 1)
      << "the beginning of the one that was to stay";
}

TEST_F(McapWriting, LeavesTheOldFileUntilTheNewOneIsWhole) {
  ASSERT_TRUE(write_file(path(), "old"));
  auto writer = *McapWriter::create(path(), std::move(options_));
  writer.flush_chunk();
  EXPECT_EQ(content(), "old");
  ASSERT_TRUE(writer.close());
  EXPECT_TRUE(content().starts_with(mcap::kMagic));
}

TEST_F(McapWriting, SaysFromWhenOnAFileIsFullAndStaysReadable) {
  options_.max_unpacked_bytes = 1000;
  auto writer = *McapWriter::create(path(), std::move(options_));
  const auto channel = writer.add_channel("/a", 0, "x");
  for (std::uint32_t i = 0; i < 20; ++i) writer.write(channel, i, i, i, std::string(100, 'x'));
  const auto closed = writer.close();
  ASSERT_FALSE(closed);
  EXPECT_NE(closed.error().what.en.find("nothing from"), std::string::npos);
  std::vector<Got> got;
  EXPECT_TRUE(read_mcap(path(), Recover::No, collect(got)));
  EXPECT_EQ(got.size(), 7u);  // 7 * (9 + 22 + 100) = 917 bytes; with an eighth 1048
}

}  // namespace
}  // namespace ganglion
