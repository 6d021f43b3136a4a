// Robots driving in a world: motion, commands that lapse, contacts, energy.
#include <cmath>

#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

using testing::at;
using testing::kFast;
using testing::kRoom;
using testing::Trial;

TEST(Simulation, DrivesARobotByItsCommands) {
  Trial run(kRoom, kFast, at(5, 5, 90));
  run.go({0.5, 0.5}, 0.1, 10);
  EXPECT_NEAR(run.truth().pose.position.x, 5, 1e-12);
  EXPECT_NEAR(run.truth().pose.position.y, 5.5, 1e-9);
  EXPECT_NEAR(run.truth().travelled_m, 0.5, 1e-9);
  EXPECT_NEAR(run.truth().velocity_mps.y, 0.5, 1e-9);
  EXPECT_EQ(run.senses[0].tick, 10u);
  EXPECT_NEAR(run.senses[0].time_s, 1, 1e-12);
}

TEST(Simulation, LetsACommandLapseWithinAStep) {
  // Nimrod's listing: pulses of 0.04 s and 0.2 s in a cycle of 1.6 s; the third ends between two sub-steps.
  for (const double pulse_s : {0.04, 0.2, 0.0375, 1.6}) {
    Trial run(kRoom, kFast, at(5, 5));
    run.acts[0].ttl_s[0] = pulse_s;
    run.go({0.5, 0.5}, 1.6);
    EXPECT_NEAR(run.truth().travelled_m, 0.5 * pulse_s, 1e-12) << pulse_s;
    run.go({0.5, 0.5}, 1.6);
    EXPECT_NEAR(run.truth().travelled_m, pulse_s, 1e-12) << pulse_s;
  }
}

TEST(Simulation, TakesNoMotionFromACommandThatCameTooLate) {
  Trial run(kRoom, kFast, at(5, 5));
  run.acts[0].ttl_s[0] = 0;
  run.go({1, 1}, 0.1);
  EXPECT_EQ(run.truth().travelled_m, 0);
}

TEST(Simulation, KeepsNonFiniteAndExcessiveCommandsFromTheDrive) {
  Trial run(kRoom, kFast, at(5, 5));
  run.go({NAN, INFINITY}, 0.1);
  EXPECT_EQ(run.truth().travelled_m, 0);
  run.go({5, 5}, 0.1);
  EXPECT_NEAR(run.truth().travelled_m, 0.1, 1e-12);
}

TEST(Simulation, SlidesARobotAlongAWallWithItsTangentialSpeed) {
  Trial run(kRoom, kFast, at(5, 9.5, 30));
  run.go({1, 1}, 0.1, 10);  // touches after 0.8 s, when 0.4 m were climbed
  EXPECT_NEAR(run.truth().pose.position.y, 9.9, 1e-6);
  EXPECT_TRUE(run.truth().touching);
  const double x_m = run.truth().pose.position.x;
  run.go({1, 1}, 0.1, 10);
  EXPECT_NEAR(run.truth().pose.position.x - x_m, std::cos(kPi / 6), 0.01 * std::cos(kPi / 6));
  EXPECT_NEAR(run.truth().pose.position.y, 9.9, 1e-6);
}

TEST(Simulation, StallsARobotThatPushesHeadOn) {
  Trial run(kRoom, kFast + "[[sensor]]\nid = \"wheels\"\nkind = \"Encoders\"\n", at(9.5, 5));
  run.go({1, 1}, 0.1, 20);
  EXPECT_NEAR(run.truth().pose.position.x, 9.9, 1e-6);
  EXPECT_NEAR(run.truth().pose.position.y, 5, 1e-9);
  EXPECT_NEAR(run.truth().velocity_mps.length(), 0, 1e-6);
  EXPECT_NEAR(run.truth().travelled_m, 0.4, 1e-6);
  EXPECT_NEAR(run.value("wheels.left"), 2, 1e-9);  // its wheels slip
}

