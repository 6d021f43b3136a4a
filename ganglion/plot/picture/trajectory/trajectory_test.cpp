#include <gtest/gtest.h>

#include "ganglion/plot/picture/picture_kind.h"
#include "ganglion/plot/testing/markup.h"
#include "ganglion/plot/testing/sample_run.h"

namespace ganglion::plot {

extern const PictureKind trajectory_kind;

namespace {

TEST(TrajectoryPicture, ShowsWhatLastsButNoPlanOfTheLastMoment) {
  const RunView run = sample_router_run();
  const auto words = words_in(trajectory_kind.draw(run, Language::English).at(0));
  for (const char* word : {"goal", "goal reached", "goal given up", "failed attempt", "trajectory"}) {
    EXPECT_TRUE(words.contains(word)) << word;
  }
  EXPECT_FALSE(words.contains("plan"));
}

TEST(TrajectoryPicture, IsNotForAPlantThatKnowsNoGround) {
  RunView run = sample_behaviour_run(1, 5);
  EXPECT_TRUE(trajectory_kind.wants(run));
  run.scene.bounds.reset();
  run.robots[0].track = {};
  EXPECT_FALSE(trajectory_kind.wants(run));
}

}  // namespace
}  // namespace ganglion::plot
