#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/mman.h>
#include <sys/wait.h>

#include <algorithm>
#include <random>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/experience/store.h"
#include "ganglion/experience/writer.h"

namespace ganglion {
namespace {

StoredPart part(std::string component, std::string name, std::string_view text, std::string kind = "DynamicMapRouter") {
  const auto bytes = std::as_bytes(std::span(text));
  return {std::move(component), std::move(kind), 1, std::move(name), {bytes.begin(), bytes.end()}};
}

class Experience : public FolderTest {
 protected:
  std::filesystem::path path() const { return folder_ / "robot" / "experience.sqlite"; }

  ExperienceStore open(std::int64_t now_s = 1000) const {
    auto store = ExperienceStore::open(path());
    EXPECT_TRUE(store) << store.error().text();
    store->set_clock([now_s] { return now_s; });
    return std::move(*store);
  }

  void execute_raw(const char* sql) const {
    sqlite3* connection = nullptr;
    ASSERT_EQ(sqlite3_open(path().c_str(), &connection), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(connection, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(connection);
    sqlite3_close(connection);
  }
};

TEST_F(Experience, IsThereAgainAfterReopening) {
  const std::vector<StoredPart> parts = {part("positioner", "levels", "a"), part("router", "tile 0", ""),
                                         part("router", "tile 1", std::string_view("\0\xff", 2))};
  EXPECT_EQ(*open().commit(parts), 3u);
  EXPECT_EQ(*open().load_all(), parts);
}

TEST_F(Experience, WritesOnlyPartsThatChanged) {
  EXPECT_EQ(*open(1000).commit(std::vector{part("router", "a", "1"), part("router", "b", "2")}), 2u);
  EXPECT_EQ(*open(2000).commit(std::vector{part("router", "a", "1"), part("router", "b", "2")}), 0u);
  EXPECT_EQ((*open().list())[0].saved_s, 1000);
  EXPECT_EQ(*open(3000).commit(std::vector{part("router", "a", "1"), part("router", "b", "three")}), 1u);
  const auto list = *open().list();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].component, "router");
  EXPECT_EQ(list[0].kind, "DynamicMapRouter");
  EXPECT_EQ(list[0].parts, 2u);
  EXPECT_EQ(list[0].bytes, 6u);
  EXPECT_EQ(list[0].saved_s, 3000);
}

TEST_F(Experience, OfAnotherKindUnderTheSameIdIsDropped) {
  auto store = open();
  ASSERT_TRUE(store.commit(std::vector{part("router", "a", "1"), part("router", "b", "2"), part("other", "a", "3")}));
  ASSERT_TRUE(store.commit(std::vector{part("router", "a", "1", "CausalInference")}));
  EXPECT_EQ(*store.load_all(), (std::vector{part("other", "a", "3"), part("router", "a", "1", "CausalInference")}));
}

TEST_F(Experience, IsForgottenByComponent) {
  auto store = open();
  ASSERT_TRUE(store.commit(std::vector{part("router", "a", "1"), part("router", "b", "2"), part("other", "a", "3")}));
  EXPECT_EQ(*store.forget("router"), 2u);
  EXPECT_EQ(*store.forget("router"), 0u);
  EXPECT_EQ(*store.load_all(), std::vector{part("other", "a", "3")});
}

TEST_F(Experience, HasAHashThatDoesNotDependOnTheOrder) {
  std::vector<StoredPart> parts = {part("a", "x", "1"), part("a", "y", "2"), part("b", "x", "3")};
  const auto hash = snapshot_hash(parts);
  ASSERT_TRUE(open().commit(parts));
  EXPECT_EQ(*open().snapshot_hash(), hash);
  std::reverse(parts.begin(), parts.end());
  EXPECT_EQ(snapshot_hash(parts), hash);
  EXPECT_EQ(export_parts(parts), export_parts(*open().load_all()));
  parts[0].version = 2;
  EXPECT_NE(snapshot_hash(parts), hash);
  std::swap(parts[1].bytes, parts[2].bytes);
  EXPECT_NE(snapshot_hash(parts), hash);
}

TEST_F(Experience, IsExportedAndImported) {
  const std::vector<StoredPart> parts = {part("a", "x", "1"), part("a", "y", ""), part("b", "x", "3")};
  const auto imported = import_parts(export_parts(parts), "run.mcap: experience");
  ASSERT_TRUE(imported) << imported.error().text();
  EXPECT_EQ(*imported, parts);
  EXPECT_EQ(import_parts(export_parts({}), "empty")->size(), 0u);
}

TEST_F(Experience, SeesEveryDamageInAnExport) {
  const std::string good = export_parts(std::vector{part("a", "x", "1"), part("b", "x", "3")});
  for (std::size_t cut = 0; cut < good.size(); ++cut) {
    EXPECT_FALSE(import_parts(std::string_view(good).substr(0, cut), "cut")) << cut;
    std::string flipped = good;
    flipped[cut] = static_cast<char>(flipped[cut] ^ 4);
    EXPECT_FALSE(import_parts(flipped, "flipped")) << cut;
  }
}

TEST_F(Experience, OverItsLimitIsNotLoaded) {
  EXPECT_EQ(*open().commit(std::vector{part("router", "a", "12345"), part("router", "b", "123456")}), 2u);
  EXPECT_TRUE(ExperienceStore::open(path(), 11)->load_all());
  const auto refused = ExperienceStore::open(path(), 10)->load_all();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(), path().string() + ": holds 11 bytes; the limit is 10");
  EXPECT_EQ(refused.error().code, ErrorCode::TooLarge);
}

TEST_F(Experience, ExportedOverTheLimitIsNotRead) {
  // More than a GiB of which one page is there.
  const std::string begin = export_parts({});
  const std::size_t size = kMaxExperienceBytes + 1;
  void* const memory =
      ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  std::copy(begin.begin(), begin.end(), static_cast<char*>(memory));
  const auto refused = import_parts({static_cast<const char*>(memory), size}, "a.experience");
  ::munmap(memory, size);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(), "a.experience: has 1073741825 bytes; the limit is 1073741824");
}

