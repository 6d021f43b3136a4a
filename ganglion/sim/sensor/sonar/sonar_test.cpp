#include "ganglion/sim/sensor/sonar/sonar.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A wall across the x axis at x = 1, 20 m long, of a material, turned by `turn_deg` about (1, 0).
std::string wall_at_1m(std::string_view material, double turn_deg) {
  const Vector2 along = direction(Angle::from_deg(90 + turn_deg).rad()) * 10;
  return fmt::format("format = 1\nname = \"w\"\n[[wall]]\npoints = [[{}, {}], [{}, {}]]\nmaterial = \"{}\"\n",
                     1 + along.x, along.y, 1 - along.x, -along.y, material);
}

std::array<double, 2> read(Sensor& sonar, const Scene& scene, std::uint32_t tick = 0) {
  std::array<double, 2> values{};
  Draws draws(StreamId{1, 0, 0, 7}, tick);
  sonar.measure(scene, draws, values);
  return values;
}

TEST(Sonar, ReadsTheNearestSurfaceInItsCone) {
  Stage stage(
      "format = 1\nname = \"w\"\n[[disc]]\nx_m = 1.0\ny_m = 0.2\nradius_m = 0.1\n"
      "[[wall]]\npoints = [[2, -9], [2, 9]]\n");
  const auto narrow = made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}, {"rays", 1}});
  EXPECT_NEAR(read(*narrow, stage.at({}))[0], 2, 1e-12);
  // Rays at 0, 6.67, 13.33 and 20 deg: the disc's centre is 1.0198 m off at 11.31 deg, so the ray at 13.33 deg passes
  // it at 1.0198 sin(2.023 deg) = 0.0360 m and meets it at 1.0198 cos(2.023 deg) - sqrt(0.1^2 - 0.0360^2) = 0.92588 m.
  const double off_rad = Angle::from_deg(40.0 / 3).rad() - std::atan2(0.2, 1.0);
  const double centre_m = std::sqrt(1.04);
  const double expected_m = centre_m * std::cos(off_rad) - std::sqrt(0.01 - std::pow(centre_m * std::sin(off_rad), 2));
  EXPECT_NEAR(expected_m, 0.92588, 1e-4);
  const auto wide = made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}});
  EXPECT_NEAR(read(*wide, stage.at({}))[0], expected_m, 1e-9);
}

TEST(Sonar, LosesASmoothWallBeyondItsIncidenceLimit) {
  // One ray: the incidence is the wall's turn. No other surface is there for the mirrored ray.
  const auto sonar = made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}, {"rays", 1}});
  for (const double turn_deg : {0.0, 22.4, -22.4}) {
    Stage stage(wall_at_1m("smooth", turn_deg));
    EXPECT_NEAR(read(*sonar, stage.at({}))[0], 1, 1e-9) << turn_deg;
  }
  for (const double turn_deg : {22.6, -22.6, 60.0}) {
    Stage stage(wall_at_1m("smooth", turn_deg));
    EXPECT_EQ(read(*sonar, stage.at({}))[0], kInfinity) << turn_deg;
    EXPECT_EQ(read(*sonar, stage.at({}))[1], 0.0191) << turn_deg;
  }
}

TEST(Sonar, HearsARoughWallAtAnyAngle) {
  const auto sonar = made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}, {"rays", 1}});
  Stage stage(wall_at_1m("rough", 80));
  EXPECT_NEAR(read(*sonar, stage.at({}))[0], 1, 1e-9);
}

TEST(Sonar, HearsSoftSurfacesOnlyNearby) {
  const auto sonar =
      made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}, {"rays", 1}, {"soft_range", 0.4}});  // of 3 m
  Stage stage(wall_at_1m("soft", 0));
  EXPECT_NEAR(read(*sonar, stage.at({{-0.19, 0}, {}}))[0], 1.19, 1e-9);
  EXPECT_EQ(read(*sonar, stage.at({{-0.21, 0}, {}}))[0], kInfinity);
}

