#include "ganglion/sim/simulation/device.h"

#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

using testing::kRoom;

TEST(Device, GivesEachRobotASensorOfItsOwnWhereItRemembers) {
  testing::Trial lagging(kRoom, testing::kFast + "[[sensor]]\nid = \"c\"\nkind = \"Compass\"\nlag_s = 1\n",
                         SpawnPoses{{{{2, 5}, Angle::from_deg(0)}, {{7, 5}, Angle::from_deg(90)}}}, 2);
  lagging.go({0, 0}, 0.1);
  EXPECT_NEAR(lagging.value("c.heading", 0), 0, 1e-9);
  EXPECT_NEAR(lagging.value("c.heading", 1), kPi / 2, 1e-9);
}

}  // namespace
}  // namespace ganglion::sim
