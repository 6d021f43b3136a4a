#include "ganglion/sim/sensor/gps/gps.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

enum Value { kX, kY, kLatitude, kLongitude, kAltitude, kCourse, kSpeed, kUtc, kFix, kValues };
using Fix = std::array<double, kValues>;

const std::initializer_list<std::pair<std::string_view, double>> kExact = {
    {"latitude_deg", 45}, {"longitude_deg", 10}, {"altitude_m", 0},        {"noise_m", 0},
    {"drift_m", 0},       {"utc_s", 1000},       {"velocity_noise_mps", 0}};

Fix read(Sensor& gps, const Scene& scene, std::uint32_t tick = 0) {
  Fix values{};
  Draws draws(StreamId{3, 0, 0, 9}, tick);
  gps.measure(scene, draws, values);
  return values;
}

// At 45 deg WGS 84 has a meridian radius of 6,367,381.8 m and a prime vertical one of 6,388,838.3 m (sin^2 = 1/2: N = a
// / sqrt(1 - e^2 / 2), M = N (1 - e^2) / (1 - e^2 / 2)): 111,131.8 m a degree of latitude, 78,846.8 m of longitude.
TEST(Gps, GivesDegreesOfTheEarth) {
  Stage stage;
  const auto gps = made(gps_kind, kExact);
  const Fix fix = read(*gps, stage.at({{788.468, 1111.318}, {}}, 5));
  EXPECT_NEAR(fix[kX], 788.468, 1e-9);
  EXPECT_NEAR(fix[kY], 1111.318, 1e-9);
  EXPECT_NEAR(fix[kLatitude], 45.01, 1e-7);
  EXPECT_NEAR(fix[kLongitude], 10.01, 1e-7);
  EXPECT_EQ(fix[kAltitude], 0);
  EXPECT_EQ(fix[kUtc], 1005);
  EXPECT_EQ(fix[kFix], 1);
}

TEST(Gps, KnowsWhereNorthIs) {
  Stage stage;
  const auto gps = made(gps_kind, {{"latitude_deg", 45},
                                   {"longitude_deg", 179.995},
                                   {"altitude_m", 0},
                                   {"noise_m", 0},
                                   {"drift_m", 0},
                                   {"north_deg", 0}});
  const Fix fix = read(*gps, stage.at({{1111.318, -788.468}, {}}));  // north is x, east is -y
  EXPECT_NEAR(fix[kLatitude], 45.01, 1e-7);
  EXPECT_NEAR(fix[kLongitude], -179.995, 1e-7);  // past the date line
}

TEST(Gps, GivesCourseAndSpeedOfItsAntenna) {
  Stage stage;
  const auto gps = made(gps_kind, kExact);
  stage.robot.velocity_mps = {0, 0.5};
  const Fix fix = read(*gps, stage.at({}));
  EXPECT_NEAR(fix[kCourse], kPi / 2, 1e-12);
  EXPECT_NEAR(fix[kSpeed], 0.5, 1e-12);
  stage.robot.velocity_mps = {};
  stage.robot.turn_rate_radps = 1;
  Scene scene = stage.at({});
  const Mounting ahead{{{0.2, 0}, {}}};
  scene.mounting = &ahead;  // ahead of the centre: turning left carries it to the left
  const Fix turning = read(*gps, scene);
  EXPECT_NEAR(turning[kSpeed], 0.2, 1e-12);
  EXPECT_NEAR(turning[kCourse], kPi / 2, 1e-12);
}

TEST(Gps, HasNoCourseWhenSlow) {
  Stage stage;
  const auto gps = made(gps_kind, kExact);
  stage.robot.velocity_mps = {0.09, 0};
  const Fix fix = read(*gps, stage.at({}));
  EXPECT_TRUE(std::isnan(fix[kCourse]));
  EXPECT_NEAR(fix[kSpeed], 0.09, 1e-12);
}

TEST(Gps, GivesTheHeightOfASlope) {
  Stage stage(
      "format = 1\nname = \"w\"\n[[floor]]\nx_m = 5\ny_m = 0\nlength_m = 10\nwidth_m = 4\nslope_deg = 45\n"
      "height_m = 1\n");
  const auto gps = made(gps_kind, kExact);
  EXPECT_NEAR(read(*gps, stage.at({{3, 0}, {}}))[kAltitude], 4, 1e-9);  // 1 m at x = 0, 1 m up for each metre
  EXPECT_EQ(read(*gps, stage.at({{-3, 0}, {}}))[kAltitude], 0);
}

TEST(Gps, ScattersAsStated) {
  Stage stage;
  const auto gps = made(gps_kind, {{"drift_m", 0}, {"altitude_m", 0}});  // 0.5 m, 0.05 m/s
  const int count = 4000;
  double x = 0, squares = 0, up = 0, speed = 0;
  for (int n = 0; n < count; ++n) {
    const Fix fix = read(*gps, stage.at({}), static_cast<std::uint32_t>(n));
    x += fix[kX];
    squares += fix[kY] * fix[kY];
    up += fix[kAltitude] * fix[kAltitude];
    speed += fix[kSpeed] * fix[kSpeed];
  }
  // Four standard errors: of a mean s / sqrt(n), of a deviation s / sqrt(2 n).
  EXPECT_NEAR(x / count, 0, 4 * 0.5 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.5, 4 * 0.5 / std::sqrt(2.0 * count));
  EXPECT_NEAR(std::sqrt(up / count), 0.75, 4 * 0.75 / std::sqrt(2.0 * count));
  // Both ways together: E v^2 = 2 s^2, of deviation 2 s^2 (exponential).
  EXPECT_NEAR(speed / count, 2 * 0.0025, 4 * 2 * 0.0025 / std::sqrt(count));
}