TEST(Sonar, ReadsAPhantomAlongTheMirrorDirection) {
  // A smooth wall at 45 deg turns the ray from +x to +y, where a rough wall stands 0.8 m on: 1.8 m in all.
  const std::string world = wall_at_1m("smooth", -45) + "[[wall]]\npoints = [[0.5, 0.8], [1.5, 0.8]]\n";
  Stage stage(world);
  const auto sonar = made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}, {"rays", 1}});
  EXPECT_NEAR(read(*sonar, stage.at({}))[0], 1.8, 1e-5);
  const auto dull = made(sonar_kind, {{"noise_m", 0}, {"rays", 1}, {"mirror_bounces", 0}});
  EXPECT_EQ(read(*dull, stage.at({}))[0], kInfinity);
}

TEST(Sonar, SaysTooCloseInItsBlindZoneAndNothingBeyondItsReach) {
  Stage stage(wall_at_1m("rough", 0));
  const auto sonar = made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}, {"rays", 1}});
  EXPECT_EQ(read(*sonar, stage.at({{0.981, 0}, {}}))[0], -kInfinity);  // 0.019 < 0.02 m
  EXPECT_EQ(read(*sonar, stage.at({{0.981, 0}, {}}))[1], 115e-6);
  EXPECT_NEAR(read(*sonar, stage.at({{0.979, 0}, {}}))[0], 0.021, 1e-9);
  EXPECT_NEAR(read(*sonar, stage.at({{-1.999, 0}, {}}))[0], 2.999, 1e-9);
  EXPECT_EQ(read(*sonar, stage.at({{-2.001, 0}, {}}))[0], kInfinity);
  const auto clipping = made(sonar_kind, {{"noise_m", 0}, {"rays", 1}, {"too_close", 1}});
  EXPECT_EQ(read(*clipping, stage.at({{0.981, 0}, {}}))[0], 0.02);
}

TEST(Sonar, SeesOtherRobots) {
  Stage stage(wall_at_1m("rough", 0));
  stage.others.push_back({{0.5, 0}, 0.1});
  const auto sonar = made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}});
  EXPECT_NEAR(read(*sonar, stage.at({}))[0], 0.4, 1e-9);
}

TEST(Sonar, ScattersAndRoundsAsStated) {
  Stage stage(wall_at_1m("rough", 0));
  const auto sonar = made(sonar_kind, {{"rays", 1}});  // 1 cm, multiples of 1 mm
  const int count = 4000;
  double sum = 0, squares = 0;
  for (int n = 0; n < count; ++n) {
    const double range_m = read(*sonar, stage.at({}), static_cast<std::uint32_t>(n))[0];
    EXPECT_NEAR(range_m * 1000, std::round(range_m * 1000), 1e-6);
    sum += range_m;
    squares += (range_m - 1) * (range_m - 1);
  }
  // Four standard errors: of the mean 0.01 / sqrt(n), of the deviation 0.01 / sqrt(2 n); rounding adds 0.04 %.
  EXPECT_NEAR(sum / count, 1, 4 * 0.01 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.01, 4 * 0.01 / std::sqrt(2.0 * count) + 1e-5);
}

TEST(Sonar, LosesEchoesAsOftenAsStated) {
  Stage stage(wall_at_1m("rough", 0));
  const auto sonar = made(sonar_kind, {{"rays", 1}, {"dropout", 0.2}});
  int lost = 0;
  for (std::uint32_t n = 0; n < 4000; ++n) lost += std::isinf(read(*sonar, stage.at({}), n)[0]) ? 1 : 0;
  EXPECT_NEAR(lost, 800, 4 * std::sqrt(4000 * 0.2 * 0.8));
}

TEST(Sonar, GivesTheTimeOfTheEchoAtTheTemperatureOfTheAir) {
  Stage stage(wall_at_1m("rough", 0));
  const auto sonar =
      made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}, {"rays", 1}, {"air_C", 0}, {"assumed_C", 20}});
  const auto values = read(*sonar, stage.at({}));
  EXPECT_NEAR(values[1], 2 / 331.3, 1e-12);      // there and back at 331.3 m/s
  EXPECT_NEAR(values[0], 343.42 / 331.3, 1e-9);  // which a device that thinks of 20 deg C takes for 1.0366 m
}

TEST(Sonar, GivesNoPulseOnceBroken) {
  const auto sonar = made(sonar_kind);
  std::array<double, 2> values{1, 1};
  sonar->broken(values);
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_EQ(values[1], 0);
}

