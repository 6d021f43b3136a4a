#include "ganglion/sim/sensor/pixel_matrix/pixel_matrix.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

using Picture = std::array<double, 64>;

Picture read(Sensor& camera, const Scene& scene, std::uint32_t tick = 0) {
  Picture values{};
  Draws draws(StreamId{2, 0, 0, 4}, tick);
  camera.measure(scene, draws, values);
  return values;
}

/// Seen from the origin without noise or rounding. Rows look 8 deg apart, at -8, 0, 8... 48 deg below the horizon.
Picture seen(const std::string& world, std::initializer_list<std::pair<std::string_view, double>> more = {},
             double yaw_deg = 0) {
  Stage stage("format = 1\nname = \"w\"\n" + world);
  Parameters parameters(pixel_matrix_kind.descriptor.parameters);
  parameters.set("noise", 0);
  parameters.set("levels", 0);
  for (const auto& [name, value] : more) parameters.set(name, value);
  auto camera = pixel_matrix_kind.make(parameters);
  EXPECT_TRUE(camera);
  return read(**camera, stage.at({{0, 0}, Angle::from_deg(yaw_deg)}));
}

double pixel(const Picture& picture, int row, int column) {
  return picture[static_cast<std::size_t>(row * 8 + column)];
}

const std::string kWall = "[[wall]]\npoints = [[1, -9], [1, 9]]\n";

TEST(PixelMatrix, SeesFloorBelowTheWallsFoot) {
  // With down 20 and 64 deg over 8 rows the middles lie at -8, 0, 8, 16 ... 48 deg. The wall's foot, 0.2 m below and 1
  // m off, lies 11.3 deg down in the middle; 4 deg aside the wall stands at 1 / cos 4 deg.
  const Picture picture = seen(kWall);
  const double wall = 0.5 * (1 + std::cos(Angle::from_deg(4).rad())) / 2;
  EXPECT_NEAR(pixel(picture, 0, 3), wall, 1e-12);
  EXPECT_NEAR(pixel(picture, 2, 4), wall, 1e-12);
  EXPECT_NEAR(pixel(picture, 3, 4), 0.5, 1e-12);  // plain floor
  EXPECT_NEAR(pixel(picture, 7, 0), 0.5, 1e-12);
}

TEST(PixelMatrix, SeesNothingAboveTheWallsOrFarAway) {
  const Picture low = seen(kWall, {{"wall_height_m", 0.3}});
  EXPECT_EQ(pixel(low, 0, 3), 0);    // 8 deg up, 1 m off: 0.34 m
  EXPECT_GT(pixel(low, 1, 3), 0.4);  // level: 0.2 m
  EXPECT_EQ(pixel(seen(kWall, {{"reach_m", 0.9}}), 1, 3), 0);
  EXPECT_EQ(pixel(seen("", {}), 2, 3), 0.5);  // 8 deg down meets the floor 1.42 m off
  EXPECT_EQ(pixel(seen("", {}), 1, 3), 0);
}

TEST(PixelMatrix, TellsMaterialsApart) {
  EXPECT_NEAR(pixel(seen(kWall + "material = \"smooth\"\n"), 0, 3) / pixel(seen(kWall), 0, 3), 1.6, 1e-12);
  EXPECT_NEAR(pixel(seen(kWall + "material = \"soft\"\n"), 0, 3) / pixel(seen(kWall), 0, 3), 0.6, 1e-12);
}

TEST(PixelMatrix, SeesTheColoursOfTheFloorThroughItsFilter) {
  // A red patch on the left: row 7 looks 0.2 / tan 48 deg = 0.180 m ahead.
  const std::string patch = "[[floor]]\nx_m = 0.2\ny_m = 0.5\nlength_m = 1\nwidth_m = 1\ncolour = \"#ff0000\"\n";
  EXPECT_NEAR(pixel(seen(patch), 7, 0), 0.2126, 1e-12);
  EXPECT_EQ(pixel(seen(patch), 7, 7), 0.5);
  EXPECT_EQ(pixel(seen(patch, {{"filter", 1}}), 7, 0), 1);
  EXPECT_EQ(pixel(seen(patch, {{"filter", 2}}), 7, 0), 0);
  EXPECT_EQ(pixel(seen(patch, {{"filter", 1}}, 180), 7, 7), 1);  // turned round it lies on the right
}

const std::string kBeacon = "[[beacon]]\nid = \"b\"\nx_m = 2\ny_m = 0.5\nlight_range_m = 5\nheight_m = 0.2\n";

TEST(PixelMatrix, SeesABeaconInThePixelItLiesIn) {
  // 14.04 deg to the left: column floor((0.5 - 14.04 / 64) 8) = 2; level with the lens, so 20 deg above the middle: row
  // floor((0.5 - 20 / 64) 8) = 1.
  const Picture picture = seen(kBeacon);
  EXPECT_EQ(pixel(picture, 1, 2), 1);
  for (int n = 0; n < 64; ++n) {
    if (n != 1 * 8 + 2) {
      EXPECT_LT(picture[static_cast<std::size_t>(n)], 0.6);
    }
  }
}

TEST(PixelMatrix, DoesNotSeeABeaconBehindAWallOrTooFarAway) {
  EXPECT_LT(pixel(seen(kWall + kBeacon), 1, 2), 0.6);
  const std::string dim = "[[beacon]]\nid = \"b\"\nx_m = 2\ny_m = 0.5\nlight_range_m = 2\nheight_m = 0.2\n";
  EXPECT_EQ(pixel(seen(dim), 1, 2), 0);  // 2.06 m off
}

TEST(PixelMatrix, ScattersAndRoundsAsStated) {
  Stage stage("format = 1\nname = \"w\"\n" + kWall);
  const auto fine = made(pixel_matrix_kind, {{"levels", 0}});  // 0.02
  const int count = 1000;
  double sum = 0, squares = 0;
  for (int n = 0; n < count; ++n) {
    const Picture picture = read(*fine, stage.at({}), static_cast<std::uint32_t>(n));
    for (int column = 0; column < 8; ++column) {  // the lowest row, floor throughout
      sum += pixel(picture, 7, column) - 0.5;
      squares += std::pow(pixel(picture, 7, column) - 0.5, 2);
    }
  }
  EXPECT_NEAR(sum / (8 * count), 0, 4 * 0.02 / std::sqrt(8 * count));
  EXPECT_NEAR(std::sqrt(squares / (8 * count)), 0.02, 4 * 0.02 / std::sqrt(16.0 * count));
  const auto coarse = made(pixel_matrix_kind, {{"levels", 2}});
  for (const double value : read(*coarse, stage.at({}))) EXPECT_TRUE(value == 0 || value == 1);
}

}  // namespace
}  // namespace ganglion::sim
