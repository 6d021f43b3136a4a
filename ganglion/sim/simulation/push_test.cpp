// Robots that run into each other: who pushes whom, how far, and what they feel of it. Numbers by hand: the ways
// nearest to the wanted ones on which nothing overlaps.
#include <cmath>

#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

using testing::kFast;
using testing::kRoom;
using testing::Trial;

constexpr double kRadius_m = 0.1;  // of robot_of(); kFast goes at 1 m/s

/// One duty for both wheels of each robot, for a number of steps.
void drive(Trial& run, const std::vector<double>& duties, int steps, double step_s = 0.1) {
  for (std::size_t i = 0; i < duties.size(); ++i) run.acts[i].values = {duties[i], duties[i]};
  for (int n = 0; n < steps; ++n) {
    run.simulation->step(run.acts, step_s);
    run.simulation->sense(run.senses);
  }
}

Trial trial(const std::vector<Pose2>& poses, const std::string& robot = kFast) {
  return {kRoom, robot, SpawnPoses{poses}, static_cast<int>(poses.size())};
}

Pose2 pose(double x_m, double y_m, double yaw_deg = 0) { return {{x_m, y_m}, Angle::from_deg(yaw_deg)}; }

TEST(Push, MovesAStandingRobotAtHalfTheSpeed) {
  for (const double yaw_deg : {0.0, 180.0, 90.0, 37.0}) {  // from behind, head-on, from the side, at an angle
    Trial run = trial({pose(2, 5), pose(3, 5, yaw_deg)});
    drive(run, {1, 0}, 10);  // 0.8 m alone, then they touch
    const double x_m = run.truth(1).pose.position.x;
    drive(run, {1, 0}, 20);
    EXPECT_NEAR(run.truth(1).pose.position.x - x_m, 1, 0.01) << yaw_deg;  // 0.5 m/s for 2 s
    EXPECT_NEAR(run.truth(1).pose.position.x - run.truth(0).pose.position.x, 2 * kRadius_m, 1e-6);
    EXPECT_NEAR(run.truth(1).velocity_mps.x, 0.5, 0.005);
    EXPECT_NEAR(run.truth(1).pose.position.y, 5, 1e-9);
    EXPECT_NEAR(run.truth(1).pose.yaw.wrapped().deg(), Angle::from_deg(yaw_deg).wrapped().deg(), 1e-9);
  }
}

TEST(Push, IsFeltByBothAndCountedOnce) {
  const std::string wheels =
      "[[sensor]]\nid = \"skin\"\nkind = \"Bumper\"\n[[sensor]]\nid = \"w\"\nkind = \"Encoders\"\n";
  Trial run = trial({pose(2, 5), pose(3, 5)}, kFast + wheels);
  drive(run, {1, 0}, 7);
  EXPECT_EQ(run.value("skin.contact", 0), 0);
  drive(run, {1, 0}, 13);
  for (const int robot : {0, 1}) {
    EXPECT_EQ(run.value("skin.contact", robot), 1);
    EXPECT_EQ(run.truth(robot).contacts, 1);
    EXPECT_NEAR(run.truth(robot).fastest_contact_mps, 1, 1e-9);
  }
  EXPECT_NEAR(run.value("w.left", 0), 2, 1e-9);  // slips
  EXPECT_EQ(run.value("w.left", 1), 0);          // slides with its wheels held
}

TEST(Push, IsNoLongerFeltOnceTheOtherHasGone) {
  // A needle that lags has every step cut into sub-steps; without it steps are gone at once where that can be.
  for (const char* needle : {"", "[[sensor]]\nid = \"needle\"\nkind = \"Compass\"\nlag_s = 1\n"}) {
    Trial run = trial({pose(2, 5), pose(2.5, 5)}, kFast + needle);
    drive(run, {1, 0}, 5);
    EXPECT_TRUE(run.truth(1).touching);
    drive(run, {0, 0}, 2);  // both stand, side by side
    EXPECT_TRUE(run.truth(0).touching);
    EXPECT_TRUE(run.truth(1).touching);
    drive(run, {-1, 0}, 3);
    EXPECT_FALSE(run.truth(0).touching);
    EXPECT_FALSE(run.truth(1).touching);
  }
}