TEST(Sonar, HearsTheRimOfItsConeFromNearerWhereEchoesFade) {
  // At the rim, 20 deg off, half the amplitude: heard up to 3 / sqrt 2 = 2.121 m; on the axis up to 3 m.
  const auto disc_at = [](double range_m, double off_deg) {
    const Vector2 centre = direction(Angle::from_deg(off_deg).rad()) * (range_m + 0.05);
    return fmt::format("format = 1\nname = \"w\"\n[[disc]]\nx_m = {}\ny_m = {}\nradius_m = 0.05\n", centre.x, centre.y);
  };
  const auto fading = made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}, {"fading", 1}});
  const auto even = made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}});
  Stage near(disc_at(2.11, 20)), far(disc_at(2.13, 20)), ahead(disc_at(2.99, 0));
  EXPECT_NEAR(read(*fading, near.at({}))[0], 2.11, 1e-9);
  EXPECT_EQ(read(*fading, far.at({}))[0], kInfinity);
  EXPECT_NEAR(read(*even, far.at({}))[0], 2.13, 1e-9);
  EXPECT_NEAR(read(*fading, ahead.at({}))[0], 2.99, 1e-9);
}

TEST(Sonar, TakesTheDefaultsOfItsDeviceButWhatIsGiven) {
  Stage stage(wall_at_1m("rough", 0));
  const auto srf02 = made(sonar_kind, {{"device", 1}, {"noise_m", 0}, {"rays", 1}});
  EXPECT_EQ(srf02->limits(0).min, 0.16);
  EXPECT_EQ(srf02->limits(0).max, 6);
  EXPECT_NEAR(read(*srf02, stage.at({{-2.234, 0}, {}}))[0], 3.23, 1e-9);  // whole centimetres
  EXPECT_EQ(read(*srf02, stage.at({{0.85, 0}, {}}))[0], 0.16);            // 0.15 m: its shortest
  const auto polaroid = made(sonar_kind, {{"device", 2}});
  EXPECT_EQ(polaroid->limits(0).max, 10.7);
  EXPECT_EQ(read(*polaroid, stage.at({{0.6, 0}, {}}))[0], -kInfinity);  // rings
  const auto changed = made(sonar_kind, {{"device", 1}, {"max_range_m", 3}, {"too_close", 0}});
  EXPECT_EQ(changed->limits(0).max, 3);
  EXPECT_EQ(changed->limits(0).min, 0.16);
  EXPECT_EQ(read(*changed, stage.at({{0.85, 0}, {}}))[0], -kInfinity);
}

TEST(Sonar, HearsThePingOfAnotherWhereItMay) {
  // Another sonar sits 0.5 m ahead, 0.5 m from the wall: 0.5 m there and 1 m back are taken for 0.75 m.
  Stage stage(wall_at_1m("rough", 0));
  const Mounting own{}, ahead{{{0.5, 0}, {}}}, turned{{{0.5, 0}, Angle::from_deg(90)}, {0, 1}};
  const auto heard = [&](Sensor& sonar, const Mounting& other) {
    const std::array pings = {Ping{&own, 0.94}, Ping{&other, 0.94}};
    Scene scene = stage.at({});
    scene.mounting = &own;
    scene.pings = pings;
    return read(sonar, scene)[0];
  };
  const auto hears = made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}, {"rays", 1}, {"crosstalk", 1}});
  const auto deaf = made(sonar_kind, {{"noise_m", 0}, {"resolution_m", 0}, {"rays", 1}});
  EXPECT_NEAR(heard(*hears, ahead), 0.75, 1e-5);
  EXPECT_NEAR(heard(*hears, own), 1, 1e-9);     // its own is no other's
  EXPECT_NEAR(heard(*hears, turned), 1, 1e-9);  // pings along the wall
  EXPECT_NEAR(heard(*deaf, ahead), 1, 1e-9);
}

TEST(Sonar, RefusesAReachWithinItsBlindZone) {
  Parameters parameters(sonar_kind.descriptor.parameters);
  parameters.set("min_range_m", 3.5);
  const auto sonar = sonar_kind.make(parameters);
  ASSERT_FALSE(sonar);
  EXPECT_EQ(sonar.error().code, ErrorCode::BadParameter);
}

}  // namespace
}  // namespace ganglion::sim
