#include "ganglion/measure/measure.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ganglion/measure/followed.h"
#include "ganglion/measure/place.h"
#include "ganglion/measure/testing/measure_bench.h"

namespace ganglion {
namespace {

using testing::channels;
using testing::figure_names;
using testing::MeasureBench;
using Names = std::vector<std::string>;

constexpr std::array kList = {
    Followed{"weight_kg", "mass_kg", "kg", {"what it weighs", "lo que pesa"}},
    Followed{"height_m", "z_m", "m", {"how high it is", "lo alto que está"}},
};

const MeasureKind kFollowing{
    .descriptor = {.component_class = ComponentClass::Measure, .name = "Following"},
    .figures = [](const MeasureScope& scope) { return followed_figures(scope, kList); },
    .make = [](const MeasureScope& scope) { return make_followed(scope, kList); },
};

TEST(MeasureScope, FindsAChannelByItsWholeName) {
  const auto truth = channels({"x_m", "y_m", "yaw_rad"});
  const MeasureScope scope{.truth = truth};
  EXPECT_EQ(scope.truth_index("x_m"), 0u);
  EXPECT_EQ(scope.truth_index("yaw_rad"), 2u);
  EXPECT_EQ(scope.truth_index("yaw"), std::nullopt);
  EXPECT_EQ(scope.truth_index(""), std::nullopt);
  EXPECT_EQ(MeasureScope{}.truth_index("x_m"), std::nullopt);
}

TEST(Unhindered, IsCutIntoRowsOfAllChannels) {
  const Unhindered free{.channels = 2, .values = {1, 2, 3, 4, 5, 6}};
  ASSERT_EQ(free.rows(), 3u);
  EXPECT_EQ(free.row(1)[0], 3);
  EXPECT_EQ(free.row(2)[1], 6);
  EXPECT_EQ(free.row(2).size(), 2u);
  EXPECT_EQ(Unhindered{}.rows(), 0u);
}

TEST(PlaceColumns, AreWhereverTheChannelsStand) {
  const auto truth = channels({"energy_J", "yaw_rad", "y_m", "x_m"});
  const auto place = PlaceColumns::in({.truth = truth});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->yaw, 1u);
  const std::array row = {900.0, 0.5, -2.0, 7.0};
  EXPECT_EQ(place->position(row), (Vector2{7, -2}));
}

TEST(PlaceColumns, AreNoneWhereAnyPartOfThePoseIsUnknown) {
  const auto no_yaw = channels({"x_m", "y_m"}), no_x = channels({"y_m", "yaw_rad"}),
             no_y = channels({"x_m", "yaw_rad", "travelled_m"});
  EXPECT_FALSE(PlaceColumns::in({.truth = no_yaw}));
  EXPECT_FALSE(PlaceColumns::in({.truth = no_x}));
  EXPECT_FALSE(PlaceColumns::in({.truth = no_y}));
  EXPECT_FALSE(PlaceColumns::in({}));
}

TEST(Followed, HasAFigureForEachChannelThatIsKnown) {
  const auto both = channels({"z_m", "x_m", "mass_kg"}), one = channels({"z_m"}), none = channels({"x_m"});
  EXPECT_EQ(figure_names(kFollowing, {.truth = both}), (Names{"weight_kg", "height_m"})) << "in the order of the list";
  EXPECT_EQ(figure_names(kFollowing, {.truth = one}), Names{"height_m"});
  EXPECT_EQ(figure_names(kFollowing, {.truth = none}), Names{});
  EXPECT_EQ(figure_names(kFollowing, {}), Names{});
}

TEST(Followed, SaysUnitAndTitleOfTheFigure) {
  const auto truth = channels({"z_m"});
  const auto figures = kFollowing.figures({.truth = truth});
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_EQ(figures[0].unit, "m");
  EXPECT_EQ(figures[0].title, (Sentence{"how high it is", "lo alto que está"}));
  EXPECT_TRUE(figures[0].running);
  EXPECT_TRUE(figures[0].listed);
  EXPECT_FALSE(figures[0].sparse);
}

TEST(Followed, ReportsTheLastValuesFromTheStartOn) {
  const auto truth = channels({"z_m", "x_m", "mass_kg"});
  MeasureBench bench(kFollowing, {.truth = truth});
  bench.begin({0.5, 0, 70});
  EXPECT_EQ(bench.figure("weight_kg"), 70);
  EXPECT_EQ(bench.figure("height_m"), 0.5);
  bench.step({2, 9, 71});
  EXPECT_EQ(bench.figure("weight_kg"), 71);
  EXPECT_EQ(bench.figure("height_m"), 2);
  bench.step({1, 9, 69});  // neither the largest nor a sum
  EXPECT_EQ(bench.figure("weight_kg"), 69);
  EXPECT_EQ(bench.figure("height_m"), 1);
}

TEST(Followed, FindsTheColumnOfAFigureThatFollowsOneLeftOut) {
  const auto truth = channels({"x_m", "z_m"});
  MeasureBench bench(kFollowing, {.truth = truth});
  bench.step({4, 0.25});
  EXPECT_EQ(bench.figure("height_m"), 0.25);
}

TEST(Followed, IsNotKnownWhileThereIsNoTruth) {
  const auto truth = channels({"mass_kg", "z_m"});
  MeasureBench bench(kFollowing, {.truth = truth});
  EXPECT_TRUE(std::isnan(bench.figure("weight_kg")));
  bench.begin({});
  bench.step({});
  EXPECT_TRUE(std::isnan(bench.figure("weight_kg")));
  EXPECT_TRUE(std::isnan(bench.figure("height_m")));
}

}  // namespace
}  // namespace ganglion
