#include <gtest/gtest.h>

#include "ganglion/measure/testing/measure_bench.h"

namespace ganglion {

extern const MeasureKind share_kind;

namespace {

using testing::figure_names;
using testing::MeasureBench;
using Names = std::vector<std::string>;

class ShareTest : public ::testing::Test {
 protected:
  MeasureScope scope() const { return {.signals = signals_}; }

 private:
  std::vector<MeasuredSignal> signals_ = {
      {.name = "arbiter.active", .unit = ""},
      {.name = "arbiter.share.escape", .unit = "", .meaning = Meaning::Share},
      {.name = "other.share.nobody", .unit = ""},
      {.name = "arbiter.share.avoid", .unit = "", .meaning = Meaning::Share},
  };
};

TEST_F(ShareTest, HasAFigureForEachCandidateByTheLastPartOfItsName) {
  EXPECT_EQ(figure_names(share_kind, scope()), (Names{"escape_share", "avoid_share"}));
  EXPECT_EQ(share_kind.figures(scope())[0].title,
            (Sentence{"share of the time that escape drove", "parte del tiempo en que condujo escape"}));
}

TEST_F(ShareTest, HasNoneWithoutACoordinator) {
  const std::vector<MeasuredSignal> signals = {
      {.name = "escape.stuck", .unit = "", .meaning = Meaning::StandsOnPurpose}};
  EXPECT_EQ(figure_names(share_kind, {.signals = signals}), Names{});
  EXPECT_EQ(figure_names(share_kind, {}), Names{});
}

TEST_F(ShareTest, IsTheMeanOverTheTicksWhoeverKnowsTheTruth) {
  MeasureBench bench(share_kind, scope(), 0.1);
  bench.begin({});
  EXPECT_EQ(bench.figure("escape_share"), 0);
  EXPECT_EQ(bench.figure("avoid_share"), 0);
  bench.step({}, {0, 1, 9, 0});
  EXPECT_EQ(bench.figure("escape_share"), 1);
  EXPECT_EQ(bench.figure("avoid_share"), 0);
  bench.step({}, {0, 0.5, 9, 0.5});
  EXPECT_EQ(bench.figure("escape_share"), 0.75);  // 1.5 / 2
  EXPECT_EQ(bench.figure("avoid_share"), 0.25);
  bench.step({}, {-1, 0, 9, 0});  // nobody drives
  EXPECT_EQ(bench.figure("escape_share"), 0.5);
  bench.step({}, {1, 0, 9, 1});
  EXPECT_EQ(bench.figure("escape_share"), 0.375);  // 1.5 / 4
  EXPECT_EQ(bench.figure("avoid_share"), 0.375);
}

}  // namespace
}  // namespace ganglion
