#include "ganglion/sim/simulation/spawn.h"

#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

using testing::at;
using testing::kFast;
using testing::kRoom;
using testing::robot_of;
using testing::Trial;

const std::string kFurnished =
    std::string(kRoom) +
    "[[box]]\nx_m = 5\ny_m = 5\nlength_m = 4\nwidth_m = 4\n[[spawn]]\nid = \"door\"\nx_m = 1\ny_m = 2\n"
    "yaw_deg = 90\n";

std::string refusal(const std::string& world, const SpawnRule& rule, int robots = 1) {
  auto made = Simulation::make({testing::ground_of(world), robot_of(kFast), robots, rule});
  if (!made) return made.error().what.en;
  const auto ready = (*made)->reset(1, 0);
  return ready ? "" : ready.error().what.en;
}

TEST(Spawner, DrawsFreePlacesForAllRobots) {
  Trial trial(kFurnished, kFast, SpawnRandom{.clearance_m = 0.2, .yaw = Angle::from_deg(30)}, 40);
  for (int i = 0; i < 40; ++i) {
    const Pose2 pose = trial.truth(i).pose;
    EXPECT_GE(trial.simulation->world().clearance(pose.position, 1), 0.3 - 1e-9);
    EXPECT_NEAR(pose.yaw.deg(), 30, 1e-9);
    for (int j = 0; j < i; ++j) {
      EXPECT_GE((pose.position - trial.truth(j).pose.position).length(), 0.2);
    }
  }
}

TEST(Spawner, DrawsTheYawWhereNoneIsGiven) {
  Trial trial(kRoom, kFast, SpawnRandom{}, 20);
  int left = 0;
  for (int i = 0; i < 20; ++i) left += trial.truth(i).pose.yaw.rad() > 0 ? 1 : 0;
  EXPECT_GT(left, 2);
  EXPECT_LT(left, 18);
}

TEST(Spawner, FindsThePlacesTheWorldNames) {
  Trial trial(kFurnished, kFast, SpawnNamed{"door"});
  EXPECT_EQ(trial.truth().pose.position, (Vector2{1, 2}));
  EXPECT_NEAR(trial.truth().pose.yaw.deg(), 90, 1e-9);
  EXPECT_EQ(trial.truth().start, trial.truth().pose);
  EXPECT_EQ(refusal(kFurnished, SpawnNamed{"dor"}), "the world has no spawn \"dor\"; did you mean \"door\"?");
  EXPECT_EQ(refusal(kFurnished, SpawnNamed{"door"}, 2), "spawn \"door\" is one place, not 2");
}

TEST(Spawner, RefusesPlacesThatAreTaken) {
  EXPECT_EQ(refusal(kFurnished, at(5, 5)),
            "robot 0 of radius 0.1 m cannot start at (5.000, 5.000): something stands there");
  EXPECT_NE(refusal(kFurnished, at(0.09, 5)), "");
  EXPECT_EQ(refusal(kFurnished, at(0.1, 5)), "");
  EXPECT_EQ(refusal(kFurnished, SpawnPoses{{{{1, 1}, {}}, {{1.1, 1}, {}}}}, 2),
            "robot 1 of radius 0.1 m cannot start at (1.100, 1.000): something stands there");
  EXPECT_EQ(refusal(kFurnished, SpawnPoses{}, 2), "there are 0 start poses for 2 robots");
  EXPECT_NE(refusal(kFurnished, SpawnRandom{.clearance_m = 20}), "");
}

}  // namespace
}  // namespace ganglion::sim
