#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/config/format.h"
#include "ganglion/config/testing/mutator.h"
#include "ganglion/run/check_file.h"
#include "ganglion/run/run.h"

// The files people copy are the ones in experiments/: whatever happens to one is either told with its place or
// understood, and then the same after formatting.
namespace ganglion {
namespace {

namespace fs = std::filesystem;

const fs::path kExperiments = fs::path(GANGLION_SOURCE_DIR) / "experiments";

/// A copy of all experiments to spoil files in.
class MutatedFiles : public FolderTest {
 protected:
  MutatedFiles() {
    fs::copy(kExperiments, folder_, fs::copy_options::recursive);
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      if (entry.path().extension() == ".toml") files_.push_back(entry.path());
    }
    std::sort(files_.begin(), files_.end());
  }

  static Problems judged(const fs::path& file, const std::string& text) {
    EXPECT_TRUE(write_file(file, text));
    Problems problems;
    check_file(file, problems);
    return problems;
  }

  /// Whether it was accepted.
  static bool judge(const fs::path& file, const std::string& text) {
    const Problems problems = judged(file, text);
    for (const Error& error : problems.sorted()) {
      EXPECT_FALSE(error.place.file.empty()) << error.text() << "\n" << text;
      EXPECT_GT(error.place.line, 0) << error.text() << "\n" << text;
    }
    if (!problems.empty()) return false;
    const auto formatted = config::format(text, file.string());
    EXPECT_TRUE(formatted) << text;
    if (!formatted) return true;
    EXPECT_TRUE(config::equal(*config::parse(text, ""), *config::parse(*formatted, ""))) << text;
    EXPECT_EQ(judged(file, *formatted).text(), "") << text;
    return true;
  }

  std::vector<fs::path> files_;
};

TEST_F(MutatedFiles, AreRejectedWithAPlaceOrUnderstoodAndKept) {
  ASSERT_FALSE(files_.empty());
  config::Mutator mutator(3);
  int accepted = 0, rejected = 0;
  for (std::size_t i = 0; i < 5000; ++i) {
    const fs::path& file = files_[i % files_.size()];
    const std::string good = *read_file(file);
    ++(judge(file, mutator.mutated(good)) ? accepted : rejected);
    ASSERT_TRUE(write_file(file, good));
  }
  EXPECT_GT(accepted, 250);
  EXPECT_GT(rejected, 2000);
}

/// The experiment of that folder, begun as `ganglion run` would, but for its ticks. Whether it was refused.
bool refused(const fs::path& experiment) {
  Problems problems;
  const auto prepared = prepare(experiment, {}, problems);
  if (!prepared) return true;
  const auto result = run(*prepared, {.seed = prepared->experiment.seed, .armed = [] { return false; }});
  return !result.has_value();
}

TEST_F(MutatedFiles, AreJudgedByCheckAsByARunThatBegins) {
  config::Mutator mutator(11);
  std::vector<fs::path> files;
  for (const fs::path& file : files_) {
    const std::string name = file.filename().string();
    if (name == "experiment.toml" || name == "controller.toml" || name == "robot.toml" || name == "process.toml") {
      files.push_back(file);
    }
  }
  ASSERT_GE(files.size(), 9u);
  int sound = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    const fs::path& file = files[i % files.size()];
    const std::string good = *read_file(file), spoilt = mutator.mutated(good);
    ASSERT_TRUE(write_file(file, spoilt));
    const fs::path experiment = file.parent_path() / "experiment.toml";
    Problems problems;
    check_file(experiment, problems);
    EXPECT_EQ(!problems.empty(), refused(experiment)) << problems.text() << spoilt;
    sound += problems.empty() ? 1 : 0;
    ASSERT_TRUE(write_file(file, good));
  }
  EXPECT_GT(sound, 20);
  EXPECT_LT(sound, 280);
}

TEST_F(MutatedFiles, CheckFindsThatARobotHasNoPlace) {
  const fs::path file = folder_ / "nimrod" / "experiment.toml";
  std::string text = *read_file(file);
  constexpr std::string_view kRoom = "clearance_m = 0.3";
  ASSERT_NE(text.find(kRoom), std::string::npos);
  ASSERT_TRUE(write_file(file, text.replace(text.find(kRoom), kRoom.size(), "clearance_m = 90")));
  Problems problems;
  check_file(file, problems);
  EXPECT_NE(problems.text(), "") << "no room of 90 m round any place";
}

}  // namespace
}  // namespace ganglion
