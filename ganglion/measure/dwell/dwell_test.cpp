#include <gtest/gtest.h>

#include <cmath>

#include "ganglion/measure/testing/measure_bench.h"

namespace ganglion {

extern const MeasureKind dwell_kind;

namespace {

using testing::channels;
using testing::figure_names;
using testing::MeasureBench;
using Names = std::vector<std::string>;

/// Rows are x, y, yaw and way; signals are some "held", then two excuses.
class DwellTest : public ::testing::Test {
 protected:
  MeasureScope scope() const { return {.truth = truth_, .signals = signals_}; }

 private:
  std::vector<TruthChannel> truth_ = channels({"x_m", "y_m", "yaw_rad", "travelled_m"});
  std::vector<MeasuredSignal> signals_ = {
      {.name = "heading.held", .unit = ""},
      {.name = "escape.stuck", .unit = "", .meaning = Meaning::StandsOnPurpose},
      {.name = "heading.blind", .unit = "", .meaning = Meaning::StandsOnPurpose},
  };
};

TEST_F(DwellTest, HasAFigureWhereThereAreAPoseAndAWay) {
  EXPECT_EQ(figure_names(dwell_kind, scope()), Names{"dwell_s"});
  EXPECT_EQ(dwell_kind.figures(scope())[0].unit, "s");
  const auto no_way = channels({"x_m", "y_m", "yaw_rad"}), no_pose = channels({"travelled_m"});
  EXPECT_EQ(figure_names(dwell_kind, {.truth = no_way}), Names{});
  EXPECT_EQ(figure_names(dwell_kind, {.truth = no_pose}), Names{});
  EXPECT_EQ(figure_names(dwell_kind, {}), Names{});
}

TEST_F(DwellTest, IsNotKnownWhereNobodyKnowsTheTruth) {
  MeasureBench bench(dwell_kind, scope());
  bench.begin({});
  EXPECT_TRUE(std::isnan(bench.figure("dwell_s")));
  bench.step({}, {0, 0, 0});
  EXPECT_TRUE(std::isnan(bench.figure("dwell_s")));
}

TEST_F(DwellTest, GrowsWhileItStandsAndNotWhileItDrives) {
  MeasureBench bench(dwell_kind, scope());
  bench.begin({3, 3, 0, 0});
  bench.step({3, 3, 0, 0}, {0, 0, 0});
  EXPECT_EQ(bench.figure("dwell_s"), 0);
  bench.step({3, 3, 0, 0}, {0, 0, 0});
  EXPECT_EQ(bench.figure("dwell_s"), 1);
  bench.step({3.9, 3, 0, 0.9}, {0, 0, 0});  // within a disc of radius 0.45
  EXPECT_EQ(bench.figure("dwell_s"), 2);
  bench.step({6, 3, 0, 3}, {0, 0, 0});
  bench.step({8, 3, 0, 5}, {0, 0, 0});
  EXPECT_EQ(bench.figure("dwell_s"), 2) << "the longest";
}

TEST_F(DwellTest, ExcusesStandingStillOnPurpose) {
  MeasureBench bench(dwell_kind, scope());
  for (int second = 1; second <= 4; ++second) bench.step({0, 0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(bench.figure("dwell_s"), 3);
  for (int second = 5; second <= 20; ++second) {
    bench.step({0, 0, 0, 0}, {0, second % 2 == 0 ? 1.0 : 0, second % 2 == 0 ? 0 : 1.0});  // either of the two
    EXPECT_EQ(bench.figure("dwell_s"), 3);
  }
  for (int second = 21; second <= 24; ++second) bench.step({0, 0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(bench.figure("dwell_s"), 3) << "a new stretch, from second 21 to 24";
  bench.step({0, 0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(bench.figure("dwell_s"), 4);
}

TEST_F(DwellTest, DoesNotExcuseMovingOn) {
  MeasureBench bench(dwell_kind, scope());
  double way_m = 0;
  bench.step({0, 0, 0, way_m}, {0, 0, 0});
  for (int second = 2; second <= 10; ++second) {  // 6 mm/s, above the 5 mm/s of one that stands
    way_m += 0.006;
    bench.step({way_m, 0, 0, way_m}, {0, 1, 0});
    EXPECT_EQ(bench.figure("dwell_s"), second - 1);
  }
  way_m += 0.004;
  bench.step({way_m, 0, 0, way_m}, {0, 1, 0});  // 4 mm/s are standing: the stretch ends
  EXPECT_EQ(bench.figure("dwell_s"), 9);
  way_m += 0.006;
  bench.step({way_m, 0, 0, way_m}, {0, 1, 0});
  EXPECT_EQ(bench.figure("dwell_s"), 9) << "else it would be 11 by now";
}

TEST_F(DwellTest, TakesTheWayOfAStepForASpeed) {
  MeasureBench bench(dwell_kind, scope(), 0.5);
  double way_m = 0;
  for (int tick = 1; tick <= 7; ++tick) {  // 4 mm in 0.5 s are 8 mm/s: it moves
    way_m += 0.004;
    bench.step({way_m, 0, 0, way_m}, {0, 1, 0});
  }
  EXPECT_EQ(bench.figure("dwell_s"), 3);  // looked at each second from 0.5 s on, so at 3.5 s
}

TEST_F(DwellTest, ExcusesNothingForOtherSignalsOrHalfTruths) {
  MeasureBench bench(dwell_kind, scope());
  for (int second = 1; second <= 4; ++second) bench.step({0, 0, 0, 0}, {1, 0.5, 0});
  EXPECT_EQ(bench.figure("dwell_s"), 3);
}

}  // namespace
}  // namespace ganglion
