#include "ganglion/sim/simulation/device.h"

#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

using testing::kRoom;
using testing::kSensors;
using testing::Stage;

/// What a sensor reads standing somewhere, after it has been led about or not.
std::vector<double> reading_of(const SensorKind& kind, bool led_about) {
  const auto sensor = testing::made(kind);
  Stage stage(kRoom);
  std::size_t size = 0;
  for (const PortDescriptor& port : kind.descriptor.ports) size += static_cast<std::size_t>(port.size);
  std::vector<double> values(size);
  EXPECT_TRUE(sensor->reset(stage.at({{1, 1}, {}}), Draws(StreamId{}, 0)));
  for (std::uint32_t tick = 1; led_about && tick < 5; ++tick) {
    stage.robot.left_m = stage.robot.right_m = 0.3 * tick;
    const Scene scene = stage.at({{2.0 + tick, 3}, Angle::from_deg(50.0 * tick)}, tick);
    Draws draws(StreamId{}, tick);
    sensor->follow(scene, 0.5);
    sensor->measure(scene, draws, values);
  }
  stage.robot.left_m = stage.robot.right_m = 2;
  Draws draws(StreamId{}, 9);
  sensor->measure(stage.at({{4, 6}, Angle::from_deg(20)}, 9), draws, values);
  return values;
}

TEST(EverySensor, ThatRemembersNothingReadsTheSameWhateverCameBefore) {
  int shared = 0;
  for (const SensorKind* kind : kSensors) {
    if (testing::made(*kind)->remembers()) continue;
    ++shared;
    EXPECT_EQ(reading_of(*kind, true), reading_of(*kind, false)) << kind->descriptor.name;
  }
  EXPECT_GE(shared, 4);
}

TEST(Device, GivesEachRobotASensorOfItsOwnWhereItRemembers) {
  testing::Trial lagging(kRoom, testing::kFast + "[[sensor]]\nid = \"c\"\nkind = \"Compass\"\nlag_s = 1\n",
                         SpawnPoses{{{{2, 5}, Angle::from_deg(0)}, {{7, 5}, Angle::from_deg(90)}}}, 2);
  lagging.go({0, 0}, 0.1);
  EXPECT_NEAR(lagging.value("c.heading", 0), 0, 1e-9);
  EXPECT_NEAR(lagging.value("c.heading", 1), kPi / 2, 1e-9);
}

}  // namespace
}  // namespace ganglion::sim
