#include <gtest/gtest.h>

#include <cmath>

#include "ganglion/measure/testing/measure_bench.h"

namespace ganglion {

extern const MeasureKind travel_kind;

namespace {

using testing::channels;
using testing::figure_names;
using Names = std::vector<std::string>;

TEST(Travel, TellsWhatIsKnownOfWayAndEnergy) {
  const auto both = channels({"x_m", "energy_J", "travelled_m"}), way = channels({"travelled_m"}),
             neither = channels({"x_m", "y_m", "yaw_rad"});
  EXPECT_EQ(figure_names(travel_kind, {.truth = both}), (Names{"travelled_m", "energy_J"}));
  EXPECT_EQ(figure_names(travel_kind, {.truth = way}), Names{"travelled_m"});
  EXPECT_EQ(figure_names(travel_kind, {.truth = neither}), Names{});
  EXPECT_EQ(figure_names(travel_kind, {}), Names{});
  EXPECT_EQ(travel_kind.figures({.truth = both})[0].unit, "m");
  EXPECT_EQ(travel_kind.figures({.truth = both})[1].unit, "J");
}

TEST(Travel, IsWhatTheTruthSaysNow) {
  const auto truth = channels({"x_m", "energy_J", "travelled_m"});
  testing::MeasureBench bench(travel_kind, {.truth = truth});
  bench.begin({3, 0, 0});
  EXPECT_EQ(bench.figure("travelled_m"), 0);
  EXPECT_EQ(bench.figure("energy_J"), 0);
  bench.step({4, 2.5, 1});
  EXPECT_EQ(bench.figure("travelled_m"), 1);
  EXPECT_EQ(bench.figure("energy_J"), 2.5);
  bench.step({3, 6, 2});
  EXPECT_EQ(bench.figure("travelled_m"), 2);
  EXPECT_EQ(bench.figure("energy_J"), 6);
}

TEST(Travel, IsNotKnownWhereNobodySaysIt) {
  const auto truth = channels({"travelled_m", "energy_J"});
  testing::MeasureBench bench(travel_kind, {.truth = truth});
  bench.begin({});
  bench.step({});
  EXPECT_TRUE(std::isnan(bench.figure("travelled_m")));
  EXPECT_TRUE(std::isnan(bench.figure("energy_J")));
}

}  // namespace
}  // namespace ganglion
