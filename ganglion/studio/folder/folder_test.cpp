#include "ganglion/studio/folder/folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "ganglion/base/file.h"
#include "ganglion/studio/folder/listing.h"

namespace ganglion::studio {
namespace {

namespace fs = std::filesystem;

class FolderTest : public ::testing::Test {
 protected:
  FolderTest()
      : root_(fs::path(::testing::TempDir()) / ("studio_folder_" + std::to_string(::getpid()))),
        folder_((fs::remove_all(root_), fs::create_directories(root_), Folder::open(root_).value())) {}
  ~FolderTest() override { fs::remove_all(root_); }
  fs::path root_;
  Folder folder_;
};

TEST_F(FolderTest, SavesANewFileOnlyWhereThereIsNone) {
  EXPECT_EQ(folder_.save("a/b.toml", "x = 1\n", "")->value(), text_hash("x = 1\n"));
  EXPECT_EQ(read_file(root_ / "a/b.toml").value(), "x = 1\n");
  const auto again = folder_.save("a/b.toml", "x = 2\n", "");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->error().text, "x = 1\n");
  EXPECT_TRUE(folder_.save("a/b.toml", "x = 2\n", text_hash("x = 1\n"))->has_value());
}

TEST_F(FolderTest, ReportsAFileThatIsGoneAsAConflict) {
  const auto saved = folder_.save("gone.toml", "x = 1\n", text_hash("x = 0\n"));
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->error().hash, "");
  EXPECT_FALSE(fs::exists(root_ / "gone.toml"));
}

TEST_F(FolderTest, KeepsADraftUntilTheFileIsSaved) {
  ASSERT_TRUE(folder_.save("a.toml", "x = 1\n", "")->has_value());
  const std::string hash = text_hash("x = 1\n");
  ASSERT_TRUE(folder_.autosave("a.toml", "x = 2\n# \xC3\xA9\n", hash));
  auto file = folder_.read("a.toml");
  EXPECT_EQ(file->text, "x = 1\n");
  EXPECT_EQ(file->draft->text, "x = 2\n# \xC3\xA9\n");
  EXPECT_EQ(file->draft->based_on, hash);
  ASSERT_TRUE(folder_.save("a.toml", "x = 2\n", hash)->has_value());
  EXPECT_FALSE(folder_.read("a.toml")->draft);
  ASSERT_TRUE(folder_.autosave("a.toml", "", ""));
  EXPECT_EQ(folder_.read("a.toml")->draft->text, "");
  ASSERT_TRUE(folder_.discard("a.toml"));
  EXPECT_FALSE(folder_.read("a.toml")->draft);
}

TEST_F(FolderTest, WritesNoProgramsAndNothingHuge) {
  EXPECT_FALSE(folder_.save("run.sh", "x", ""));
  EXPECT_FALSE(folder_.save("a.toml", std::string((4 << 20) + 1, '#'), ""));
  EXPECT_FALSE(folder_.autosave("a.toml", "", "not a hash\nbut lines"));
}

TEST_F(FolderTest, LeadsNowhereElse) {
  for (const char* name : {"..", "../x.toml", "a/../../x.toml", "/x.toml", "a//b.toml", ".x.toml", "a/.x/y.toml", ""}) {
    EXPECT_FALSE(folder_.resolve(name)) << name;
  }
  EXPECT_TRUE(folder_.resolve("a/b..c.toml"));
  EXPECT_FALSE(folder_.holds(root_.string() + "2/x.toml")) << "a folder whose name only begins alike";
}

TEST_F(FolderTest, ListsABrokenDrawingAndLooksAgainWhenItIsMended) {
  Listing listing(folder_);
  ASSERT_TRUE(write_file(root_ / "controller.toml", "[[acting\n"));
  EXPECT_EQ(listing.json()["controllers"].size(), 1u);
  ASSERT_TRUE(write_file(root_ / "controller.toml", "name = \"Mended\"\n[[acting]]\nid = \"a\"\n"));
  EXPECT_EQ(listing.json()["controllers"][0]["name"], "Mended");
  ASSERT_TRUE(folder_.autosave("controller.toml", "x = 1\n", ""));
  EXPECT_TRUE(listing.json()["controllers"][0]["draft"]);
}

}  // namespace
}  // namespace ganglion::studio
