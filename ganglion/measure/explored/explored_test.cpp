#include <gtest/gtest.h>

#include <cmath>

#include "ganglion/measure/testing/measure_bench.h"

namespace ganglion {

extern const MeasureKind explored_kind;

namespace {

using testing::channels;
using testing::figure_names;
using testing::MeasureBench;
using Names = std::vector<std::string>;

constexpr double kSquare_m2 = 0.0625;  // 0.25 m by 0.25 m

class ExploredTest : public ::testing::Test {
 protected:
  double after(double x_m, double y_m) {
    bench_.step({x_m, y_m, 0});
    return bench_.figure("explored_m2");
  }
  MeasureBench& bench() { return bench_; }

 private:
  std::vector<TruthChannel> truth_ = channels({"x_m", "y_m", "yaw_rad"});
  MeasureBench bench_{explored_kind, {.truth = truth_}};
};

TEST_F(ExploredTest, HasAFigureWhereThereIsAPose) {
  const auto pose = channels({"x_m", "y_m", "yaw_rad"}), no_pose = channels({"travelled_m"});
  EXPECT_EQ(figure_names(explored_kind, {.truth = pose}), Names{"explored_m2"});
  EXPECT_EQ(explored_kind.figures({.truth = pose})[0].unit, "m2");
  EXPECT_EQ(figure_names(explored_kind, {.truth = no_pose}), Names{});
  EXPECT_EQ(figure_names(explored_kind, {}), Names{});
}

TEST_F(ExploredTest, IsNotKnownWhereNobodyKnowsTheTruth) {
  bench().begin({});
  bench().step({});
  EXPECT_TRUE(std::isnan(bench().figure("explored_m2")));
}

TEST_F(ExploredTest, CountsEachSquareOnce) {
  EXPECT_EQ(after(0.01, 0.01), kSquare_m2);
  EXPECT_EQ(after(0.24, 0.24), kSquare_m2) << "the same square";
  EXPECT_EQ(after(0.25, 0.24), 2 * kSquare_m2) << "its edge is the next one's";
  EXPECT_EQ(after(0.25, 0.25), 3 * kSquare_m2);
  EXPECT_EQ(after(0.01, 0.01), 3 * kSquare_m2) << "back again";
  EXPECT_EQ(after(7, 0.01), 4 * kSquare_m2) << "what lies between was not seen";
}

TEST_F(ExploredTest, KnowsTheSquaresOnTheOtherSideOfTheAxes) {
  EXPECT_EQ(after(0.1, 0.1), kSquare_m2);
  EXPECT_EQ(after(-0.1, 0.1), 2 * kSquare_m2) << "-0.1 is not in the square of 0.1";
  EXPECT_EQ(after(0.1, -0.1), 3 * kSquare_m2);
  EXPECT_EQ(after(-0.1, -0.1), 4 * kSquare_m2);
  EXPECT_EQ(after(-0.25, 0.1), 4 * kSquare_m2) << "squares hold their western edge";
  EXPECT_EQ(after(-0.26, 0.1), 5 * kSquare_m2);
}

TEST_F(ExploredTest, KeepsWhatItHasWhileNobodyTells) {
  EXPECT_EQ(after(0.1, 0.1), kSquare_m2);
  bench().step({});
  EXPECT_EQ(bench().figure("explored_m2"), kSquare_m2);
}

}  // namespace
}  // namespace ganglion
