#include "ganglion/run/handing_over.h"

#include <gtest/gtest.h>

#include "ganglion/base/testing/folder.h"
#include "ganglion/run/run.h"

namespace ganglion {
namespace {

TEST(HandoverTimes, AreOnceASecondWhereNothingIsConcluded) {
  HandoverTimes times(10);
  EXPECT_FALSE(times.due(10.99, 0));
  EXPECT_TRUE(times.due(11, 0));
  times.tried(11, 0, true);
  EXPECT_FALSE(times.due(11.99, 0));
  EXPECT_TRUE(times.due(12.1, 0));
}

TEST(HandoverTimes, AreSoonAfterARequestWasConcludedButNotAtEach) {
  HandoverTimes times(10);
  EXPECT_FALSE(times.due(10.04, 1));
  EXPECT_TRUE(times.due(10.05, 1));
  times.tried(10.05, 1, true);
  EXPECT_FALSE(times.due(10.2, 1)) << "it was handed over";
  EXPECT_FALSE(times.due(10.09, 7));
  EXPECT_TRUE(times.due(10.11, 7));
}

TEST(HandoverTimes, ComeAgainSoonWhereThereWasNoPlace) {
  HandoverTimes times(10);
  times.tried(10.05, 1, false);
  EXPECT_FALSE(times.due(10.09, 1));
  EXPECT_TRUE(times.due(10.11, 1));
}

class HandedOver : public FolderTest {};

TEST_F(HandedOver, ExperienceLeavesTheRunAsItWouldBe) {
  Problems problems;
  const std::filesystem::path pathfinder = std::filesystem::path(GANGLION_SOURCE_DIR) / "experiments/pathfinder";
  const std::vector<config::Override> shortened = {{"run.duration_s", "200"}};
  const auto prepared = prepare(pathfinder, shortened, problems);
  ASSERT_TRUE(prepared) << problems.text();
  RunOptions options;
  const auto forgetful = run(*prepared, options);
  ExperienceWriter keeper(std::move(*ExperienceStore::open(folder_ / "map.sqlite")));
  options.keeper = &keeper;
  options.pace = 1000;  // 0.2 s of wall time: handed over on the way as well
  const auto keeping = run(*prepared, options);
  ASSERT_TRUE(forgetful && keeping);
  EXPECT_EQ(keeping->digest, forgetful->digest);
  EXPECT_FALSE(keeping->experience_error);
  const auto list = ExperienceStore::open(folder_ / "map.sqlite")->list();
  ASSERT_EQ(list->size(), 1u);
  EXPECT_EQ(list->front().component, "router");
  EXPECT_GT(list->front().parts, 1u);
}

}  // namespace
}  // namespace ganglion
