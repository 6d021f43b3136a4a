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

TEST(Criterion, IsNotMetByWhatWasNotMeasured) {
  EXPECT_FALSE(parse_criterion("goals_missed <= 0")->met({{"other", 0}}));
  EXPECT_FALSE(parse_criterion("goals_missed <= 0")->met({{"goals_missed", NAN}}));
}

TEST(Criterion, SaysHowItIsWritten) {
  for (const char* wrong : {"", "a", "a < b", "a << 3", "a < 3 4"}) {
    const auto criterion = parse_criterion(wrong);
    ASSERT_FALSE(criterion) << wrong;
    EXPECT_NE(criterion.error().what.en.find("contacts <= 3"), std::string::npos);
    EXPECT_NE(criterion.error().what.es.find("escriba una medida"), std::string::npos);
  }
}

}  // namespace
}  // namespace ganglion