TEST(Push, GivesARobotThatIsOvertakenTheMeanOfBothSpeeds) {
  Trial run = trial({pose(2, 5), pose(2.5, 5)});
  drive(run, {1, 0.4}, 10);
  const double x_m = run.truth(1).pose.position.x;
  drive(run, {1, 0.4}, 20);
  EXPECT_NEAR(run.truth(1).pose.position.x - x_m, 1.4, 0.014);  // (1 + 0.4) / 2 m/s
  EXPECT_EQ(run.truth(1).contacts, 1);
  EXPECT_NEAR(run.truth(1).fastest_contact_mps, 0.6, 1e-9);  // they come together no faster
}

TEST(Push, IsSharedByAllOfARow) {
  Trial run = trial({pose(2, 5), pose(2.3, 5), pose(2.6, 5)});
  drive(run, {1, 0, 0}, 10);
  const double x_m = run.truth(2).pose.position.x;
  drive(run, {1, 0, 0}, 30);
  EXPECT_NEAR(run.truth(2).pose.position.x - x_m, 1, 0.01);  // a third of 1 m/s for 3 s
  drive(run, {1, 1, 0}, 1);
  EXPECT_NEAR(run.truth(2).velocity_mps.x, 2.0 / 3, 0.01);
  EXPECT_NEAR(run.truth(0).velocity_mps.x, 2.0 / 3, 0.01);
}

TEST(Push, GoesAlongTheLineBetweenTheTwo) {
  // The other stands 30 deg to the left, touching: along that line one wants cos 30, each gets half.
  const Vector2 line = direction(kPi / 6);
  Trial run = trial({pose(5, 5), {Vector2{5, 5} + line * (2 * kRadius_m), {}}});
  drive(run, {1, 0}, 1, 0.001);
  const double along_mps = std::cos(kPi / 6) / 2;
  EXPECT_NEAR(run.truth(1).velocity_mps.x, along_mps * line.x, 0.005);
  EXPECT_NEAR(run.truth(1).velocity_mps.y, along_mps * line.y, 0.005);
  EXPECT_NEAR(run.truth(0).velocity_mps.x, 1 - along_mps * line.x, 0.005);
  EXPECT_NEAR(run.truth(0).velocity_mps.y, -along_mps * line.y, 0.005);
}

TEST(Push, EndsAtAWall) {
  const std::string racer = "[drive]\nkind = \"Differential\"\nfull_scale_mps = 3\ntrack_m = 0.2\n";
  for (const double step_s : {0.02, 0.1, 0.3}) {
    Trial run = trial({pose(7, 5), pose(8, 5, 90)}, racer);
    for (double time_s = 0; time_s < 3; time_s += step_s) {
      drive(run, {1, 0}, 1, step_s);
      EXPECT_LE(run.truth(1).pose.position.x, 9.9 + 1e-3);
    }
    EXPECT_NEAR(run.truth(1).pose.position.x, 9.9, 1e-3);
    EXPECT_NEAR(run.truth(0).pose.position.x, 9.7, 1e-3);
    EXPECT_NEAR(run.truth(0).velocity_mps.length(), 0, 1e-6);
    EXPECT_NEAR(run.truth(1).velocity_mps.length(), 0, 1e-6);
    EXPECT_EQ(run.truth(1).contacts, 2);  // one by the robot, one with the wall
    EXPECT_NEAR(run.truth(1).fastest_contact_mps, 3, 1e-6);
  }
}