TEST(Gps, DriftsSlowlyAndStaysBounded) {
  Stage stage;
  const auto gps = made(gps_kind, {{"noise_m", 0}});  // 1.5 m, 120 s
  ASSERT_TRUE(gps->reset(stage.at({}), Draws(StreamId{}, 0)));
  const int count = 20000;
  const double step_s = 12;  // a tenth of the correlation time
  double squares = 0, products = 0, last = 0, largest = 0;
  for (int n = 1; n <= count; ++n) {
    const double x = read(*gps, stage.at({}, n * step_s), static_cast<std::uint32_t>(n))[kX];
    squares += x * x;
    products += x * last;
    last = x;
    largest = std::max(largest, std::fabs(x));
  }
  // Neighbours correlate by e^-0.1 = 0.9048. Squares correlate by e^-0.2, which leaves n (1 - e^-0.2) / (1 + e^-0.2) =
  // 0.0997 n independent ones: the deviation's standard error is s / sqrt(2 * 0.0997 n).
  EXPECT_NEAR(std::sqrt(squares / count), 1.5, 4 * 1.5 / std::sqrt(2 * 0.0997 * count));
  EXPECT_NEAR(products / squares, 0.9048, 4 * std::sqrt((1 - 0.8187) / count));  // of an AR(1)'s coefficient
  EXPECT_LT(largest, 6 * 1.5);
}

TEST(Gps, DriftsTheSameHoweverOftenItFires) {
  Stage stage;
  const auto gps = made(gps_kind, {{"noise_m", 0}});
  double products = 0;
  const int count = 4000;
  for (std::uint32_t n = 0; n < count; ++n) {
    ASSERT_TRUE(gps->reset(stage.at({}), Draws(StreamId{n, 0, 0, 1}, 0)));
    double first = 0, x = 0;
    for (std::uint32_t k = 0; k <= 10; ++k) {  // 120 s in ten steps
      Draws draws(StreamId{n, 0, 0, 2}, k);
      Fix fix{};
      gps->measure(stage.at({}, 12.0 * k), draws, fix);
      x = fix[kX];
      if (k == 0) first = x;
    }
    products += first * x;
  }
  // Covariance s^2 / e; the product's own deviation is s^2 sqrt(1 + e^-2) = 1.065 s^2.
  EXPECT_NEAR(products / count, 2.25 / std::exp(1), 4 * 2.25 * 1.065 / std::sqrt(count));
}

TEST(Gps, LosesItsFixInSpells) {
  Stage stage;
  const auto gps = made(gps_kind, {{"lost_every_s", 30}, {"lost_for_s", 10}});
  ASSERT_TRUE(gps->reset(stage.at({}), Draws(StreamId{}, 0)));
  int lost = 0, spells = 0;
  bool before = false;
  const int count = 40000;  // seconds
  for (int n = 1; n <= count; ++n) {
    const Fix fix = read(*gps, stage.at({}, n), static_cast<std::uint32_t>(n));
    const bool now = fix[kFix] == 0;
    for (const int value : {kX, kY, kLatitude, kLongitude, kAltitude, kSpeed}) {
      ASSERT_EQ(std::isnan(fix[static_cast<std::size_t>(value)]), now);
    }
    ASSERT_FALSE(std::isnan(fix[kUtc]));
    lost += now ? 1 : 0;
    spells += now && !before ? 1 : 0;
    before = now;
  }
  // A quarter of the time: 40 s from one spell to the next. Seconds correlate by e^-(1/30 + 1/10) = 0.8752, so there
  // are n (1 - 0.8752) / (1 + 0.8752) = 0.0666 n independent ones. Seen once a second, a spell begins with probability
  // 3/4 * 1/4 * (1 - 0.8752) = 0.0234; the count's variance is below that of independent seconds.
  EXPECT_NEAR(lost / 40000.0, 0.25, 4 * std::sqrt(0.25 * 0.75 / (0.0666 * count)));
  EXPECT_NEAR(spells / 40000.0, 0.0234, 4 * std::sqrt(0.0234 / count));
}

TEST(Gps, RepeatsItselfForTheSameSeedOnly) {
  Stage stage;
  const auto gps = made(gps_kind), twin = made(gps_kind);
  ASSERT_TRUE(gps->reset(stage.at({}), Draws(StreamId{1, 0, 0, 5}, 0)));
  ASSERT_TRUE(twin->reset(stage.at({}), Draws(StreamId{1, 0, 0, 5}, 0)));
  EXPECT_EQ(read(*gps, stage.at({}, 1))[kX], read(*twin, stage.at({}, 1))[kX]);
  ASSERT_TRUE(twin->reset(stage.at({}), Draws(StreamId{2, 0, 0, 5}, 0)));
  EXPECT_NE(read(*gps, stage.at({}, 1))[kX], read(*twin, stage.at({}, 1))[kX]);
}

}  // namespace
}  // namespace ganglion::sim
