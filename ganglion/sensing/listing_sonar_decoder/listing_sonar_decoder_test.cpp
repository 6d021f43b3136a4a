#include "ganglion/sensing/listing_sonar_decoder/listing_sonar_decoder.h"

#include <gtest/gtest.h>

#include "ganglion/module/testing/sensing_habits.h"

namespace ganglion {
namespace {

using testing::SensingBench;

double of_echo(double echo_s) {
  SensingBench bench(listing_sonar_decoder_kind);
  bench.set("echo_time", echo_s);
  bench.step(1.6);
  return bench.out("range");
}

// Row 12: (echo time / 2) / 29.034 us per cm.
TEST(ListingSonarDecoder, HalvesAndDivides) {
  EXPECT_NEAR(of_echo(0.001), 0.1722119, 1e-7);  // 500 / 29.034 cm
  EXPECT_NEAR(of_echo(0.0185), 3.185920, 1e-6);  // 9250 / 29.034
}

TEST(ListingSonarDecoder, DropsTheHalfMicrosecond) {
  EXPECT_EQ(of_echo(0.001001), of_echo(0.001000));
  EXPECT_NEAR(of_echo(0.001002) - of_echo(0.001000), 0.01 / 29.034, 1e-7);
}

// Row 13: echo 0: distance 0.
TEST(ListingSonarDecoder, ReadsNothingAsZero) {
  EXPECT_EQ(of_echo(0), 0);
  EXPECT_EQ(of_echo(std::numeric_limits<double>::quiet_NaN()), 0);
}

TEST(ListingSonarDecoder, HasGoodHabitsOnAnyReadings) {
  testing::expect_good_sensing(listing_sonar_decoder_kind, {}, {}, [](SensingBench& bench) {
    ASSERT_GE(bench.out("range"), 0);
    ASSERT_LE(bench.out("range"), 11.29);  // 32767 / 29.034 cm
  });
}

}  // namespace
}  // namespace ganglion
