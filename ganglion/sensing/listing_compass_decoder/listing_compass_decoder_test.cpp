#include "ganglion/sensing/listing_compass_decoder/listing_compass_decoder.h"

#include <gtest/gtest.h>

#include "ganglion/module/testing/sensing_habits.h"
#include "ganglion/units/angle.h"

namespace ganglion {
namespace {

using testing::SensingBench;

/// Bearing [deg] of a yaw, by hand.
double bearing_deg(double yaw_rad) {
  const double deg = std::fmod(450 - yaw_rad * 180 / kPi, 360);
  return deg < 0 ? deg + 360 : deg;
}

double decode(SensingBench& bench, double va, double vb) {
  bench.set("va", va);
  bench.set("vb", vb);
  bench.step(1.6);
  return bearing_deg(bench.out("yaw"));
}

double decode(double va, double vb) {
  SensingBench bench(listing_compass_decoder_kind);
  return decode(bench, va, vb);
}

/// The device at a bearing, through the ten-bit converter of the ATOM28.
double volts(double amplitude_V, double part) { return std::floor((2.5 + amplitude_V * part) / 5 * 1024) * 5 / 1024; }
double turn_to(SensingBench& bench, double amplitude_V, double deg) {
  const double rad = deg * kPi / 180;
  return decode(bench, volts(amplitude_V, std::cos(rad)), volts(amplitude_V, std::sin(rad)));
}

// Row 11, one by one: each region on its own.
TEST(ListingCompassDecoder, DecodesEachRegion) {
  EXPECT_NEAR(decode(2.5, 3.094), 89.9988, 1e-4);   // 45 + 107.14 (2.92 - 2.5)
  EXPECT_NEAR(decode(2.5, 1.906), 269.9988, 1e-4);  // 225 + 107.14 (2.5 - 2.08)
  EXPECT_NEAR(decode(1.906, 2.5), 179.9988, 1e-4);  // 135 + 107.14 (2.92 - 2.5)
  EXPECT_NEAR(decode(3.094, 2.6), 10.714, 1e-4);    // 107.14 (2.6 - 2.5)
  EXPECT_NEAR(decode(3.094, 2.4), 349.2848, 1e-4);  // 315 + 107.14 (2.4 - 2.08)
}

TEST(ListingCompassDecoder, LetsTheLastRegionThatFitsWin) {
  EXPECT_NEAR(decode(2.5, 2.92), 135, 1e-4);      // the first says 90, the third 135 + 107.14 (2.92 - 2.92)
  EXPECT_NEAR(decode(2.6, 2.4), 349.2848, 1e-4);  // the second says 280.7
  EXPECT_NEAR(decode(2.8, 2.8), 32.142, 1e-4);    // four fit: the fourth says 107.14 * 0.3
}

TEST(ListingCompassDecoder, KeepsAStaleHeadingWhereNothingFits) {
  SensingBench bench(listing_compass_decoder_kind);
  EXPECT_NEAR(decode(bench, 3.0, 3.0), 0, 1e-9);  // nothing yet: 0 deg
  EXPECT_EQ(bench.out("matched"), 0);
  decode(bench, 2.5, 3.094);
  EXPECT_EQ(bench.out("matched"), 1);
  EXPECT_NEAR(decode(bench, 3.0, 3.0), 89.9988, 1e-4);
  EXPECT_EQ(bench.out("matched"), 0);
  EXPECT_NEAR(decode(bench, std::nan(""), 2.5), 89.9988, 1e-4);
}

TEST(ListingCompassDecoder, IsTwoDegreesOffBetweenTheCardinalPoints) {
  SensingBench bench(listing_compass_decoder_kind);
  EXPECT_NEAR(decode(bench, 2.5 + 0.594 * 0.382683, 2.5 + 0.594 * 0.923880), 65.645, 0.01);  // 67.5 in truth
}

// Row 11: 90 deg errors near 45 and 225 deg at amplitudes of 0.55-0.594 V.
TEST(ListingCompassDecoder, ErrsByNinetyDegreesNearTwoDiagonals) {
  SensingBench bench(listing_compass_decoder_kind);
  EXPECT_NEAR(turn_to(bench, 0.55, 47), 137, 5);
  EXPECT_NEAR(turn_to(bench, 0.55, 227), 317, 5);
  EXPECT_NEAR(turn_to(bench, 0.55, 43), 43, 5);
  EXPECT_NEAR(turn_to(bench, 0.55, 137), 137, 5);
  EXPECT_NEAR(turn_to(bench, 0.55, 317), 317, 5);
  EXPECT_NEAR(turn_to(bench, 0.594, 45.05), 135, 1);
}

// Row 11: 36 deg of unmatched headings at 0.65 V.
TEST(ListingCompassDecoder, MatchesNothingRoundTheDiagonalsOfAStrongSignal) {
  SensingBench bench(listing_compass_decoder_kind);
  int unmatched = 0;
  for (int tenth = 0; tenth < 3600; ++tenth) {
    turn_to(bench, 0.65, tenth / 10.0);
    if (bench.out("matched") == 0) ++unmatched;
  }
  EXPECT_NEAR(unmatched / 10.0, 36, 0.5);
}

TEST(ListingCompassDecoder, HasGoodHabitsOnAnyReadings) {
  testing::expect_good_sensing(listing_compass_decoder_kind, {}, {},
                               [](SensingBench& bench) { ASSERT_LE(std::fabs(bench.out("yaw")), kPi); });
}

}  // namespace
}  // namespace ganglion
