// A learning run is killed at any moment: what is left must be what the run knew at one moment, not long before.
#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>
#include <unordered_map>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/run/recording.h"
#include "ganglion/run/run.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSeed = 1;
constexpr double kMostLost_s = 1.5;
constexpr double kLongest_s = 1.4;  // after which every run was killed

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// When each tick was over, told by the run in memory that outlives it.
class Told {
 public:
  Told() {
    void* const memory = ::mmap(nullptr, sizeof(Ticks), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) std::abort();
    ticks_ = new (memory) Ticks;
  }
  Told(const Told&) = delete;
  Told& operator=(const Told&) = delete;
  ~Told() { ::munmap(ticks_, sizeof(Ticks)); }

  bool tell() {
    const std::size_t tick = ticks_->count;
    ticks_->over_s[tick] = now_s();
    ticks_->count = tick + 1;
    return tick + 1 < kMost;
  }
  std::size_t count() const { return ticks_->count; }
  double over_s(std::size_t tick) const { return ticks_->over_s[tick]; }

 private:
  static constexpr std::size_t kMost = 1 << 20;
  struct Ticks {
    std::atomic<std::size_t> count{0};
    std::array<double, kMost> over_s;
  };
  Ticks* ticks_;
};

/// The same run, undisturbed: what it knew after each tick.
class Undisturbed {
 public:
  explicit Undisturbed(const Prepared& prepared)
      : step_s_(prepared.step_s),
        application_(prepared.application->make().value()),
        controller_(std::move(*Controller::compile(prepared.controller, prepared.application->description(),
                                                   controller_kinds(), {.seed = kSeed}))),
        sense_(1, make_sense_frame(prepared.application->description())),
        act_(1, make_act_frame(prepared.application->description())) {
    EXPECT_TRUE(application_->reset(kSeed, 0));
    before_ = known();
  }

  void go_on_to(std::size_t ticks) {
    while (ticks_ < ticks) {
      application_->sense(sense_);
      make_canonical(sense_[0]);
      controller_.tick(sense_[0], step_s_, act_[0]);
      make_canonical(act_[0]);
      application_->step(act_, step_s_);
      controller_.grow();
      ++ticks_;
      knew_[known()] = ticks_;
    }
  }
  /// After how many ticks it knew exactly this for the last time; none where it never did.
  std::optional<std::size_t> knew(std::uint64_t what) const {
    const auto found = knew_.find(what);
    return found != knew_.end() ? std::optional(found->second) : std::nullopt;
  }
  std::uint64_t at_the_start() const { return before_; }
  std::size_t parts() const { return to_parts(controller_.experience()).size(); }

 private:
  std::uint64_t known() {
    std::uint64_t newest = 0;
    for (const LearningComponent& one : controller_.learners()) {
      for (const PartState& part : one.learner->parts()) newest += part.generation;
    }
    if (newest != newest_) hash_ = snapshot_hash(to_parts(controller_.experience()));
    newest_ = newest;
    return hash_;
  }

  double step_s_;
  std::unique_ptr<Application> application_;
  Controller controller_;
  std::vector<SenseFrame> sense_;
  std::vector<ActFrame> act_;
  std::size_t ticks_ = 0;
  std::uint64_t newest_ = 0, hash_ = 0, before_ = 0;
  std::unordered_map<std::uint64_t, std::size_t> knew_;  // for look-ups only
};

class KilledWhileLearning : public FolderTest {
 protected:
  void SetUp() override {
    FolderTest::SetUp();
    // With more goals than it could reach, so that there is always something to learn.
    const fs::path experiment = folder_ / "experiment", robot = experiment / "robot.toml";
    fs::copy(std::string(GANGLION_SOURCE_DIR) + "/experiments/pathfinder", experiment, fs::copy_options::recursive);
    std::string text = *read_file(robot);
    const std::string few = "\ngoals = 20\n";
    ASSERT_NE(text.find(few), std::string::npos);
    ASSERT_TRUE(write_file(robot, text.replace(text.find(few), few.size(), "\ngoals = 10000\n")));
    Problems problems;
    prepared_ = prepare(experiment, {{"run.duration_s", "1000000"}, {"run.stop", "[]"}}, problems);
    ASSERT_TRUE(prepared_) << problems.text();
  }

