#include "tests/tree/circles.h"

#include <gtest/gtest.h>

namespace ganglion::tree {
namespace {

using Circles = std::vector<std::vector<std::string>>;

std::string told(const Findings& findings) {
  std::string lines;
  for (const Finding& finding : findings) lines += finding.text() + "\n";
  return lines;
}

TEST(CirclesOf, FindsNoneInATree) {
  EXPECT_EQ(circles_of({}), Circles());
  EXPECT_EQ(circles_of({{"a", {"b", "c"}}, {"b", {"d"}}, {"c", {"d"}}}), Circles());
  EXPECT_EQ(circles_of({{"a", {"a"}}}), Circles());
}

TEST(CirclesOf, FindsPairsAndLongOnes) {
  EXPECT_EQ(circles_of({{"a", {"b"}}, {"b", {"a", "c"}}, {"c", {}}}), (Circles{{"a", "b"}}));
  EXPECT_EQ(circles_of({{"a", {"b"}}, {"b", {"c"}}, {"c", {"a"}}, {"x", {"a"}}}), (Circles{{"a", "b", "c"}}));
  EXPECT_EQ(circles_of({{"a", {"b"}}, {"b", {"a", "c"}}, {"c", {"d"}}, {"d", {"c"}}}),
            (Circles{{"a", "b"}, {"c", "d"}}));
}

TEST(CheckFolderCircles, LeaveFoldersThatOnlyLeadDown) {
  EXPECT_EQ(told(check_folder_circles({{"g/a/x.cpp", 1, "g/b/x.h"},
                                       {"g/a/y.cpp", 1, "g/a/x.h"},
                                       {"g/a/deep/z.h", 1, "g/a/x.h"},
                                       {"g/b/x.cpp", 1, "g/b/deep/x.h"}})),
            "");
}

TEST(CheckFolderCircles, TellWhichImportsTieThem) {
  EXPECT_EQ(told(check_folder_circles({{"g/s/live/x.cpp", 7, "g/s/server/x.h"},
                                       {"g/s/live/x.cpp", 8, "g/s/server/y.h"},
                                       {"g/s/server/y.h", 3, "g/s/live/z.h"},
                                       {"g/s/server/y.h", 4, "g/s/other/z.h"}})),
            "g/s/live/x.cpp:7: g/s/live and g/s/server are in a circle, by g/s/server/x.h\n"
            "g/s/server/y.h:3: g/s/server and g/s/live are in a circle, by g/s/live/z.h\n");
}

TEST(CheckFolderCircles, FindThoseOfAFolderWithWhatLiesInIt) {
  EXPECT_EQ(told(check_folder_circles({{"g/a/x.h", 1, "g/a/deep/y.h"}, {"g/a/deep/y.h", 2, "g/a/z.h"}})),
            "g/a/x.h:1: g/a/. and g/a/deep are in a circle, by g/a/deep/y.h\n"
            "g/a/deep/y.h:2: g/a/deep and g/a/. are in a circle, by g/a/z.h\n");
}

TEST(CheckFolderCircles, FindThoseThatOnlyTheFoldersAboveForm) {
  EXPECT_EQ(check_folder_circles({{"g/a/one/x.h", 1, "g/b/one/x.h"}, {"g/b/two/x.h", 1, "g/a/two/x.h"}}).size(), 2u);
}

TEST(CheckFileCircles, LookAtFilesOfOneFolderToo) {
  EXPECT_EQ(told(check_file_circles({{"s/a.tsx", 1, "s/b"}, {"s/b.ts", 2, "s/a"}, {"s/b.ts", 3, "s/c"}})),
            "s/a.tsx:1: s/a and s/b are in a circle, by s/b\n"
            "s/b.ts:2: s/b and s/a are in a circle, by s/a\n");
  EXPECT_EQ(told(check_file_circles({{"s/a.tsx", 1, "s/b"}, {"s/c.ts", 2, "s/a"}})), "");
}

}  // namespace
}  // namespace ganglion::tree
