#include "ganglion/base/text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsChangesAndSwaps) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);  // the textbook example
  EXPECT_EQ(edit_distance("sonar_lft", "sonar_left"), 1);
  EXPECT_EQ(edit_distance("form", "from"), 1);
  EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(Suggestion, NamesTheNearestOrListsTheChoices) {
  const std::vector<std::string> names = {"sonar_left", "sonar_right", "heading"};
  EXPECT_EQ(suggestion("Sonar_lft", names).en, "; did you mean \"sonar_left\"?");
  EXPECT_EQ(suggestion("zzz", names).en, "; valid: sonar_left, sonar_right, heading");
  EXPECT_EQ(suggestion("zzz", {}).en, "");
}

TEST(Printable, CutsLongTextsBetweenLetters) {
  EXPECT_EQ(printable("abc", 3), "abc");
  EXPECT_EQ(printable("abcd", 3), "abc...");
  EXPECT_EQ(printable("añb", 2), "a...");  // the ñ takes bytes 1 and 2
  EXPECT_EQ(printable("a\tb\x7f"), "a\\x09b\\x7f");
}

TEST(ParseNumber, TakesWholeWordsOnly) {
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_number("-2e3"), -2000);
  EXPECT_FALSE(parse_number("1.5m"));
  EXPECT_FALSE(parse_number(""));
  EXPECT_FALSE(parse_number("1e999"));
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
  EXPECT_EQ(*parse_number("-inf"), -INFINITY);
}

TEST(Shortest, ReadsBackAsTheSameDouble) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(*parse_number(shortest(1.0 / 3)), 1.0 / 3);
  EXPECT_EQ(shortest(-INFINITY), "-inf");
}

}  // namespace
}  // namespace ganglion
