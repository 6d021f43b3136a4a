#include "ganglion/record/place_run.h"

#include <sys/stat.h>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/record/run_recorder.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

class PlaceRun : public FolderTest {
 protected:
  /// What a run is made of, as far as these tests change it.
  struct Made {
    std::string controller_hash = "c0", world = "area", experience = "none", digest = "d0", topic = "/robot0/signals";
    bool ends = true;
  };
  /// A run that has ended, under its own name.
  fs::path record(const Made& made) const {
    McapWriterOptions options;
    options.durable = false;
    options.placing = mcap::Placing::UnderOwnName;
    auto recorder = *RunRecorder::create(wanted_, {.name = "Wall", .seed = 1, .controller_hash = made.controller_hash},
                                         std::move(options));
    recorder.attach("input/world.toml", made.world);
    recorder.attach("experience", made.experience);
    const int table = recorder.add_table(made.topic, std::vector<SignalColumn>{{"sonar", "m"}});
    recorder.write_row(table, 0, 0, std::vector<double>{0.5});
    const fs::path own = recorder.path();
    if (made.ends) EXPECT_TRUE(recorder.finish({.digest = made.digest}));
    return own;
  }
  /// The name that the run gets.
  std::string name_of(const Made& made) const {
    const fs::path own = record(made);
    const auto placed = place_run(own, wanted_);
    EXPECT_TRUE(placed);
    EXPECT_FALSE(fs::exists(own));
    return placed ? placed->filename().string() : "";
  }
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }

  const fs::path wanted_ = folder_ / "seed_0001.mcap";
};

TEST_F(PlaceRun, WritesNothingOver) {
  EXPECT_EQ(name_of({}), "seed_0001.mcap");
  EXPECT_EQ(name_of({.controller_hash = "c1"}), "seed_0001-2.mcap");
  EXPECT_EQ(name_of({.world = "another"}), "seed_0001-3.mcap");
  EXPECT_EQ(name_of({.experience = "a map"}), "seed_0001-4.mcap");
  EXPECT_EQ(name_of({.digest = "d1"}), "seed_0001-5.mcap");
  EXPECT_EQ(RunFile::read(wanted_)->info.controller_hash, "c0");
  EXPECT_EQ(RunFile::read(folder_ / "seed_0001-2.mcap")->info.controller_hash, "c1");
}

TEST_F(PlaceRun, KeepsARunOnceHoweverOftenItIsRepeated) {
  for (int times = 0; times < 3; ++times) {
    EXPECT_EQ(name_of({}), "seed_0001.mcap");
    EXPECT_EQ(name_of({.controller_hash = "c1"}), "seed_0001-2.mcap");
  }
  EXPECT_EQ(files(), 2);
}

TEST_F(PlaceRun, GivesARepeatedRunTheTimeOfNow) {
  EXPECT_EQ(name_of({}), "seed_0001.mcap");
  const auto now = fs::last_write_time(wanted_);
  fs::last_write_time(wanted_, now - std::chrono::hours(24));
  EXPECT_EQ(name_of({}), "seed_0001.mcap");
  EXPECT_GE(fs::last_write_time(wanted_), now);
}

TEST_F(PlaceRun, TakesARunOfARobotThatIsElsewhereForAnotherEachTime) {
  EXPECT_EQ(name_of({.topic = "/link/signals"}), "seed_0001.mcap");
  EXPECT_EQ(name_of({.topic = "/link/signals"}), "seed_0001-2.mcap");
}

TEST_F(PlaceRun, LeavesWhatIsNoWholeRunWhereItIs) {
  ASSERT_TRUE(write_file(wanted_, "no run"));
  EXPECT_EQ(name_of({}), "seed_0001-2.mcap");
  EXPECT_EQ(read_file(wanted_).value(), "no run");
  const std::string whole = read_file(folder_ / "seed_0001-2.mcap").value();
  ASSERT_TRUE(write_file(folder_ / "seed_0001-2.mcap", whole.substr(0, whole.size() - 10)));
  EXPECT_EQ(name_of({}), "seed_0001-3.mcap") << "the same run, but damaged";
}

TEST_F(PlaceRun, FollowsNoLinkAndWaitsForNoPipe) {
  fs::create_directories(folder_ / "outside");
  fs::rename(record({}), folder_ / "outside" / "same.mcap");
  fs::create_symlink(folder_ / "outside" / "same.mcap", wanted_);
  fs::create_symlink(folder_ / "outside" / "none.mcap", folder_ / "seed_0001-2.mcap");
  ASSERT_EQ(::mkfifo((folder_ / "seed_0001-3.mcap").c_str(), 0600), 0);
  fs::create_directories(folder_ / "seed_0001-4.mcap");
  EXPECT_EQ(name_of({}), "seed_0001-5.mcap");
  EXPECT_FALSE(fs::exists(folder_ / "outside" / "none.mcap"));
}

TEST_F(PlaceRun, LeavesTheFileWhereItIsWhenItsFolderHasGone) {
  EXPECT_EQ(place_run(folder_ / "none.mcap", wanted_).error().code, ErrorCode::Unwritable);
  const fs::path own = record({});
  EXPECT_EQ(place_run(own, folder_ / "no_folder" / "seed_0001.mcap").error().code, ErrorCode::Unwritable);
  EXPECT_TRUE(RunFile::read(own));
}

TEST_F(PlaceRun, LeavesARunThatWasCutUnderItsOwnName) {
  const fs::path own = record({.ends = false});
  EXPECT_TRUE(RunFile::read(own, Recover::Yes));
  EXPECT_FALSE(fs::exists(wanted_));
}

}  // namespace
}  // namespace ganglion
