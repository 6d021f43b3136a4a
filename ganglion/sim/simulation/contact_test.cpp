// What must be right about contacts before speed counts.
#include <cmath>

#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

using testing::at;
using testing::kFast;
using testing::kRoom;
using testing::Trial;

constexpr double kRadius_m = 0.1;  // of robot_of()

std::string drive(double full_scale_mps, const std::string& more = {}) {
  return fmt::format("[drive]\nkind = \"Differential\"\nfull_scale_mps = {}\ntrack_m = 0.2\n{}", full_scale_mps, more);
}

TEST(Contact, KeepsTheTangentialSpeedAlongAWall) {
  for (const double yaw_deg : {10.0, 30.0, 60.0}) {
    Trial run(kRoom, kFast, at(2, 9.9 - 1e-6, yaw_deg));
    const double x_m = run.truth().pose.position.x;
    run.go({1, 1}, 0.1, 20);
    const double along_m = 2 * std::cos(yaw_deg * kPi / 180);  // 1 m/s for 2 s
    EXPECT_NEAR(run.truth().pose.position.x - x_m, along_m, 0.01 * along_m) << yaw_deg;
  }
}

TEST(Contact, NeverEntersAWallByAMillimetreAtThreeMetresASecond) {
  for (const double step_s : {0.02, 0.1, 0.3}) {
    for (const double yaw_deg : {0.0, 20.0, 45.0, 80.0}) {
      Trial run(kRoom, drive(3), at(5, 5, yaw_deg));
      for (int n = 0; n < 100; ++n) {
        run.go({1, 1}, step_s);
        EXPECT_GE(run.simulation->world().clearance(run.truth().pose.position, 1), kRadius_m - 1e-3);
      }
    }
  }
}

TEST(Contact, LetsARobotTurnAboutAStalledTrack) {
  // The left track stands still: the body turns about its contact line, 0.1 m to the left of the centre, at
  // 1 m/s / 0.2 m = 5 rad/s.
  Trial run(kRoom, drive(1, "left_gain = 0\n"), at(5, 5));
  run.go({1, 1}, 0.1, 3);
  EXPECT_NEAR(run.truth().pose.yaw.rad(), 1.5, 1e-9);
  EXPECT_NEAR(run.truth().pose.position.x, 5 + 0.1 * std::sin(1.5), 1e-9);
  EXPECT_NEAR(run.truth().pose.position.y, 5.1 - 0.1 * std::cos(1.5), 1e-9);
  EXPECT_NEAR(run.truth().travelled_m, 0.15, 1e-9);
}

TEST(Contact, HoldsTwoRobotsThatPushHeadOn) {
  Trial run(kRoom, kFast, SpawnPoses{{{{4, 5}, {}}, {{5, 5}, Angle::from_deg(180)}}}, 2);
  run.go({1, 1}, 0.1, 20);
  // They have met: nothing moves any more, and the gap is closed.
  EXPECT_NEAR(run.truth(1).pose.position.x - run.truth(0).pose.position.x, 2 * kRadius_m, 1e-6);
  const Vector2 first = run.truth(0).pose.position, second = run.truth(1).pose.position;
  run.go({1, 1}, 0.1, 20);
  EXPECT_NEAR((run.truth(0).pose.position - first).length(), 0, 1e-6);
  EXPECT_NEAR((run.truth(1).pose.position - second).length(), 0, 1e-6);
  EXPECT_NEAR(first.x, 4.4, 0.02);  // both as fast: in the middle, up to the order of their sub-steps
}

TEST(Contact, IsTheSameWhetherStepsAreCutOrNot) {
  // On open ground a step is gone at once; a trainer or a lag would cut it. Both end in the same place.
  const std::string watched = "[[sensor]]\nid = \"needle\"\nkind = \"Compass\"\nlag_s = 1\n";
  Trial whole(kRoom, kFast, at(1, 5, 10)), cut(kRoom, kFast + watched, at(1, 5, 10));
  for (int n = 0; n < 60; ++n) {
    for (Trial* run : {&whole, &cut}) run->go({1, n % 10 < 5 ? 0.9 : 1}, 0.1);
    EXPECT_NEAR((whole.truth().pose.position - cut.truth().pose.position).length(), 0, 1e-9);
    EXPECT_NEAR(whole.truth().travelled_m, cut.truth().travelled_m, 1e-5);  // chords of sub-steps are shorter than arcs
    EXPECT_EQ(whole.truth().touching, cut.truth().touching);
    EXPECT_EQ(whole.truth().contacts, cut.truth().contacts);
  }
}

TEST(Contact, IsTheSameInACrowdWhetherStepsAreCutOrNot) {
  // Robots that pass each other closely, turn on the spot beside others, push them and follow the walls.
  const std::string watched = "[[sensor]]\nid = \"needle\"\nkind = \"Compass\"\nlag_s = 1\n";
  std::vector<Pose2> places;
  for (int i = 0; i < 36; ++i)
    places.push_back({{8.3 + 0.3 * (i % 6), 8.3 + 0.3 * (i / 6)}, Angle::from_deg(40.0 * i)});
  Trial whole(kRoom, kFast, SpawnPoses{places}, 36), cut(kRoom, kFast + watched, SpawnPoses{places}, 36);
  int contacts = 0;
  for (int n = 0; n < 8; ++n) {
    for (Trial* run : {&whole, &cut}) {
      for (int i = 0; i < 36; ++i) {
        const double left = i % 3 == 0 ? -0.5 : 0.3 + 0.02 * i, right = i % 3 == 0 ? 0.5 : 0.8 - 0.01 * i;
        run->acts[static_cast<std::size_t>(i)].values = {left, right};
      }
      run->simulation->step(run->acts, 0.1);
    }
    for (int i = 0; i < 36; ++i) {
      EXPECT_NEAR((whole.truth(i).pose.position - cut.truth(i).pose.position).length(), 0, 1e-6) << n << " " << i;
      contacts += whole.truth(i).contacts;
    }
  }
  EXPECT_GT(contacts, 100);
}

}  // namespace
}  // namespace ganglion::sim
