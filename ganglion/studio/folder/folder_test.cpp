#include "ganglion/studio/folder/folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ganglion/base/beneath.h"
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

/// A folder beside the one that is opened, with a secret in it.
class LinkTest : public FolderTest {
 protected:
  LinkTest() : outside_(root_.string() + "_outside") {
    fs::create_directories(outside_);
    EXPECT_TRUE(write_file(outside_ / "secret.toml", "secret = 1\n"));
  }
  ~LinkTest() override { fs::remove_all(outside_); }
  fs::path outside_;
};

TEST_F(LinkTest, FollowsNoLinkThatWasPutInTheWayAfterALook) {
  fs::create_symlink(outside_, root_ / "swapped");
  fs::create_symlink(outside_ / "secret.toml", root_ / "swapped.toml");
  for (const char* inner : {"swapped/secret.toml", "swapped.toml"}) {  // as if a look had found no link there
    const auto read = read_beneath(root_, inner, 1000);
    ASSERT_FALSE(read) << inner;
    EXPECT_EQ(read.error().code, ErrorCode::NotFound);
  }
  EXPECT_FALSE(write_beneath(root_, "swapped/new.toml", "x"));
  EXPECT_FALSE(fs::exists(outside_ / "new.toml"));
  remove_beneath(root_, "swapped/secret.toml");
  EXPECT_EQ(read_file(outside_ / "secret.toml").value(), "secret = 1\n");
}

TEST_F(LinkTest, WritesThroughNoLinkWhereItsOwnFilesGo) {
  const std::string part = "." + std::to_string(::getpid()) + ".part";
  fs::create_symlink(outside_ / "planted", root_ / ("a.toml" + part));
  fs::create_symlink(outside_ / "planted", root_ / (".a.toml.draft" + part));
  fs::create_symlink(outside_ / "secret.toml", root_ / ".a.toml.draft");
  EXPECT_TRUE(folder_.save("a.toml", "x = 1\n", "")->has_value());
  EXPECT_TRUE(folder_.autosave("a.toml", "x = 2\n", ""));
  EXPECT_FALSE(fs::exists(outside_ / "planted"));
  EXPECT_EQ(read_file(outside_ / "secret.toml").value(), "secret = 1\n");
  EXPECT_EQ(folder_.read("a.toml")->draft->text, "x = 2\n");
}

TEST_F(LinkTest, TakesALinkToWhatIsNotThereForALinkOut) {
  fs::create_symlink(outside_ / "later", root_ / "later");
  EXPECT_FALSE(folder_.holds(root_ / "later" / "x.toml"));
  EXPECT_FALSE(folder_.save("later/x.toml", "x = 1\n", ""));
  EXPECT_TRUE(folder_.holds(root_ / "new" / "x.toml"));
}

TEST_F(LinkTest, ReadsAndWritesThroughLinksThatStayInside) {
  fs::create_directories(root_ / "real");
  fs::create_symlink("real", root_ / "alias");
  ASSERT_TRUE(folder_.save("alias/x.toml", "x = 1\n", "")->has_value());
  EXPECT_EQ(folder_.read("real/x.toml")->text, "x = 1\n");
}

TEST_F(FolderTest, WaitsForNoPipeAndReadsNoFolder) {
  ASSERT_EQ(::mkfifo((root_ / "pipe.toml").c_str(), 0600), 0);
  fs::create_directories(root_ / "folder.toml");
  for (const char* name : {"pipe.toml", "folder.toml"}) {
    const auto read = folder_.read(name);
    ASSERT_FALSE(read) << name;
    EXPECT_EQ(read.error().code, ErrorCode::Unreadable) << name;
    EXPECT_FALSE(folder_.save(name, "x = 1\n", "")) << name;
  }
}

TEST_F(FolderTest, MakesNoNewFolderWhereItsOwnHasGone) {
  fs::remove_all(root_);
  EXPECT_FALSE(folder_.save("a.toml", "x = 1\n", ""));
  EXPECT_FALSE(fs::exists(root_));
}

}  // namespace
}  // namespace ganglion::studio
