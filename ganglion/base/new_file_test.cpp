#include "ganglion/base/new_file.h"

#include <sys/stat.h>
#include <sys/sysmacros.h>

#include "ganglion/base/beneath.h"
#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

class NewFileTest : public FolderTest {
 protected:
  NewFileTest() : inside_(folder_ / "inside"), outside_(folder_ / "outside") {
    fs::create_directories(inside_);
    fs::create_directories(outside_);
    EXPECT_TRUE(write_file(outside_ / "secret", "secret"));
  }
  static mode_t mode_of(const fs::path& file) {
    struct stat about {};
    EXPECT_EQ(::stat(file.c_str(), &about), 0);
    return about.st_mode & 07777;
  }
  static std::ptrdiff_t files_in(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  }
  void expect_refused(const fs::path& file, std::string_view why) const {
    const auto written = write_file(file, "new");
    ASSERT_FALSE(written) << file;
    EXPECT_EQ(written.error().code, ErrorCode::Unwritable);
    EXPECT_EQ(written.error().place.file, file.string());
    EXPECT_NE(written.error().what.en.find(why), std::string::npos) << written.error().what.en;
    EXPECT_EQ(read_file(outside_ / "secret").value(), "secret");
  }
  fs::path inside_, outside_;
};

TEST_F(NewFileTest, ShowsNothingBeforeItIsWhole) {
  ASSERT_TRUE(write_file(inside_ / "a", "old"));
  {
    auto file = NewFile::beside(inside_ / "a");
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write("n"));
    EXPECT_EQ(read_file(inside_ / "a").value(), "old");
    EXPECT_EQ(files_in(inside_), 2);
  }
  EXPECT_EQ(files_in(inside_), 1) << "what was not put in its place is gone";
  ASSERT_TRUE(write_file(inside_ / "a", "new"));
  EXPECT_EQ(read_file(inside_ / "a").value(), "new");
  EXPECT_EQ(files_in(inside_), 1);
}

TEST_F(NewFileTest, StaysUnderItsOwnNameWhenItIsKept) {
  fs::path own;
  {
    auto file = NewFile::beside(inside_ / "run.mcap", ".mcap");
    ASSERT_TRUE(file);
    own = file->path();
    file->keep();
    ASSERT_TRUE(file->write("begun"));
  }
  EXPECT_EQ(read_file(own).value(), "begun");
  EXPECT_EQ(own.extension(), ".mcap");
  EXPECT_TRUE(own.filename().string().starts_with("run.part-"));
  EXPECT_FALSE(fs::exists(inside_ / "run.mcap"));
}

TEST_F(NewFileTest, HasANameNobodyForesees) {
  const auto first = NewFile::beside(inside_ / "a"), second = NewFile::beside(inside_ / "a");
  ASSERT_TRUE(first && second);
  EXPECT_NE(first->path(), second->path()) << "of one process, for one file";
}

TEST_F(NewFileTest, KeepsTheModeOfTheFileItReplaces) {
  for (const mode_t mode : {mode_t{0600}, mode_t{0640}, mode_t{0777}, mode_t{0200}}) {
    ASSERT_TRUE(write_file(inside_ / "a", "old"));
    ASSERT_EQ(::chmod((inside_ / "a").c_str(), mode), 0);
    ASSERT_TRUE(write_file(inside_ / "a", "new"));
    EXPECT_EQ(mode_of(inside_ / "a"), mode);
  }
}

TEST_F(NewFileTest, LeavesAWriteProtectedFileAlone) {
  ASSERT_TRUE(write_file(inside_ / "a", "old"));
  for (const mode_t mode : {mode_t{0444}, mode_t{0400}, mode_t{0555}}) {
    ASSERT_EQ(::chmod((inside_ / "a").c_str(), mode), 0);
    expect_refused(inside_ / "a", "write-protected");
    EXPECT_EQ(read_file(inside_ / "a").value(), "old");
    EXPECT_EQ(mode_of(inside_ / "a"), mode);
  }
  EXPECT_EQ(files_in(inside_), 1);
}

TEST_F(NewFileTest, FollowsNoLinkAndWritesToNoDevice) {
  fs::create_symlink(outside_ / "secret", inside_ / "link");
  fs::create_symlink(outside_ / "not_there", inside_ / "broken");
  expect_refused(inside_ / "link", "it is a link");
  expect_refused(inside_ / "broken", "it is a link");
  EXPECT_FALSE(fs::exists(outside_ / "not_there"));
  ASSERT_EQ(::mkfifo((inside_ / "pipe").c_str(), 0600), 0);
  expect_refused(inside_ / "pipe", "not a regular file");
  fs::create_directories(inside_ / "folder");
  expect_refused(inside_ / "folder", "not a regular file");
  EXPECT_EQ(files_in(inside_), 4);
  // A node of its own: a program that is wrong, and root's, would replace the one that everybody uses.
  if (::mknod((inside_ / "device").c_str(), S_IFCHR | 0600, makedev(1, 3)) != 0) return;
  expect_refused(inside_ / "device", "not a regular file");
  EXPECT_TRUE(fs::is_character_file(inside_ / "device"));
}

TEST_F(NewFileTest, StaysInItsFolderWhenALinkTakesThatFoldersPlace) {
  auto file = NewFile::beside(inside_ / "a");
  ASSERT_TRUE(file);
  fs::rename(inside_, folder_ / "moved");
  fs::create_directory_symlink(outside_, inside_);
  ASSERT_TRUE(file->write("new"));
  ASSERT_TRUE(file->replace());
  EXPECT_EQ(read_file(folder_ / "moved" / "a").value(), "new");
  EXPECT_EQ(files_in(outside_), 1);
}

TEST_F(NewFileTest, GoesThroughNoLinkBeneathAFolder) {
  fs::create_directory_symlink(outside_, inside_ / "way");
  EXPECT_FALSE(write_beneath(inside_, "way/new", "new"));
  EXPECT_FALSE(write_beneath(inside_, "way/further/new", "new"));
  EXPECT_EQ(files_in(outside_), 1);
  EXPECT_TRUE(write_beneath(inside_, "made/further/new", "new"));
  EXPECT_EQ(read_beneath(inside_, "made/further/new", 3).value(), "new");
}

TEST_F(NewFileTest, OfTheLongestNamesFitTheFileSystem) {
  const fs::path file = inside_ / std::string(255, 'n');
  ASSERT_TRUE(write_file(file, "new"));
  EXPECT_EQ(read_file(file).value(), "new");
}

TEST_F(NewFileTest, TakesOnlyANameThatNothingHas) {
  ASSERT_TRUE(write_file(inside_ / "new", "new"));
  ASSERT_TRUE(write_file(inside_ / "taken", "old"));
  fs::create_symlink(outside_ / "not_there", inside_ / "link");
  EXPECT_EQ(rename_to_free(inside_ / "new", inside_ / "taken"), false);
  EXPECT_EQ(rename_to_free(inside_ / "new", inside_ / "link"), false);
  EXPECT_EQ(read_file(inside_ / "taken").value(), "old");
  EXPECT_EQ(rename_to_free(inside_ / "new", inside_ / "free"), true);
  EXPECT_EQ(read_file(inside_ / "free").value(), "new");
  EXPECT_FALSE(rename_to_free(inside_ / "new", inside_ / "free_too")) << "it is not there any more";
}

}  // namespace
}  // namespace ganglion
