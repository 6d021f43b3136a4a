#include "ganglion/base/json_depth.h"

#include <gtest/gtest.h>

#include <string>

namespace ganglion {
namespace {

TEST(JsonNestsWithin, CountsListsAndObjectsThatLieInEachOther) {
  EXPECT_TRUE(json_nests_within("1", 0));
  EXPECT_TRUE(json_nests_within(R"([{"a": [1]}, [[2]]])", 3));
  EXPECT_FALSE(json_nests_within(R"([{"a": [1]}, [[2]]])", 2));
  EXPECT_TRUE(json_nests_within("[],[],[]", 1));
}

TEST(JsonNestsWithin, LooksAtNoBracketsInStrings) {
  EXPECT_TRUE(json_nests_within(R"(["[[[["])", 1));
  EXPECT_TRUE(json_nests_within(R"(["\"[[[["])", 1));
  EXPECT_FALSE(json_nests_within(R"(["\\",[["]"]]])", 2));
}

/// {"k": 1, "k": 1, ...}
std::string object(int keys) {
  std::string text = "{";
  for (int i = 0; i < keys; ++i) text += "\"k\":1,";
  return text + "\"k\":1}";
}

// Each key is compared with all before it: n (n - 1) / 2 looks, of which 200 million are allowed.
TEST(JsonHasFewKeys, CountsThoseOfEachObjectByItself) {
  EXPECT_TRUE(json_has_few_keys(object(19'999)));   // 20,000 in all: 199,990,000
  EXPECT_FALSE(json_has_few_keys(object(20'000)));  // 200,010,000
  EXPECT_TRUE(json_has_few_keys("[" + object(14'000) + "," + object(14'000) + "]"));
  EXPECT_TRUE(json_has_few_keys("[\"" + std::string(30'000, ':') + "\"]"));
}

}  // namespace
}  // namespace ganglion
