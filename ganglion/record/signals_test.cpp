#include "ganglion/record/signals.h"

#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "ganglion/record/signals.pb.h"

namespace ganglion {
namespace {

std::string by_libprotobuf(std::uint32_t tick, double time_s, const std::vector<double>& values) {
  Signals message;
  message.set_tick(tick);
  message.set_time_s(time_s);
  for (const double value : values) message.add_values(value);
  return message.SerializeAsString();
}

TEST(Signals, AreEncodedAsLibprotobufDoes) {
  std::mt19937_64 random(1);
  std::string bytes;
  for (const std::uint32_t tick : {0u, 1u, 127u, 128u, 16383u, 16384u, 4294967295u}) {
    for (const std::size_t count : {0u, 1u, 15u, 16u, 60u, 2048u}) {
      std::vector<double> values(count);
      for (double& value : values) value = std::ldexp(static_cast<double>(random()), -60);
      if (count > 2) values[0] = INFINITY, values[1] = -INFINITY, values[2] = 0;
      for (const double time_s : {0.0, 0.1 * tick}) {
        encode_signals(tick, time_s, values, bytes);
        EXPECT_EQ(bytes, by_libprotobuf(tick, time_s, values)) << tick << " " << count;
      }
    }
  }
}

TEST(Signals, MakeEveryNanOneNanAndEveryZeroOneZero) {
  const double quiet = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> odd = {std::copysign(quiet, -1), std::nan("7"), -0.0}, plain = {quiet, quiet, 0.0};
  std::string a, b;
  encode_signals(1, 2, odd, a);
  encode_signals(1, 2, plain, b);
  EXPECT_EQ(a, b);
  EXPECT_EQ(a, by_libprotobuf(1, 2, plain));
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
