#include <gtest/gtest.h>

#include <cmath>

#include "ganglion/measure/testing/measure_bench.h"

namespace ganglion {

extern const MeasureKind floor_kind;

namespace {

using testing::channels;
using testing::figure_names;
using testing::MeasureBench;
using testing::WalledTerrain;
using Names = std::vector<std::string>;

constexpr double kInf = std::numeric_limits<double>::infinity();

class FloorTest : public ::testing::Test {
 protected:
  MeasureScope scope() const { return {.truth = truth_, .terrain = &hills_}; }

 private:
  std::vector<TruthChannel> truth_ = channels({"tipped", "x_m", "stalled"});
  WalledTerrain hills_{kInf, true};
};

TEST_F(FloorTest, HasFiguresWhereTheGroundSlopes) {
  EXPECT_EQ(figure_names(floor_kind, scope()), (Names{"stalled_s", "tipped_s"}));
  const WalledTerrain level;
  MeasureScope other = scope();
  other.terrain = &level;
  EXPECT_EQ(figure_names(floor_kind, other), Names{});
  other.terrain = nullptr;
  EXPECT_EQ(figure_names(floor_kind, other), Names{});
}

TEST_F(FloorTest, HasNoneWhereTheTruthLeavesOneOut) {
  const auto no_tipped = channels({"stalled"}), no_stalled = channels({"tipped"});
  for (const auto* truth : {&no_tipped, &no_stalled}) {
    MeasureScope other = scope();
    other.truth = *truth;
    EXPECT_EQ(figure_names(floor_kind, other), Names{});
  }
  MeasureScope nobody = scope();
  nobody.truth = {};
  EXPECT_EQ(figure_names(floor_kind, nobody), Names{});
}

TEST_F(FloorTest, IsNotKnownWhereNobodyKnowsTheTruth) {
  MeasureBench bench(floor_kind, scope());
  bench.begin({});
  bench.step({});
  EXPECT_TRUE(std::isnan(bench.figure("stalled_s")));
  EXPECT_TRUE(std::isnan(bench.figure("tipped_s")));
}

TEST_F(FloorTest, AddsUpTheStepsOfEach) {
  MeasureBench bench(floor_kind, scope(), 0.25);
  bench.begin({0, 3, 1});  // the start is no step
  bench.step({0, 3, 0});
  EXPECT_EQ(bench.figure("stalled_s"), 0);
  EXPECT_EQ(bench.figure("tipped_s"), 0);
  bench.step({0, 3, 1});
  EXPECT_EQ(bench.figure("stalled_s"), 0.25);
  EXPECT_EQ(bench.figure("tipped_s"), 0);
  bench.step({1, 3, 1});
  EXPECT_EQ(bench.figure("stalled_s"), 0.5);
  EXPECT_EQ(bench.figure("tipped_s"), 0.25);
  bench.step({1, 3, 0});
  EXPECT_EQ(bench.figure("stalled_s"), 0.5);
  EXPECT_EQ(bench.figure("tipped_s"), 0.5);
  bench.step({0, 3, 0});
  EXPECT_EQ(bench.figure("tipped_s"), 0.5);
}

}  // namespace
}  // namespace ganglion