  [[noreturn]] void learn(double pace, Told& told) const {
    auto store = ExperienceStore::open(file_);
    if (!store || !store->lease("killed")) ::_exit(1);
    ExperienceWriter keeper(std::move(*store));
    RunOptions options;
    options.seed = kSeed;
    options.pace = pace;
    options.keeper = &keeper;
    options.progress = [&told](double) { return told.tell(); };
    ::_exit(run(*prepared_, options) ? 2 : 3);
  }

  /// When it was killed.
  double kill_after(double seconds, double pace, Told& told) const {
    const pid_t child = ::fork();
    if (child == 0) learn(pace, told);
    while (told.count() == 0 && ::waitpid(child, nullptr, WNOHANG) == 0) std::this_thread::yield();
    const double until_s = now_s() + seconds;
    while (now_s() < until_s) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ::kill(child, SIGKILL);
    const double killed_s = now_s();
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status)) << "ended by itself with " << WEXITSTATUS(status);
    return killed_s;
  }

  void expect_sound() const {
    sqlite3* connection = nullptr;
    ASSERT_EQ(sqlite3_open(file_.c_str(), &connection), SQLITE_OK);
    std::string said;
    const auto hear = [](void* to, int, char** columns, char**) {
      return *static_cast<std::string*>(to) += columns[0], 0;
    };
    EXPECT_EQ(sqlite3_exec(connection, "PRAGMA integrity_check", hear, &said, nullptr), SQLITE_OK);
    EXPECT_EQ(said, "ok");
    sqlite3_close(connection);
  }

  /// What is left serves a new run.
  void expect_loadable(const ExperienceStore& store) const {
    auto fresh =
        Controller::compile(prepared_->controller, prepared_->application->description(), controller_kinds(), {});
    ASSERT_TRUE(fresh);
    const auto parts = store.load_all();
    ASSERT_TRUE(parts) << parts.error().text();
    Problems problems;
    fresh->load(from_parts(*parts), problems);
    EXPECT_TRUE(problems.empty()) << problems.text();
  }

  fs::path file_;
  std::optional<Prepared> prepared_;
};

TEST_F(KilledWhileLearning, LosesLittleAndLeavesNothingHalfWritten) {
  const char* wanted = std::getenv("GANGLION_KILLS");
  const int kills = wanted != nullptr ? std::atoi(wanted) : 20;
  constexpr std::array kPaces = {0.0, 20.0, 200.0};  // 0: as fast as can be
  std::mt19937 random(7);
  std::uniform_real_distribution<double> moment_s(0, kLongest_s);
  Undisturbed undisturbed(*prepared_);
  std::vector<double> lost_s;
  std::size_t most_ticks = 0;
  int empty = 0;
  for (int i = 0; i < kills; ++i) {
    SCOPED_TRACE(fmt::format("kill {}", i));
    file_ = folder_ / fmt::format("map_{}.sqlite", i);
    Told told;
    const double killed_s = kill_after(moment_s(random), kPaces[static_cast<std::size_t>(i) % kPaces.size()], told);
    auto store = ExperienceStore::open(file_);
    ASSERT_TRUE(store) << store.error().text();
    expect_sound();
    expect_loadable(*store);
    EXPECT_TRUE(store->lease("the next run"));
    most_ticks = std::max(most_ticks, told.count());
    undisturbed.go_on_to(told.count() + 1);  // it may have learned in a tick that it did not tell any more
    std::uint64_t left = *store->snapshot_hash();
    if (left == 0) ++empty, left = undisturbed.at_the_start();
    const auto known = left == undisturbed.at_the_start() ? std::optional<std::size_t>(0) : undisturbed.knew(left);
    ASSERT_TRUE(known) << "a mixture of moments";
    const std::size_t kept = std::max(*known, undisturbed.knew(left).value_or(0));  // ticks
    lost_s.push_back(kept < told.count() ? killed_s - told.over_s(kept) : 0);
    EXPECT_LE(lost_s.back(), kMostLost_s);
  }
  std::sort(lost_s.begin(), lost_s.end());
  fmt::print(
      "{} kills, after at most {} ticks: lost at most {:.2f} s, median {:.2f} s; {} before anything was kept; "
      "{} parts\n",
      kills, most_ticks, lost_s.back(), lost_s[lost_s.size() / 2], empty, undisturbed.parts());
}

}  // namespace
}  // namespace ganglion
