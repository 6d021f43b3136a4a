#include <gtest/gtest.h>

#include <cmath>

#include "ganglion/measure/testing/measure_bench.h"

namespace ganglion {

extern const MeasureKind course_kind;

namespace {

using testing::channels;
using testing::figure_names;
using testing::MeasureBench;
using testing::WalledTerrain;
using Names = std::vector<std::string>;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kPi = 3.14159265358979323846;

class CourseTest : public ::testing::Test {
 protected:
  /// On ground with a wall along x = 10 the robot of radius 0.5 m that starts at x = 1 has 9 m before it, and counts as
  /// having come to the wall after 9 - 0.5 - 0.5 = 8 m.
  MeasureScope scope() const { return {.truth = truth_, .terrain = &walled_, .radius_m = 0.5}; }
  MeasureScope open() const { return {.truth = truth_, .terrain = &open_, .radius_m = 0.5}; }

 private:
  std::vector<TruthChannel> truth_ = channels({"x_m", "y_m", "yaw_rad"});
  WalledTerrain walled_{10};
  WalledTerrain open_;
};

/// From (1, 2) to the east on free ground, x at each tick.
Unhindered eastward(std::initializer_list<double> xs) {
  Unhindered free{.channels = 3};
  for (const double x : xs) free.values.insert(free.values.end(), {x, 2, 0});
  return free;
}

TEST_F(CourseTest, HasFiguresWhereThereIsAPoseAndGround) {
  EXPECT_EQ(figure_names(course_kind, scope()),
            (Names{"progress_m", "far_wall_m", "off_course_m", "at_far_wall", "progress_ratio"}));
  MeasureScope less = scope();
  less.terrain = nullptr;
  EXPECT_EQ(figure_names(course_kind, less), Names{});
  less = scope();
  less.truth = {};
  EXPECT_EQ(figure_names(course_kind, less), Names{});
  const auto no_yaw = channels({"x_m", "y_m", "travelled_m"});
  less.truth = no_yaw;
  EXPECT_EQ(figure_names(course_kind, less), Names{});
}

TEST_F(CourseTest, ListsAllButWhatIsForStopRulesOnly) {
  for (const Figure& figure : course_kind.figures(scope())) {
    EXPECT_EQ(figure.listed, figure.name != "at_far_wall") << figure.name;
    EXPECT_TRUE(figure.running) << figure.name;
    EXPECT_EQ(figure.sparse, figure.name == "progress_ratio") << figure.name;  // without a yardstick it is left out
  }
}

TEST_F(CourseTest, IsNotKnownWhereNobodyKnowsTheTruth) {
  const Unhindered free = eastward({3, 5});
  MeasureBench bench(course_kind, scope());
  bench.begin({}, &free);
  bench.step({});
  for (const std::string& name : figure_names(course_kind, scope())) {
    EXPECT_TRUE(std::isnan(bench.figure(name))) << name;
  }
}

TEST_F(CourseTest, NeverLosesProgress) {
  MeasureBench bench(course_kind, open());
  bench.begin({1, 2, 0});
  EXPECT_EQ(bench.figure("progress_m"), 0);
  bench.step({0, 2, 0});  // backwards first: no progress, but none below 0 either
  EXPECT_EQ(bench.figure("progress_m"), 0);
  bench.step({4, 3, 1});  // whichever way it looks by now
  EXPECT_EQ(bench.figure("progress_m"), 3);
  bench.step({2, 2, 2});
  EXPECT_EQ(bench.figure("progress_m"), 3);
  bench.step({4.5, -7, 0});
  EXPECT_EQ(bench.figure("progress_m"), 3.5);
}

TEST_F(CourseTest, IsOffByTheDistanceFromTheLineOfTheStart) {
  MeasureBench bench(course_kind, open());
  bench.begin({1, 2, 0});
  EXPECT_EQ(bench.figure("off_course_m"), 0);
  bench.step({4, 5, 0});
  EXPECT_EQ(bench.figure("off_course_m"), 3);
  bench.step({-4, -1, 0});  // behind the start and on the other side
  EXPECT_EQ(bench.figure("off_course_m"), 3);
  bench.step({9, 2.5, 0});  // as it is now, not as it was
  EXPECT_EQ(bench.figure("off_course_m"), 0.5);
}

TEST_F(CourseTest, FollowsTheHeadingOfTheStart) {
  MeasureBench bench(course_kind, open());
  bench.begin({1, 2, std::atan2(3, 4)});  // along (0.8, 0.6)
  bench.step({1 + 2.8, 2 + 4.6, 0});      // 5 (0.8, 0.6) + 2 (-0.6, 0.8)
  EXPECT_NEAR(bench.figure("progress_m"), 5, 1e-12);
  EXPECT_NEAR(bench.figure("off_course_m"), 2, 1e-12);
}

TEST_F(CourseTest, AsksHowFarTheWallIsFromTheStartAlongItsHeading) {
  MeasureBench ahead(course_kind, scope()), slanted(course_kind, scope()), away(course_kind, scope());
  ahead.begin({1, 2, 0});
  EXPECT_EQ(ahead.figure("far_wall_m"), 9);
  ahead.step({5, 2, 0});
  EXPECT_EQ(ahead.figure("far_wall_m"), 9) << "from the start, not from where it is";
  slanted.begin({1, 2, kPi / 3});  // cos 60 deg = 1 / 2
  EXPECT_NEAR(slanted.figure("far_wall_m"), 18, 1e-9);
  away.begin({1, 2, kPi});
  EXPECT_EQ(away.figure("far_wall_m"), kInf);
}

TEST_F(CourseTest, ComparesWithTheSameTickOnFreeGroundUntilTheFarWall) {
  const Unhindered free = eastward({3, 5, 7, 9, 11});  // 2, 4, 6, 8, 10 m, through the wall
  MeasureBench bench(course_kind, scope());
  bench.begin({1, 2, 0}, &free);
  EXPECT_EQ(bench.figure("progress_ratio"), 1);
  EXPECT_EQ(bench.figure("at_far_wall"), 0);
  bench.step({2, 2, 0});
  EXPECT_EQ(bench.figure("progress_ratio"), 1.0 / 2);
  bench.step({4, 2, 0});
  EXPECT_EQ(bench.figure("progress_ratio"), 3.0 / 4);
  bench.step({3, 2, 0});  // it goes back, and free ground goes on
  EXPECT_EQ(bench.figure("progress_ratio"), 3.0 / 6);
  bench.step({7, 2, 0});
  EXPECT_EQ(bench.figure("progress_ratio"), 6.0 / 8);
  bench.step({8.5, 2, 0});  // no more is asked than the 8 m to the wall
  EXPECT_EQ(bench.figure("progress_ratio"), 7.5 / 8);
  EXPECT_EQ(bench.figure("at_far_wall"), 0);
}

TEST_F(CourseTest, ComparesTheTimesOnceItHasComeToTheFarWall) {
  const Unhindered free = eastward({3, 5, 7, 9, 11});  // 8 m at the fourth tick
  MeasureBench bench(course_kind, scope());
  bench.begin({1, 2, 0}, &free);
  for (int tick = 1; tick <= 5; ++tick) bench.step({2, 2, 0});
  EXPECT_EQ(bench.figure("progress_ratio"), 1.0 / 8);
  bench.step({9.5, 2, 0});  // a sixth tick, for which free ground has no row any more
  EXPECT_EQ(bench.figure("progress_m"), 8.5);
  EXPECT_EQ(bench.figure("at_far_wall"), 1);
  EXPECT_EQ(bench.figure("progress_ratio"), 4.0 / 6);
  bench.step({3, 2, 0});  // what it does afterwards does not matter
  EXPECT_EQ(bench.figure("at_far_wall"), 1);
  EXPECT_EQ(bench.figure("progress_ratio"), 4.0 / 6);
}

TEST_F(CourseTest, HasComeToTheFarWallHalfAMetreBeforeItTouches) {
  const Unhindered free = eastward({3, 5, 7, 9, 11});
  MeasureBench bench(course_kind, scope());
  bench.begin({1, 2, 0}, &free);
  bench.step({8.999, 2, 0});
  EXPECT_EQ(bench.figure("at_far_wall"), 0);
  bench.step({9, 2, 0});
  EXPECT_EQ(bench.figure("at_far_wall"), 1);
  EXPECT_EQ(bench.figure("progress_ratio"), 4.0 / 2) << "twice as fast as on free ground";
}

TEST_F(CourseTest, NeedNotGoAnywhereBeforeAWallThatIsNear) {
  const Unhindered free = eastward({10, 11});
  MeasureBench bench(course_kind, scope());
  bench.begin({9, 2, 0}, &free);  // 1 - 0.5 - 0.5 = 0
  EXPECT_EQ(bench.figure("at_far_wall"), 1);
  bench.step({9, 2, 0});
  EXPECT_EQ(bench.figure("progress_ratio"), 1);
}

TEST_F(CourseTest, TakesTheProgressOfFreeGroundForOneThatNeverFallsEither) {
  const Unhindered free = eastward({0, 3, 2, 5});  // -1, 2, 1, 4 m: counted as 0, 2, 2, 4
  MeasureBench bench(course_kind, scope());
  bench.begin({1, 2, 0}, &free);
  bench.step({1, 2, 0});
  EXPECT_EQ(bench.figure("progress_ratio"), 1) << "nothing was to be done";
  bench.step({1, 2, 0});
  EXPECT_EQ(bench.figure("progress_ratio"), 0);
  bench.step({2, 2, 0});
  EXPECT_EQ(bench.figure("progress_ratio"), 1.0 / 2);
  bench.step({2, 2, 0});
  EXPECT_EQ(bench.figure("progress_ratio"), 1.0 / 4);
}

TEST_F(CourseTest, CountsTheTicksOfWhichNobodyTold) {
  const Unhindered free = eastward({3, 5, 7});
  MeasureBench bench(course_kind, scope());
  bench.begin({1, 2, 0}, &free);
  bench.step({});
  EXPECT_EQ(bench.figure("progress_ratio"), 1) << "as it was";
  bench.step({3, 2, 0});
  EXPECT_EQ(bench.figure("progress_ratio"), 2.0 / 4);
}

}  // namespace
}  // namespace ganglion
