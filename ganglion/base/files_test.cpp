#include "ganglion/base/files.h"

#include <gtest/gtest.h>

#include "ganglion/base/file.h"
#include "ganglion/base/hash.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/base/text.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

class Files : public FolderTest {
 protected:
  std::string put(const fs::path& name, std::string_view text) const {
    EXPECT_TRUE(write_file(folder_ / name, text));
    return (folder_ / name).string();
  }
  ErrorCode refusal(const fs::path& named, std::size_t most = 100) {
    const auto opened = disk_.open("any", named.string(), -1, most);
    EXPECT_FALSE(opened) << named;
    return opened ? ErrorCode::Syntax : opened.error().code;
  }
  DiskFiles disk_;
};

TEST_F(Files, AreReadOnceWhateverBecomesOfThem) {
  const std::string path = put("a.toml", "first");
  ASSERT_EQ(disk_.open("controller", path, -1, 100).value(), 0);
  put("a.toml", "second");
  EXPECT_EQ(disk_.open("controller", path, -1, 100).value(), 0);
  EXPECT_EQ(*disk_.at(0).text, "first");
  EXPECT_EQ(disk_.at(0).hash(), hash_name("first"));
  ASSERT_EQ(disk_.open("world", path, -1, 100).value(), 1) << "another role: another entry of the list";
  EXPECT_EQ(disk_.at(1).text, disk_.at(0).text) << "and the same text, not a copy";
  EXPECT_EQ(disk_.open("robot", path, -1, 4).error().code, ErrorCode::TooLarge);
}

TEST_F(Files, AreFoundFromTheFolderOfWhoNamesThem) {
  put("maps/floor.pgm", "P5");
  put("other.txt", "o");
  const int world = disk_.open("world", put("world.toml", ""), -1, 100).value();
  const int map = disk_.open("map", put("maps/floor.yaml", ""), world, 100).value();
  const int image = disk_.open("image", "floor.pgm", map, 100).value();
  EXPECT_EQ(*disk_.at(image).text, "P5");
  EXPECT_EQ(disk_.at(image).named, "floor.pgm");
  EXPECT_EQ(disk_.at(image).by, map);
  EXPECT_EQ(disk_.at(image).resolved, folder_ / "maps/floor.pgm");
  EXPECT_EQ(disk_.index_of((folder_ / "maps/floor.pgm").string()), image);
  EXPECT_EQ(disk_.index_of("--set world=other.txt"), -1);
  EXPECT_EQ(*disk_.at(disk_.open("x", "../other.txt", map, 100).value()).text, "o");
}

TEST_F(Files, ThatCannotBeReadSaySo) {
  const std::string path = put("a.toml", "12345");
  fs::create_symlink(folder_ / "round", folder_ / "and_round");
  fs::create_symlink(folder_ / "and_round", folder_ / "round");
  EXPECT_EQ(refusal(folder_ / "none.toml"), ErrorCode::NotFound);
  EXPECT_EQ(refusal(folder_ / "a.toml" / "inside"), ErrorCode::NotFound);
  EXPECT_EQ(refusal(folder_), ErrorCode::Unreadable);
  EXPECT_EQ(refusal("/dev/zero"), ErrorCode::Unreadable);
  EXPECT_EQ(refusal(folder_ / "round"), ErrorCode::Unreadable);
  EXPECT_EQ(refusal(path, 4), ErrorCode::TooLarge);
  EXPECT_EQ(refusal(path + std::string("\0.pgm", 5)), ErrorCode::NotFound) << "the system would open a.toml";
  EXPECT_TRUE(disk_.opened().empty()) << "what was not read is on no list";
  EXPECT_EQ(*disk_.at(disk_.open("any", path, -1, 5).value()).text, "12345") << "just within";
}

TEST_F(Files, MayBeTextsThatStandNowhere) {
  const int held = disk_.hold("controller", folder_ / "drawn.toml", "drawn");
  put("rules.txt", "r");
  EXPECT_EQ(disk_.at(disk_.open("rules", "rules.txt", held, 100).value()).resolved, folder_ / "rules.txt");
  const int again = disk_.open("controller", (folder_ / "drawn.toml").string(), -1, 100).value();
  EXPECT_EQ(*disk_.at(again).text, "drawn") << "whoever opens the place gets what is held there";
  const int own = disk_.builtin("rules", "builtin:a.txt", "own", held);
  EXPECT_EQ(disk_.builtin("rules", "builtin:a.txt", "own", held), own);
  EXPECT_TRUE(disk_.at(own).resolved.empty());
  EXPECT_EQ(*disk_.at(own).text, "own");
}

TEST(Utf8, EndsWhereItIsBroken) {
  EXPECT_EQ(first_not_utf8("a\xc3\xb1o"), std::nullopt);
  EXPECT_EQ(first_not_utf8(""), std::nullopt);
  EXPECT_EQ(first_not_utf8("ab\xf1o"), 2u) << "Latin 1";
  EXPECT_EQ(first_not_utf8("a\xc3"), 1u) << "cut";
  EXPECT_EQ(first_not_utf8("\xc0\xaf"), 0u) << "overlong";
  EXPECT_EQ(first_not_utf8("\xed\xa0\x80"), 0u) << "a surrogate";
}

}  // namespace
}  // namespace ganglion
