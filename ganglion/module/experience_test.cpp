#include "ganglion/module/experience.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace ganglion {
namespace {

TEST(ByteWriter, WritesTheLeastByteFirstOnEveryMachine) {
  ByteWriter writer;
  writer.u8(0xab);
  writer.u32(0x01020304);
  const std::vector<std::byte> bytes = writer.take();
  const std::array expected = {std::byte{0xab}, std::byte{4}, std::byte{3}, std::byte{2}, std::byte{1}};
  EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), expected.begin(), expected.end()));
}

TEST(ByteReader, ReadsBackWhatWasWritten) {
  ByteWriter writer;
  writer.i32(-7);
  writer.u64(std::numeric_limits<std::uint64_t>::max() - 1);
  writer.f64(-0.1);
  const std::vector<std::byte> bytes = writer.take();
  ByteReader reader(bytes);
  EXPECT_EQ(reader.i32(), -7);
  EXPECT_EQ(reader.u64(), std::numeric_limits<std::uint64_t>::max() - 1);
  EXPECT_FALSE(reader.complete()) << "a double is left";
  EXPECT_EQ(reader.f64(), -0.1);
  EXPECT_TRUE(reader.complete());
}

TEST(ByteReader, ReadsNothingBeyondTheEnd) {
  const std::array bytes = {std::byte{1}, std::byte{2}, std::byte{3}};
  ByteReader reader(bytes);
  EXPECT_EQ(reader.u32(), 0u);
  EXPECT_FALSE(reader.ok());
  EXPECT_EQ(reader.u8(), 0) << "not even what would be there";
  EXPECT_FALSE(reader.complete());
}

}  // namespace
}  // namespace ganglion
