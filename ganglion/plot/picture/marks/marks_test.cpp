#include <gtest/gtest.h>

#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/testing/markup.h"
#include "ganglion/plot/testing/sample_run.h"

namespace ganglion::plot {

extern const PictureKind marks_kind;

namespace {

TEST(MarksPicture, IsForWhatNoOtherPictureShows) {
  EXPECT_TRUE(marks_kind.wants(sample_exhibits_run()));
  EXPECT_FALSE(marks_kind.wants(sample_router_run()));  // a plan, and what lasts: the way shows it
  EXPECT_FALSE(marks_kind.wants(sample_behaviour_run(1, 5)));
}

TEST(MarksPicture, ExplainsEveryRoleAndSaysEveryLabel) {
  const RunView run = sample_exhibits_run();
  const auto words = words_in(marks_kind.draw(run, Language::Spanish).at(0));
  for (const char* word : {"plan previsto", "eco", "sí mismo", "lugar", "objetivo alcanzado", "el patio", "casa"}) {
    EXPECT_TRUE(words.contains(word)) << word;
  }
}

}  // namespace
}  // namespace ganglion::plot
