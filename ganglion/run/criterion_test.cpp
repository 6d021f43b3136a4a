#include "ganglion/run/criterion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion {
namespace {

TEST(Criterion, ReadsAMeasureARelationAndANumber) {
  const auto criterion = parse_criterion("fastest_contact_mps  <= 0.05");
  ASSERT_TRUE(criterion);
  EXPECT_TRUE(criterion->met({{"fastest_contact_mps", 0.05}}));
  EXPECT_FALSE(criterion->met({{"fastest_contact_mps", 0.051}}));
  EXPECT_EQ(criterion->text(), "fastest_contact_mps <= 0.05");
}

TEST(Criterion, RelatesTwoFigures) {
  const auto share = parse_criterion("goals_reached >= 0.95 * goals_set");
  ASSERT_TRUE(share);
  EXPECT_EQ(share->text(), "goals_reached >= 0.95 * goals_set");
  EXPECT_TRUE(share->met({{"goals_reached", 19}, {"goals_set", 20}}));
  EXPECT_FALSE(share->met({{"goals_reached", 18}, {"goals_set", 20}}));
  EXPECT_FALSE(share->met({{"goals_reached", 18}})) << "nobody knows how many";
  const auto more = parse_criterion("avoid_share > hold_share");
  ASSERT_TRUE(more);
  EXPECT_EQ(more->text(), "avoid_share > hold_share");
  EXPECT_TRUE(more->met({{"avoid_share", 0.3}, {"hold_share", 0.2}}));
  EXPECT_FALSE(more->met({{"avoid_share", 0.2}, {"hold_share", 0.2}}));
}

TEST(Criterion, IsNotMetByWhatWasNotMeasured) {
  EXPECT_FALSE(parse_criterion("goals_missed <= 0")->met({{"other", 0}}));
  EXPECT_FALSE(parse_criterion("goals_missed <= 0")->met({{"goals_missed", NAN}}));
}

TEST(Criterion, SaysHowItIsWritten) {
  for (const char* wrong : {"", "a", "a << 3", "a < 3 4", "a < 3 * 4", "a < b * c", "a < 3 * ", "a < b * 3"}) {
    const auto criterion = parse_criterion(wrong);
    ASSERT_FALSE(criterion) << wrong;
    EXPECT_NE(criterion.error().what.en.find("contacts <= 3"), std::string::npos);
    EXPECT_NE(criterion.error().what.es.find("escriba una medida"), std::string::npos);
  }
}

}  // namespace
}  // namespace ganglion
