#include "ganglion/sim/sensor/range/range.h"

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::string_view kWorld =
    "format = 1\nname = \"w\"\n[[wall]]\npoints = [[2, -9], [2, 9]]\nmaterial = \"smooth\"\n";

double read(Sensor& range, const Scene& scene) {
  std::array<double, 1> values{};
  Draws draws(StreamId{}, 0);
  range.measure(scene, draws, values);
  return values[0];
}

TEST(Range, ReadsAlongItsRayWhateverTheAngle) {
  Stage stage(kWorld);
  const auto range = made(range_kind);
  EXPECT_NEAR(read(*range, stage.at({})), 2, 1e-12);
  EXPECT_NEAR(read(*range, stage.at({{1, 0}, Angle::from_deg(60)})), 2, 1e-12);  // 1 m / cos 60 deg
}

TEST(Range, MarksNothingInRangeAndTooClose) {
  Stage stage(kWorld);
  const auto range = made(range_kind, {{"min_range_m", 0.1}});
  EXPECT_EQ(read(*range, stage.at({{-1.001, 0}, {}})), kInfinity);
  EXPECT_EQ(read(*range, stage.at({{0, 0}, Angle::from_deg(180)})), kInfinity);
  EXPECT_EQ(read(*range, stage.at({{1.901, 0}, {}})), -kInfinity);
}

TEST(Range, SeesTheNearerOfWallsAndRobots) {
  Stage stage(kWorld);
  stage.others = {{{1, 0.06}, 0.1}, {{3, 0}, 0.1}, {{-0.5, 0}, 0.1}};
  const auto range = made(range_kind);
  EXPECT_NEAR(read(*range, stage.at({})), 0.92, 1e-12);  // 1 - sqrt(0.1^2 - 0.06^2)
}

}  // namespace
}  // namespace ganglion::sim