TEST_F(Experience, OfANewerProgramIsRefusedInWords) {
  ASSERT_TRUE(open().commit(std::vector{part("a", "x", "1")}));
  execute_raw("PRAGMA user_version = 9");
  const auto refused = ExperienceStore::open(path());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Unsupported);
  EXPECT_NE(refused.error().text().find("written by a newer program (its version is 9"), std::string::npos);
}

TEST_F(Experience, NamesAPartThatWasDamaged) {
  ASSERT_TRUE(open().commit(std::vector{part("a", "x", "1"), part("router", "tile 1", "2")}));
  execute_raw("UPDATE part SET bytes = 'z' WHERE component = 'router'");
  const auto loaded = open().load_all();
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().code, ErrorCode::Corrupt);
  EXPECT_NE(loaded.error().what.en.find("part \"tile 1\" of \"router\""), std::string::npos);
  EXPECT_NE(loaded.error().what.es.find("la parte \"tile 1\" de \"router\""), std::string::npos);
  ASSERT_TRUE(open().forget("router"));
  EXPECT_EQ(open().load_all()->size(), 1u);
}

TEST_F(Experience, FromADamagedFileIsRefusedOrReadButNeverACrash) {
  {
    auto store = open();
    std::vector<StoredPart> parts;
    for (int i = 0; i < 50; ++i) parts.push_back(part("router", "tile " + std::to_string(i), std::string(500, 'x')));
    ASSERT_TRUE(store.commit(parts));
  }
  const std::string good = *read_file(path());
  std::mt19937_64 random(1);
  int refused = 0;
  for (int round = 0; round < 200; ++round) {
    std::string bad = good;
    for (int i = 0; i < 20; ++i) bad[random() % bad.size()] = static_cast<char>(random());
    if (round % 4 == 0) bad.resize(random() % bad.size());
    ASSERT_TRUE(write_file(path(), bad));
    const auto store = ExperienceStore::open(path());
    if (!store || !store->load_all()) ++refused;
  }
  EXPECT_GT(refused, 100);
}

/// Commits two equal parts again and again, telling the pipe after each commit.
[[noreturn]] void commit_for_ever(const std::filesystem::path& path, int pipe_end) {
  auto store = ExperienceStore::open(path);
  if (!store) ::_exit(1);
  for (std::uint32_t i = 1;; ++i) {
    const std::string text = std::to_string(i);
    if (!store->commit(std::vector{part("a", "x", text), part("b", "y", text)})) ::_exit(2);
    if (::write(pipe_end, &i, sizeof i) != sizeof i) ::_exit(3);
  }
}

TEST_F(Experience, LosesNothingCommittedWhenKilled) {
  for (std::uint32_t round = 0; round < 15; ++round) {
    std::filesystem::remove_all(path().parent_path());
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) commit_for_ever(path(), ends[1]);
    ::close(ends[1]);
    std::uint32_t told = 0;
    while (told < 3 * round && ::read(ends[0], &told, sizeof told) == sizeof told) {
    }
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
    while (::read(ends[0], &told, sizeof told) == sizeof told) {  // what it still told before it died
    }
    ::close(ends[0]);
    const auto parts = open().load_all();
    ASSERT_TRUE(parts) << parts.error().text();
    if (told == 0 && parts->empty()) continue;
    ASSERT_EQ(parts->size(), 2u);
    EXPECT_EQ((*parts)[0].bytes, (*parts)[1].bytes) << "half a commit";
    const std::string text(reinterpret_cast<const char*>((*parts)[0].bytes.data()), (*parts)[0].bytes.size());
    EXPECT_GE(std::stoul(text), told);
  }
}

TEST_F(Experience, SubmittedIsCommittedByTheWriter) {
  ExperienceWriter writer(open());
  for (int i = 0; i <= 100; ++i) writer.submit({part("router", "a", std::to_string(i)), part("router", "b", "same")});
  ASSERT_TRUE(writer.flush());
  EXPECT_EQ(*open().load_all(), (std::vector{part("router", "a", "100"), part("router", "b", "same")}));
}

TEST_F(Experience, SubmittedLastIsCommittedWhenTheWriterEnds) {
  {
    ExperienceWriter writer(open());
    writer.submit({part("router", "a", "1")});
    writer.submit({part("router", "b", "2")});
  }
  EXPECT_EQ(open().load_all()->size(), 2u);
}

TEST_F(Experience, ThatCouldNotBeCommittedIsKeptForTheNextTry) {
  auto store = open();
  ASSERT_TRUE(store.commit(std::vector{part("router", "a", "old")}));
  ExperienceWriter writer(std::move(store));
  execute_raw("CREATE TRIGGER full BEFORE INSERT ON part BEGIN SELECT RAISE(ABORT, 'disk full'); END");
  writer.submit({part("router", "a", "first"), part("router", "b", "2")});
  const auto failed = writer.flush();
  ASSERT_FALSE(failed);
  EXPECT_NE(failed.error().what.en.find("disk full"), std::string::npos);
  EXPECT_FALSE(writer.status());
  execute_raw("DROP TRIGGER full");
  writer.submit({part("router", "a", "newer")});
  EXPECT_TRUE(writer.flush());
  EXPECT_TRUE(writer.status());
  EXPECT_EQ(*open().load_all(), (std::vector{part("router", "a", "newer"), part("router", "b", "2")}));
}

}  // namespace
}  // namespace ganglion
