#include "ganglion/record/signals.h"

#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ganglion {
namespace {

std::string encoded(std::uint32_t tick, double time_s, const std::vector<double>& values) {
  std::string bytes = "left from the row before";
  encode_signals(tick, time_s, values, bytes);
  return bytes;
}

TEST(Signals, AreWrittenAsTheProtobufEncodingSays) {
  // By hand: field 1 varint 300 = ac 02; field 2 a double, 1.0 = 3ff0...; field 3 packed, 16 bytes: 1.0 and -inf =
  // fff0...
  EXPECT_EQ(encoded(300, 1, {1, -INFINITY}), std::string("\x08\xac\x02"
                                                         "\x11\0\0\0\0\0\0\xf0\x3f"
                                                         "\x1a\x10\0\0\0\0\0\0\xf0\x3f\0\0\0\0\0\0\xf0\xff",
                                                         30));
  EXPECT_EQ(encoded(0, 0, {}), "");  // proto3 leaves out what has its default value
}

TEST(Signals, MakeEveryNanOneNanAndEveryZeroOneZero) {
  const double quiet = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(encoded(1, -0.0, {std::copysign(quiet, -1), std::nan("7"), -0.0}), encoded(1, 0.0, {quiet, quiet, 0.0}));
}

TEST(Signals, ReadBackAndRefuseOtherBytes) {
  std::string bytes;
  encode_signals(7, 0.7, std::vector<double>{1, NAN, INFINITY}, bytes);
  SignalRow row;
  ASSERT_TRUE(decode_signals(bytes, row));
  EXPECT_EQ(row.tick, 7u);
  EXPECT_EQ(row.time_s, 0.7);
  ASSERT_EQ(row.values.size(), 3u);
  EXPECT_TRUE(std::isnan(row.values[1]));
  EXPECT_EQ(row.values[2], INFINITY);
  EXPECT_FALSE(decode_signals("no message", row));
  EXPECT_FALSE(decode_signals(std::string_view(bytes).substr(0, bytes.size() - 1), row));
}

TEST(SignalsDescriptor, LetsOtherProgramsDecode) {
  google::protobuf::FileDescriptorSet set;
  ASSERT_TRUE(set.ParseFromString(signals_descriptor()));
  ASSERT_EQ(set.file_size(), 1);
  EXPECT_EQ(set.file(0).package() + "." + set.file(0).message_type(0).name(), kSignalsSchema);
  EXPECT_EQ(set.file(0).message_type(0).field(2).name(), "values");
}

}  // namespace
}  // namespace ganglion
