#include "ganglion/record/compare_components.h"

#include <gtest/gtest.h>

namespace ganglion {
namespace {

using Names = std::vector<std::string>;

TEST(CompareComponents, SortsThemByWhatBecameOfThem) {
  const RunOutcome first{.component_digests = {{"robot0/b", "1"}, {"robot0/a", "2"}, {"robot0/lost", "3"}}};
  const RunOutcome second{.component_digests = {{"robot0/new", "1"}, {"robot0/a", "2"}, {"robot0/b", "9"}}};
  const DigestComparison found = compare_components(first, second);
  EXPECT_EQ(found.same, Names{"robot0/a"});
  EXPECT_EQ(found.different, Names{"robot0/b"});
  EXPECT_EQ(found.only_first, Names{"robot0/lost"});
  EXPECT_EQ(found.only_second, Names{"robot0/new"});
}

TEST(CompareComponents, ReadsThemBackFromTheRunFilesFields) {
  const RunOutcome outcome{
      .digest = "00", .reason = {"goal", "meta"}, .component_digests = {{"robot0/a", "2"}, {"robot0/b", "1"}}};
  const auto read = run_outcome_from(to_fields(outcome));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->component_digests, outcome.component_digests);
}

}  // namespace
}  // namespace ganglion
