#include <gtest/gtest.h>

#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/testing/markup.h"
#include "ganglion/plot/testing/sample_run.h"

namespace ganglion::plot {

extern const PictureKind curves_kind;

namespace {

TEST(CurvesPicture, HasAxesWithUnitsLinesAndTheSignalThatMarksAPlace) {
  const RunView run = sample_exhibits_run();
  ASSERT_TRUE(curves_kind.wants(run));
  const auto words = words_in(curves_kind.draw(run, Language::English).at(0));
  for (const char* word : {"Distance [m]", "Degree", "near", "fit", "truth.x_m"}) {
    EXPECT_TRUE(words.contains(word)) << word;
  }
  EXPECT_FALSE(curves_kind.wants(sample_router_run()));
}

TEST(CurvesPicture, MarksNoPlaceWhereItsSignalSaysNone) {
  RunView run = sample_exhibits_run();
  run.robots[0].signals = {};
  EXPECT_FALSE(words_in(curves_kind.draw(run, Language::English).at(0)).contains("truth.x_m"));
}

}  // namespace
}  // namespace ganglion::plot
