#include <gtest/gtest.h>

#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/testing/markup.h"
#include "ganglion/plot/testing/sample_run.h"

namespace ganglion::plot {

extern const PictureKind behaviours_kind;

namespace {

TEST(BehavioursPicture, IsOneForEachRobotThatHasCoordinators) {
  EXPECT_EQ(behaviours_kind.draw(sample_behaviour_run(3, 5), Language::English).size(), 3u);
  EXPECT_FALSE(behaviours_kind.wants(sample_router_run()));
}

}  // namespace
}  // namespace ganglion::plot
