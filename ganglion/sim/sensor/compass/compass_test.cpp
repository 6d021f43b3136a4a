#include "ganglion/sim/sensor/compass/compass.h"

#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;
using testing::turned;

double read_deg(Sensor& compass, const Scene& scene, std::uint32_t tick = 0) {
  std::array<double, 1> values{};
  Draws draws(StreamId{}, tick);
  compass.measure(scene, draws, values);
  return Angle::from_rad(values[0]).deg();
}

TEST(Compass, TellsTheYaw) {
  Stage stage;
  const auto compass = made(compass_kind);
  EXPECT_NEAR(read_deg(*compass, stage.at(turned(-120))), -120, 1e-12);
}

TEST(Compass, WrapsWhatItsBiasAdds) {
  Stage stage;
  const auto compass = made(compass_kind, {{"bias_deg", 20}});
  EXPECT_NEAR(read_deg(*compass, stage.at(turned(170))), -170, 1e-9);
}

TEST(Compass, LagsBehindAQuickTurn) {
  Stage stage;
  const auto compass = made(compass_kind, {{"lag_s", 1}});
  ASSERT_TRUE(compass->reset(stage.at(turned(0)), Draws(StreamId{}, 0)));
  for (int n = 0; n < 100; ++n) compass->follow(stage.at(turned(90)), 0.01);
  // After one time constant the needle is (e^-1, 1 - e^-1): atan2(0.63212, 0.36788) = 59.80 deg.
  EXPECT_NEAR(read_deg(*compass, stage.at(turned(90))), 59.80, 0.01);
}

TEST(Compass, RoundsToItsSteps) {
  Stage stage;
  const auto compass = made(compass_kind, {{"resolution_deg", 0.1}});
  EXPECT_NEAR(read_deg(*compass, stage.at(turned(12.34))), 12.3, 1e-9);
}

TEST(Compass, ScattersAsStated) {
  Stage stage;
  const auto compass = made(compass_kind, {{"noise_deg", 2}});
  double squares = 0;
  for (std::uint32_t n = 0; n < 4000; ++n) squares += std::pow(read_deg(*compass, stage.at(turned(0)), n), 2);
  EXPECT_NEAR(std::sqrt(squares / 4000), 2, 4 * 2 / std::sqrt(8000.0));
}

TEST(Compass, IsBentByThePlace) {
  Stage stage;
  const auto compass = made(compass_kind, {{"local_bias_deg", 3.5}, {"local_length_m", 8}});
  EXPECT_NEAR(read_deg(*compass, stage.at({{2, 0}, {}})), 3.5, 1e-9);  // a quarter of the period
  EXPECT_NEAR(read_deg(*compass, stage.at({{2, 4}, {}})), -3.5, 1e-9);
  EXPECT_NEAR(read_deg(*compass, stage.at({{4, 0}, {}})), 0, 1e-9);
}

}  // namespace
}  // namespace ganglion::sim
