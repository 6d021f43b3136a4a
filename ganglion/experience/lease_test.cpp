#include "ganglion/experience/lease.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ganglion/base/testing/folder.h"
#include "ganglion/experience/store.h"

namespace ganglion {
namespace {

class Leases : public FolderTest {
 protected:
  std::filesystem::path path() const { return folder_ / "map.sqlite"; }
  ExperienceStore open() const {
    auto store = ExperienceStore::open(path());
    EXPECT_TRUE(store) << store.error().text();
    store->set_clock([] { return 1'700'000'000; });  // 2023-11-14 22:13:20 UTC
    return std::move(*store);
  }
  static ComponentUpdate learned(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {"router", "DynamicMapRouter", 1, {}, {"a"}, {{"a", {bytes.begin(), bytes.end()}}}};
  }
  static Result<CommitOutcome> commit(ExperienceStore& store, std::string_view text) {
    const ComponentUpdate update = learned(text);
    return store.commit(std::span(&update, 1));
  }
};

/// Starts a process that does `work` and then waits to be killed; comes back when the work is done.
template <class Work>
pid_t in_another_process(Work&& work) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const char ok = work() ? 'y' : 'n';
    if (::write(ends[1], &ok, 1) == 1) ::pause();
    ::_exit(1);
  }
  char ok = 'n';
  EXPECT_EQ(::read(ends[0], &ok, 1), 1);
  EXPECT_EQ(ok, 'y');
  ::close(ends[0]);
  ::close(ends[1]);
  return child;
}

TEST_F(Leases, AreHeldByOneAtATime) {
  auto first = open();
  ASSERT_TRUE(first.lease("pathfinder"));
  auto second = open();
  const auto refused = second.lease("nimrod");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Unwritable);
  EXPECT_EQ(refused.error().what.en,
            fmt::format("is being written to by a run of \"pathfinder\", process {}, since 2023-11-14 22:13 UTC; wait "
                        "for its end, or take another file",
                        ::getpid()));
  EXPECT_EQ(refused.error().what.es,
            fmt::format("lo está escribiendo una ejecución de \"pathfinder\", proceso {}, desde 2023-11-14 22:13 UTC; "
                        "espere a que termine, o use otro archivo",
                        ::getpid()));
  EXPECT_TRUE(second.load_all()) << "whoever only reads is welcome";
  EXPECT_FALSE(second.forget("router"));
  EXPECT_FALSE(second.rename("router", "other"));
}

TEST_F(Leases, AreGivenBack) {
  {
    auto first = open();
    ASSERT_TRUE(first.lease("pathfinder"));
  }
  EXPECT_TRUE(open().lease("nimrod"));
}

TEST_F(Leases, OfTheDeadAreTakenOver) {
  const pid_t child = in_another_process([this] {
    static ExperienceStore* const store = new ExperienceStore(open());
    return store->lease("the late run").has_value();
  });
  auto store = open();
  const auto refused = store.lease("heir");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.en.find(fmt::format("process {}, since", child)), std::string::npos);
  ::kill(child, SIGKILL);
  siginfo_t ended;
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT), 0);
  EXPECT_TRUE(store.lease("heir")) << "though nobody has buried it yet";
  ::waitpid(child, nullptr, 0);
}

TEST_F(Leases, TellAProcessFromALaterOneOfTheSameNumber) {
  ProcessMark mark = this_process();
  EXPECT_TRUE(is_alive(mark));
  mark.started = "before the machine was started anew";
  EXPECT_FALSE(is_alive(mark));
  EXPECT_FALSE(is_alive({0, ""}));
  EXPECT_FALSE(is_alive({-1, ""}));
  EXPECT_FALSE(is_alive({std::int64_t{1} << 40, ""}));
}

TEST_F(Leases, DoNotWriteOverWhatAnotherHasCommittedMeanwhile) {
  auto first = open();
  ASSERT_TRUE(first.lease("pathfinder"));
  ASSERT_TRUE(commit(first, "1"));
  auto second = open();
  EXPECT_FALSE(commit(second, "2")->stale) << "as a program might that thinks the first one dead";
  const auto late = commit(first, "3");
  ASSERT_TRUE(late);
  EXPECT_TRUE(late->stale);
  EXPECT_EQ(late->changes, 0u);
  EXPECT_EQ(open().load_all()->at(0).bytes, learned("2").changed[0].bytes) << "not written over";
}

TEST_F(Leases, DoNotHelpWhereTheFileIsAnotherOneByNow) {
  auto store = open();
  ASSERT_TRUE(store.lease("pathfinder"));
  std::filesystem::rename(path(), folder_ / "moved.sqlite");
  EXPECT_TRUE(commit(store, "1")->stale);
  open();
  EXPECT_TRUE(commit(store, "1")->stale);
}

}  // namespace
}  // namespace ganglion
