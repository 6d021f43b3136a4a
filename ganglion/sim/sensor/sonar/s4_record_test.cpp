// Figure 15 of the Carlitos paper in kind: sonar S4, which looks to the right, against time.
#include <cmath>

#include "ganglion/sim/robot/testing/stage.h"
#include "ganglion/sim/sensor/sonar/sonar.h"

namespace ganglion::sim {
namespace {

using testing::made;
using testing::Stage;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A corridor: smooth on the right, y = 0; rough on the left, y = 1.5 m.
constexpr std::string_view kCorridor =
    "format = 1\nname = \"w\"\n[[wall]]\npoints = [[-30, 0], [30, 0]]\nmaterial = \"smooth\"\n"
    "[[wall]]\npoints = [[-30, 1.5], [30, 1.5]]\n";

/// The headings of a drive along the wall: twice the robot turns away from it by 60 deg, as to pass an obstacle.
std::vector<double> headings_deg() {
  std::vector<double> list;
  for (int swerve = 0; swerve < 2; ++swerve) {
    list.insert(list.end(), 10, 0);
    for (const double away : {20, 40, 60, 60, 40, 20}) list.push_back(away);
    for (const double back : {-20, -40, -40, -40, -40, -20}) list.push_back(back);
  }
  return list;
}

struct Sample {
  Pose2 pose;
  double range_m = 0;
};

/// 0.128 m/s, a reading each second, as in the paper.
std::vector<Sample> record(Sensor& s4) {
  Stage stage(kCorridor);
  std::vector<Sample> samples;
  Pose2 pose{{0, 0.5}, {}};
  for (const double heading_deg : headings_deg()) {
    pose.yaw = Angle::from_deg(heading_deg);
    pose.position += direction(pose.yaw.rad()) * 0.128;
    double values[2];
    Draws draws(StreamId{}, 0);
    s4.measure(stage.at({pose.position, (pose.yaw - Angle::from_deg(90)).wrapped()}), draws, values);
    samples.push_back({pose, values[0]});
  }
  return samples;
}

/// By hand: a ray that leaves at an angle a from the wall's normal meets it after y / cos a. Within 22.5 deg that is
/// the echo; beyond, it goes on to the rough wall and has come (y + 1.5 m) / cos a. The nearest of 7 rays, 50 deg / 6
/// apart.
double expected_m(const Pose2& pose, bool mirrors) {
  double nearest_m = kInfinity;
  for (int n = -3; n <= 3; ++n) {
    const double off_deg = std::fabs(pose.yaw.deg() + n * 50.0 / 6);
    const double way_m = off_deg <= 22.5 ? pose.position.y : mirrors ? pose.position.y + 1.5 : kInfinity;
    if (off_deg < 90) nearest_m = std::min(nearest_m, way_m / std::cos(off_deg * kPi / 180));
  }
  return nearest_m <= 6 ? nearest_m : kInfinity;
}

TEST(S4, ShowsTwoSpecularSpikesWherePhantomsAreHeard) {
  const auto s4 = made(sonar_kind, {{"device", 1}, {"noise_m", 0}, {"resolution_m", 0}});
  int spikes = 0;
  bool before = false;
  for (const Sample& sample : record(*s4)) {
    EXPECT_NEAR(sample.range_m, expected_m(sample.pose, true), 1e-5);  // a mirrored ray starts 1 um off the wall
    const bool far = sample.range_m > 2 * sample.pose.position.y;
    if (far && !before) ++spikes;
    before = far;
  }
  EXPECT_EQ(spikes, 2);
}

TEST(S4, HearsNothingInTheSpikesWithoutMirrorPaths) {
  const auto s4 = made(sonar_kind, {{"device", 1}, {"noise_m", 0}, {"resolution_m", 0}, {"mirror_bounces", 0}});
  int lost = 0;
  for (const Sample& sample : record(*s4)) {
    EXPECT_NEAR(std::min(sample.range_m, 99.0), std::min(expected_m(sample.pose, false), 99.0), 1e-9);
    lost += std::isinf(sample.range_m) ? 1 : 0;
  }
  EXPECT_EQ(lost, 4);  // at 60 deg, when the cone's rim is 35 deg from the normal, two seconds each time
}

TEST(S4, ReadsThePhantomThatAHandCalculationPredicts) {
  // At 60 deg the steepest ray is 35 deg from the normal: (0.5 + 1.5) / cos 35 deg = 2.4415 m, five times the truth.
  Stage stage(kCorridor);
  const auto s4 = made(sonar_kind, {{"device", 1}, {"noise_m", 0}});
  double values[2];
  Draws draws(StreamId{}, 0);
  s4->measure(stage.at({{0, 0.5}, Angle::from_deg(-30)}), draws, values);
  EXPECT_NEAR(values[0], 2.44, 1e-9);
}

TEST(S4, JumpsWhereTheWallEnds) {
  // Past a corner of the right wall, at x = 0, the next surface is a rough wall at y = -2.
  Stage stage(
      "format = 1\nname = \"w\"\n[[wall]]\npoints = [[-9, 0], [0, 0], [0, -2]]\nmaterial = \"smooth\"\n"
      "[[wall]]\npoints = [[-9, -2], [9, -2]]\n");
  const auto s4 = made(sonar_kind, {{"device", 1}, {"noise_m", 0}, {"resolution_m", 0}});
  const auto read_m = [&](double x_m) {
    double values[2];
    Draws draws(StreamId{}, 0);
    s4->measure(stage.at({{x_m, 0.5}, Angle::from_deg(-90)}), draws, values);
    return values[0];
  };
  EXPECT_NEAR(read_m(-0.3), 0.5, 1e-9);
  // At 0.1 m the ray 16.67 deg back meets the wall 0.15 m before its end: 0.5 / cos 16.67 deg.
  EXPECT_NEAR(read_m(0.1), 0.5 / std::cos(Angle::from_deg(50.0 / 3).rad()), 1e-9);
  EXPECT_NEAR(read_m(0.5), 2.5, 1e-9);  // none meets it within 22.5 deg: straight down to the far wall
}

}  // namespace
}  // namespace ganglion::sim
