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

/// The entry of a path in one of the lists; null where it is not there.
Json entry_of(const Json& list, const std::string& path) {
  for (const Json& one : list) {
    if (one["path"] == path) return one;
  }
  return {};
}

TEST_F(FolderTest, ListsMapsAndWorldsOfAnyKeyAsWorlds) {
  const auto put = [this](const std::string& name, std::string_view text) {
    ASSERT_TRUE(write_file(root_ / name, text));
  };
  put("office.yaml",
      "image: office.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n");
  put("other.yaml", "name: no map\nthis_image: a\n");
  put("floor.toml", "format = 1\n[[floor]]\nx_m = 0\ny_m = 0\nradius_m = 1\n");
  put("bump.toml", "format = 1\n[[bump]]\npoints = [[0, 0], [1, 0]]\n");
  put("beacon.toml", "format = 1\n[[beacon]]\nx_m = 0\ny_m = 0\n");
  put("area.toml", "format = 1\narea = [0, 0, 1, 1]\n");
  put("elsewhere.toml", "format = 1\nname = \"a\"\n[body]\nlength_m = 1\nwidth_m = 1\n[[sensation]]\nname = \"x\"\n");
  const Json files = Listing(folder_).json();
  for (const char* world : {"office.yaml", "floor.toml", "bump.toml", "beacon.toml", "area.toml"}) {
    EXPECT_FALSE(entry_of(files["worlds"], world).is_null()) << world;
  }
  EXPECT_EQ(entry_of(files["worlds"], "office.yaml")["name"], "office");
  EXPECT_EQ(files["worlds"].size(), 5u);
  EXPECT_FALSE(entry_of(files["robots"], "elsewhere.toml").is_null()) << "[[sensation]] does not make it a controller";
}

TEST_F(FolderTest, CountsTheProblemsOfAnExperimentsWorldUntilTheyAreMended) {
  const std::string yaml =
      "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n";
  ASSERT_TRUE(write_file(root_ / "m.yaml", yaml));
  ASSERT_TRUE(write_file(root_ / "controller.toml", "format = 1\n"));
  ASSERT_TRUE(write_file(root_ / "robot.toml", "format = 1\n"));
  ASSERT_TRUE(write_file(root_ / "e.toml",
                         "format = 1\ncontroller = \"controller.toml\"\n[application]\nrobot = "
                         "\"robot.toml\"\nworld = \"m.yaml\"\n"));
  Listing listing(folder_);
  const auto problems = [&] { return entry_of(listing.json()["experiments"], "e.toml")["problems"]; };
  EXPECT_EQ(problems(), 1) << "the picture is not there";
  ASSERT_TRUE(write_file(root_ / "m.pgm", std::string("P5\n2 2\n255\n") + std::string(4, '\xfe')));
  EXPECT_EQ(problems(), 0);
  ASSERT_TRUE(write_file(root_ / "m.yaml", "image: m.pgm\n"));
  fs::last_write_time(root_ / "m.yaml", fs::file_time_type::clock::now() + std::chrono::seconds(5));
  EXPECT_GT(problems().get<int>(), 0) << "though the experiment's own file is the same";
}

}  // namespace
}  // namespace ganglion::studio
