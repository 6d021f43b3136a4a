#include <gtest/gtest.h>

#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/testing/markup.h"
#include "ganglion/plot/testing/sample_run.h"

namespace ganglion::plot {

extern const PictureKind bars_kind;

namespace {

TEST(BarsPicture, HasABarWithNameAndValueForEach) {
  const RunView run = sample_exhibits_run();
  ASSERT_TRUE(bars_kind.wants(run));
  const auto words = words_in(bars_kind.draw(run, Language::Spanish).at(0));
  for (const char* word : {"regla 1", "0.4", "regla 2", "0.9", "regla 3", "-0.4", "Fuerza"}) {
    EXPECT_TRUE(words.contains(word)) << word;
  }
  EXPECT_FALSE(bars_kind.wants(sample_router_run()));
}

}  // namespace
}  // namespace ganglion::plot