TEST(Simulation, NeverPutsAFastRobotInsideAWall) {
  const std::string world = std::string(kRoom) +
                            "[[box]]\nx_m = 5\ny_m = 5\nlength_m = 1\nwidth_m = 0.02\nyaw_deg = 30\n"
                            "[[disc]]\nx_m = 3\ny_m = 6\nradius_m = 0.5\n";
  Problems problems;
  const auto model = parse_robot(
      "format = 1\nname = \"r\"\nsubstep_s = 0.1\n[body]\nlength_m = 0.2\nwidth_m = 0.2\n"
      "radius_m = 0.1\n[drive]\nkind = \"Differential\"\nfull_scale_mps = 3\ntrack_m = 0.2\n",
      "robot.toml", testing::kKinds, problems);
  ASSERT_TRUE(model) << problems.text();
  Trial run(testing::ground_of(world), model, SpawnRandom{.clearance_m = 0.1}, 1);
  double deepest_m = 1;
  for (std::uint32_t episode = 0; episode < 20; ++episode) {
    run.reset(7, episode);
    Draws draws(StreamId{99, episode, 0, 0}, 0);
    for (int n = 0; n < 200; ++n) {
      run.go({draws.uniform(0.3, 1), draws.uniform(0.3, 1)}, 0.1);
      deepest_m = std::min(deepest_m, run.simulation->world().clearance(run.truth().pose.position, 1) - 0.1);
    }
  }
  EXPECT_GE(deepest_m, -1e-9);
  EXPECT_LT(deepest_m, 1e-3);  // it did touch
}

TEST(Simulation, CountsAContactOnceAndTellsHowFastItBegan) {
  Trial run(kRoom, kFast + "[energy]\ndrive_W = 2\nidle_W = 0.5\ncontact_J = 3\n", at(9.5, 5));
  run.go({0.5, 0.5}, 0.1, 7);
  EXPECT_EQ(run.truth().contacts, 0);
  EXPECT_NEAR(*run.senses[0].cost, 0.15, 1e-12);  // (0.5 + 2 * 0.5) W for 0.1 s
  run.go({0.5, 0.5}, 0.1, 2);                     // 0.4 m at 0.5 m/s: 0.8 s
  EXPECT_EQ(run.truth().contacts, 1);
  EXPECT_NEAR(run.truth().fastest_contact_mps, 0.5, 1e-9);
  run.go({0.5, 0.5}, 0.1, 20);
  EXPECT_EQ(run.truth().contacts, 1);
  EXPECT_EQ(run.truth().contact_speed_mps, 0);
  EXPECT_NEAR(run.truth().energy_J, 29 * 0.15 + 3, 1e-9);
  run.go({-0.5, -0.5}, 0.1, 5);
  EXPECT_FALSE(run.truth().touching);
  run.go({0.2, 0.2}, 0.1, 20);
  EXPECT_EQ(run.truth().contacts, 2);
  EXPECT_NEAR(run.truth().fastest_contact_mps, 0.5, 1e-9);
}

TEST(Simulation, TellsOnlyTheNormalPartOfAnApproach) {
  Trial run(kRoom, kFast, at(5, 9.5, 30));
  run.go({1, 1}, 0.1, 10);
  EXPECT_EQ(run.truth().contacts, 1);
  EXPECT_NEAR(run.truth().fastest_contact_mps, 0.5, 1e-9);  // 1 m/s * sin 30 deg
}

TEST(Simulation, KeepsTouchingWhileARobotRestsAtAWall) {
  Trial run(kRoom, kFast + "[[sensor]]\nid = \"skin\"\nkind = \"Bumper\"\n", at(9.8, 5));
  EXPECT_EQ(run.value("skin.contact"), 0);
  run.go({1, 1}, 0.1, 3);
  EXPECT_EQ(run.value("skin.contact"), 1);
  run.go({0, 0}, 0.1, 3);
  EXPECT_EQ(run.value("skin.contact"), 1);
  run.go({-1, -1}, 0.1, 2);
  EXPECT_EQ(run.value("skin.contact"), 0);
}

TEST(Simulation, ReturnsASteppingRobotThatTouchedSomething) {
  const std::string world = std::string(kRoom) + "[[box]]\nx_m = 1.25\ny_m = 0.25\nlength_m = 0.5\nwidth_m = 0.5\n";
  Trial run(world, "[drive]\nkind = \"Stepper\"\n[[sensor]]\nid = \"skin\"\nkind = \"Bumper\"\n", at(0.75, 0.25));
  run.go({1, 0}, 1);
  EXPECT_NEAR(run.truth().pose.position.x, 0.75, 1e-9);
  EXPECT_NEAR(run.truth().pose.position.y, 0.25, 1e-9);
  EXPECT_NEAR(run.truth().pose.yaw.rad(), 0, 1e-9);
  EXPECT_TRUE(run.truth().touched);
  EXPECT_EQ(run.value("skin.contact"), 1);
  EXPECT_EQ(run.truth().contacts, 1);
  run.go({-1, kPi}, 1);
  EXPECT_NEAR(run.truth().pose.position.x, 0.25, 1e-9);
  EXPECT_NEAR(run.truth().pose.position.y, 0.25, 1e-9);
  EXPECT_FALSE(run.truth().touched);
  EXPECT_EQ(run.value("skin.contact"), 0);
}

}  // namespace
}  // namespace ganglion::sim
