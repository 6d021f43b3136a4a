#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <atomic>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "tests/endings/child.h"

// Folders in which somebody put links, pipes, devices and protected files wherever the program writes.
namespace ganglion {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Wherever these tests have the program write.
const std::vector<std::string> kTargets = {"runs/seed_0001.mcap",
                                           "runs/seed_0001-2.mcap",
                                           "runs/seed_0001.html",
                                           "runs/seed_0001-2.html",
                                           "runs/catalogue.sqlite",
                                           "runs/catalogue.sqlite-wal",
                                           "runs/catalogue.sqlite-shm",
                                           "map.sqlite",
                                           "map.sqlite-wal",
                                           "table.csv",
                                           "saved.mcap",
                                           "layout.toml",
                                           "pictures/trajectory.svg",
                                           "tables/robot0_signals.csv"};

class HostileFolder : public FolderTest {
 protected:
  HostileFolder() : outside_(folder_ / "outside") {
    fs::create_directories(outside_);
    for (const char* name : {"victim", "other"}) EXPECT_TRUE(write_file(outside_ / name, "a = 1 # private\n"));
    before_ = content_of(outside_);
  }

  static std::map<std::string, std::string> content_of(const fs::path& folder) {
    std::map<std::string, std::string> content;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      content[entry.path().string()] = read_file(entry.path()).value_or("?");
    return content;
  }

  /// Makes the folder anew, and puts something in the way of each target.
  void make(int number) {
    inside_ = folder_ / std::to_string(number);
    fs::create_directories(inside_ / "exp");
    fs::copy(std::string(GANGLION_SOURCE_DIR) + "/experiments/nimrod", inside_ / "exp", fs::copy_options::recursive);
    swapped_.clear();
    protected_.clear();
    for (const std::string& target : kTargets) plant(inside_ / target);
  }

  void plant(const fs::path& target) {
    fs::create_directories(target.parent_path());
    switch (draws_() % 9) {
      case 0:
        return fs::create_symlink(outside_ / "victim", target);
      case 1:
        return fs::create_symlink(outside_ / "not_there", target);
      case 2:
        EXPECT_EQ(::mkfifo(target.c_str(), 0600), 0);
        return;
      case 3:
        fs::create_directories(target);
        return;
      case 4:
        if (::mknod(target.c_str(), S_IFCHR | 0600, makedev(1, 5)) != 0) fs::create_symlink("/dev/zero", target);
        return;
      case 5:
        if (target.string().ends_with("-wal") || target.string().ends_with("-shm")) return;  // SQLite's own
        EXPECT_TRUE(write_file(target, "a=1\n"));
        EXPECT_EQ(::chmod(target.c_str(), 0444), 0);
        protected_.push_back(target);
        return;
      case 6:
      case 7:
        swapped_.push_back(target);
        return;
      default:
        return;
    }
  }

  /// Puts links where files are about to be, and takes them away again, as fast as it can.
  void swap_links(const std::atomic<bool>& done) const {
    for (std::size_t n = 0; !done && !swapped_.empty(); ++n) {
      const fs::path& target = swapped_[n % swapped_.size()];
      std::error_code error;
      if (fs::is_symlink(target, error))
        fs::remove(target, error);
      else
        fs::create_symlink(outside_ / (n % 3 == 0 ? "not_there" : "other"), target, error);
      std::this_thread::yield();
    }
  }

  /// Ends with an exit code, whatever it finds.
  std::string call(std::vector<std::string> words) const {
    const std::string what = words.front() + " " + words[1];
    Child child(folder_, std::move(words));
    const int code = child.wait();
    EXPECT_TRUE(code >= 0 && code <= 4) << what << ": " << code << child.err();
    EXPECT_TRUE(code < 2 || !child.err().empty()) << what;
    return child.out();
  }

  /// The run file that was told; "" where none was.
  std::string carry_out() const {
    std::vector<std::string> words = {
        "run",   inside_ / "exp",         "--seed", "1",     "--set",         "run.duration_s=3",
        "--set", "run.free_ground=false", "--json", "--out", inside_ / "runs"};
    if (number_of_runs_++ % 2 == 0) words.insert(words.end(), {"--experience", inside_ / "map.sqlite"});
    const Json told = Json::parse(call(std::move(words)), nullptr, false);
    return told.is_object() && !told["runs"][0]["files"].empty() ? told["runs"][0]["files"][0] : Json("");
  }

  void use(const std::string& run_file) const {
    call({"runs", "list", inside_ / "runs"});
    call({"runs", "csv", inside_ / "runs", "--out", inside_ / "table.csv"});
    call({"format", inside_ / "layout.toml"});
    if (run_file.empty()) return;
    call({"runs", "signals", run_file, "--out", inside_ / "tables"});
    call({"runs", "recover", run_file, "--out", inside_ / "saved.mcap"});
    call({"plot", run_file, "--out", inside_ / "pictures"});
  }

  fs::path outside_, inside_;
  std::map<std::string, std::string> before_;
  std::vector<fs::path> swapped_, protected_;
  std::mt19937_64 draws_{50};
  mutable int number_of_runs_ = 0;
};

TEST_F(HostileFolder, HasNothingReadOrWrittenOutsideAndNothingHalf) {
  const char* folders = std::getenv("GANGLION_HOSTILE");
  int replayed = 0;
  for (int number = 0; number < (folders != nullptr ? std::atoi(folders) : 5); ++number) {
    make(number);
    std::vector<std::string> files;
    {
      std::atomic<bool> done = false;
      std::jthread swapper([&] { swap_links(done); });
      for (int times = 0; times < 2; ++times) files.push_back(carry_out());
      use(files.back());
      done = true;
    }
    EXPECT_EQ(content_of(outside_), before_) << number;
    for (const fs::path& file : protected_) EXPECT_EQ(read_file(file).value(), "a=1\n") << file;
    for (const auto& entry : fs::recursive_directory_iterator(inside_))
      EXPECT_EQ(entry.path().filename().string().find(".part-"), std::string::npos) << entry.path();
    fs::rename(inside_ / "exp", folder_ / fmt::format("moved_{}", number));
    for (const std::string& file : files) {
      if (file.empty()) continue;
      Child replay(folder_, {"replay", file});
      EXPECT_EQ(replay.wait(), 0) << replay.err() << replay.out();
      ++replayed;
    }
  }
  EXPECT_GT(replayed, 0);
}

}  // namespace
}  // namespace ganglion