TEST(Push, LetsTheWeakerPartOfARowStandAtAWall) {
  Trial run = trial({pose(9.3, 5), pose(9.5, 5), pose(9.7, 5)});
  drive(run, {1, 0, 0}, 20);
  EXPECT_NEAR(run.truth(2).pose.position.x, 9.9, 1e-6);
  EXPECT_NEAR(run.truth(1).pose.position.x, 9.7, 1e-6);
  EXPECT_NEAR(run.truth(0).pose.position.x, 9.5, 1e-6);
  drive(run, {-1, 0, 0}, 5);  // and lets go of the others
  EXPECT_NEAR(run.truth(0).pose.position.x, 9, 1e-6);
  EXPECT_NEAR(run.truth(1).pose.position.x, 9.7, 1e-6);
}

TEST(Push, DoesNotDependOnTheOrderOfTheRobots) {
  const std::vector<Pose2> poses = {pose(4, 5), pose(4.5, 5.05, 180), pose(5, 4.9, 120), pose(4.3, 5.5, -90)};
  const std::vector<double> duties = {1, 0.5, 0, 0.8};
  const std::vector<std::size_t> order = {2, 0, 3, 1};
  Trial run = trial(poses), other = trial({poses[2], poses[0], poses[3], poses[1]});
  for (int n = 0; n < 10; ++n) {
    drive(run, duties, 1);
    drive(other, {duties[2], duties[0], duties[3], duties[1]}, 1);
    for (std::size_t i = 0; i < 4; ++i) {
      const Truth &one = run.truth(static_cast<int>(order[i])), &same = other.truth(static_cast<int>(i));
      EXPECT_NEAR((one.pose.position - same.pose.position).length(), 0, 1e-6) << "robot " << order[i] << " step " << n;
      EXPECT_EQ(one.contacts, same.contacts);
    }
  }
}

TEST(Push, NeverMakesABodyEnterAnother) {
  const std::string pen = "format = 1\n[[wall]]\npoints = [[0, 0], [1.2, 0], [1.2, 1.2], [0, 1.2]]\nclosed = true\n";
  const std::string racer = "[drive]\nkind = \"Differential\"\nfull_scale_mps = 3\ntrack_m = 0.2\n";
  Trial run(pen, racer, SpawnRandom{.clearance_m = 0.001}, 10);
  Draws draws(StreamId{5, 0, 0, 0}, 0);
  for (int n = 0; n < 300; ++n) {
    for (ActFrame& act : run.acts) act.values = {draws.uniform(-1, 1), draws.uniform(-1, 1)};
    run.simulation->step(run.acts, 0.1);
    for (int i = 0; i < 10; ++i) {
      const Vector2 at = run.truth(i).pose.position;
      ASSERT_GE(run.simulation->world().clearance(at, 1), kRadius_m - 1e-6) << "robot " << i << " step " << n;
      for (int k = 0; k < i; ++k)
        ASSERT_GE((run.truth(k).pose.position - at).length(), 2 * kRadius_m - 1e-6) << i << " and " << k;
    }
  }
}

TEST(Push, LeavesRobotsThatGoByPlacesWhereTheyAre) {
  Trial run(kRoom, "[drive]\nkind = \"Stepper\"\n[[sensor]]\nid = \"skin\"\nkind = \"Bumper\"\n",
            SpawnPoses{{pose(0.75, 0.25), pose(1.25, 0.25)}}, 2);
  run.acts[0].values = {1, 0};
  run.acts[1].values = {0, 0};
  run.simulation->step(run.acts, 1);
  run.simulation->sense(run.senses);
  EXPECT_NEAR(run.truth(0).pose.position.x, 0.75, 1e-9);  // came back
  EXPECT_EQ(run.truth(1).pose.position.x, 1.25);
  EXPECT_EQ(run.value("skin.contact", 0), 1);
  EXPECT_EQ(run.value("skin.contact", 1), 1);
}

}  // namespace
}  // namespace ganglion::sim
