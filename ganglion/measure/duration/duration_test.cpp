#include <gtest/gtest.h>

#include "ganglion/measure/testing/measure_bench.h"

namespace ganglion {

extern const MeasureKind duration_kind;

namespace {

TEST(Duration, AppliesEverywhere) {
  const auto figures = duration_kind.figures({});
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_EQ(figures[0].name, "duration_s");
  EXPECT_EQ(figures[0].unit, "s");
  EXPECT_TRUE(figures[0].listed);
}

TEST(Duration, IsTheTimeOfTheLastTickWhoeverKnowsTheTruth) {
  testing::MeasureBench bench(duration_kind, {}, 0.25);
  bench.begin({});
  EXPECT_EQ(bench.figure("duration_s"), 0);
  bench.step({});
  EXPECT_EQ(bench.figure("duration_s"), 0.25);
  bench.step({});
  EXPECT_EQ(bench.figure("duration_s"), 0.5);
}

}  // namespace
}  // namespace ganglion
