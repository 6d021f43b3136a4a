#include <gtest/gtest.h>

#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/testing/markup.h"
#include "ganglion/plot/testing/sample_run.h"

namespace ganglion::plot {

extern const PictureKind networks_kind;

namespace {

TEST(NetworksPicture, NamesEveryNode) {
  const RunView run = sample_exhibits_run();
  ASSERT_TRUE(networks_kind.wants(run));
  const auto words = words_in(networks_kind.draw(run, Language::Spanish).at(0));
  for (const char* word : {"hambre", "saciado", "cansado"}) EXPECT_TRUE(words.contains(word)) << word;
  EXPECT_FALSE(networks_kind.wants(sample_router_run()));
}

}  // namespace
}  // namespace ganglion::plot
