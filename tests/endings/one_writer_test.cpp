#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "ganglion/base/testing/folder.h"
#include "ganglion/experience/store.h"
#include "ganglion/record/run_file.h"
#include "ganglion/run/run.h"
#include "tests/endings/child.h"

// Two runs at once that write into one folder, and learn into one file.
namespace ganglion {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kPathfinder = std::string(GANGLION_SOURCE_DIR) + "/experiments/pathfinder";

class OneWriter : public FolderTest {
 protected:
  OneWriter() {
    for (const char* one : {"a", "b"}) fs::create_directories(folder_ / one);
  }

  /// Every second one has other settings; three of four learn.
  std::vector<std::string> words(std::mt19937_64& draws) {
    std::vector<std::string> words = {"run",         kPathfinder,
                                      "--seed",      "1",
                                      "--set",       "run.duration_s=20",
                                      "--set",       "run.free_ground=false",
                                      "--no-report", "--json",
                                      "--out",       folder_ / "runs"};
    if (draws() % 2 == 0) words.insert(words.end(), {"--set", "run.maps_every_s=5"});
    if (draws() % 4 != 0) words.insert(words.end(), {"--experience", folder_ / "map.sqlite"});
    return words;
  }

  /// What it left is whole, or it was refused in words that name the other process.
  void expect_kept_or_refused(Child& child, pid_t other) {
    const int code = child.wait();
    if (code == 4) {
      EXPECT_NE(child.err().find("map.sqlite: is being written to by a run of"), std::string::npos) << child.err();
      EXPECT_NE(child.err().find(fmt::format("process {},", other)), std::string::npos) << child.err();
      ++refused_;
      return;
    }
    ASSERT_TRUE(code == 0 || code == 1) << code << child.err();
    const Json told = Json::parse(child.out(), nullptr, false);
    ASSERT_TRUE(told.is_object()) << child.out();
    const std::string file = told["runs"][0]["files"][0];
    const std::string digest = told["runs"][0]["digest"];
    const auto [known, fresh] = digests_.emplace(file, digest);
    EXPECT_EQ(known->second, digest) << file << " is another run now";
    fresh ? ++recorded_ : ++repeated_;
  }

  void carry_out_pair(std::mt19937_64& draws) {
    Child first(folder_ / "a", words(draws));
    const auto other = words(draws);
    const auto when = draws() % 3;
    if (when == 1) first.wait_for(folder_ / "runs" / "seed_0001.mcap", draws() % 40'000);
    const pid_t process = first.process();
    if (when == 2) first.wait();
    Child second(folder_ / "b", other);
    const pid_t other_process = second.process();
    expect_kept_or_refused(first, other_process);
    expect_kept_or_refused(second, process);
  }

  void expect_all_whole() const {
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder_ / "runs")) {
      EXPECT_EQ(entry.path().filename().string().find(".part-"), std::string::npos) << entry.path();
      if (entry.path().extension() != ".mcap") continue;
      ++files;
      const auto run = RunFile::read(entry.path());
      ASSERT_TRUE(run) << run.error().text();
      EXPECT_EQ(run->outcome->digest, digests_.at(entry.path().string()));
    }
    EXPECT_EQ(files, digests_.size());
  }

  std::map<std::string, std::string> digests_;  ///< Of each file, as the program that wrote it told.
  int recorded_ = 0, repeated_ = 0, refused_ = 0;
};

TEST_F(OneWriter, LosesNothingOfTwoRunsAtOnce) {
  const char* pairs = std::getenv("GANGLION_PAIRS");
  std::mt19937_64 draws(12);
  for (int pair = 0; pair < (pairs != nullptr ? std::atoi(pairs) : 10); ++pair) carry_out_pair(draws);
  expect_all_whole();
  auto store = ExperienceStore::open(folder_ / "map.sqlite");
  ASSERT_TRUE(store) << store.error().text();
  EXPECT_FALSE(store->load_all()->empty());
  EXPECT_TRUE(store->lease("the next")) << "nobody holds it any more";
  EXPECT_FALSE(fs::exists(folder_ / "map.beside.sqlite")) << "nobody wrote without the lease";
  fmt::print("{} recorded, {} repeated, {} refused\n", recorded_, repeated_, refused_);
}

TEST_F(OneWriter, StartsFromAllThatTheOneBeforeLearned) {
  const std::vector<std::string> words = {"run",
                                          kPathfinder,
                                          "--seed",
                                          "1",
                                          "--set",
                                          "run.duration_s=20",
                                          "--set",
                                          "run.free_ground=false",
                                          "--no-report",
                                          "--out",
                                          folder_ / "runs",
                                          "--experience",
                                          folder_ / "map.sqlite"};
  Child first(folder_ / "a", words);
  EXPECT_LE(first.wait(), 1) << first.err();
  const std::uint64_t learned = ExperienceStore::open(folder_ / "map.sqlite")->snapshot_hash().value();
  Child second(folder_ / "b", words);
  EXPECT_LE(second.wait(), 1) << second.err();
  EXPECT_NE(second.err().find("seed_0001.mcap holds another run"), std::string::npos) << second.err();
  const auto run = RunFile::read(folder_ / "runs" / "seed_0001-2.mcap");
  ASSERT_TRUE(run) << run.error().text();
  const auto known = import_parts(run->attachment(kExperienceAttachment)->bytes, "run");
  ASSERT_TRUE(known);
  EXPECT_EQ(snapshot_hash(*known), learned);
}

TEST_F(OneWriter, ComparesNoFolderOfMixedRuns) {
  const auto carry_out = [&](const std::string& seed, const std::string& set) {
    Child run(folder_, {"run", kPathfinder, "--seed", seed, "--set", "run.free_ground=false", "--set", set,
                        "--no-report", "--out", folder_ / "runs"});
    EXPECT_LE(run.wait(), 1) << run.err();
  };
  const auto compared = [&] {
    Child compare(folder_, {"runs", "compare", folder_ / "runs", "--out", folder_ / "page.html"});
    const int code = compare.wait();
    return std::pair(code, compare.err());
  };
  carry_out("1", "run.duration_s=1");
  carry_out("2", "run.duration_s=1");
  EXPECT_EQ(compared().first, 0);
  carry_out("3", "run.duration_s=2");
  const auto [code, words] = compared();
  EXPECT_EQ(code, 2);
  EXPECT_NE(words.find("holds runs of 2 controllers or settings"), std::string::npos) << words;
}

TEST_F(OneWriter, ComparesNoFolderThatHoldsASeedTwice) {
  Child run(folder_, {"run", kPathfinder, "--seed", "1", "--set", "run.duration_s=1", "--set", "run.free_ground=false",
                      "--no-report", "--out", folder_ / "runs"});
  EXPECT_LE(run.wait(), 1) << run.err();
  fs::copy_file(folder_ / "runs" / "seed_0001.mcap", folder_ / "runs" / "again.mcap");
  Child compare(folder_, {"runs", "compare", folder_ / "runs", "--out", folder_ / "page.html"});
  EXPECT_EQ(compare.wait(), 2);
  EXPECT_NE(compare.err().find("holds seed 1 twice"), std::string::npos) << compare.err();
}

}  // namespace
}  // namespace ganglion
