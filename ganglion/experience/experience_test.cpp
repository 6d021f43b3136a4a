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
#include "ganglion/experience/stored_hash.h"

namespace ganglion {
namespace {

StoredPart part(std::string component, std::string name, std::string_view text, std::string kind = "DynamicMapRouter") {
  const auto bytes = std::as_bytes(std::span(text));
  return {std::move(component), std::move(kind), 1, std::move(name), {bytes.begin(), bytes.end()}};
}

/// All that each of these components has.
std::vector<ComponentUpdate> updates(const std::vector<StoredPart>& parts) {
  std::vector<ComponentUpdate> result;
  for (const StoredPart& one : parts) {
    if (result.empty() || result.back().component != one.component) {
      result.push_back({one.component, one.kind, one.version, {}, {}, {}});
    }
    result.back().present.push_back(one.name);
    result.back().changed.push_back({one.name, one.bytes});
  }
  return result;
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
  EXPECT_EQ(open().commit(updates(parts))->changes, 3u);
  EXPECT_EQ(*open().load_all(), parts);
}

TEST_F(Experience, WritesOnlyPartsThatChanged) {
  EXPECT_EQ(open(1000).commit(updates({part("router", "a", "1"), part("router", "b", "2")}))->changes, 2u);
  EXPECT_EQ(open(2000).commit(updates({part("router", "a", "1"), part("router", "b", "2")}))->changes, 0u);
  EXPECT_EQ((*open().list())[0].saved_s, 1000);
  EXPECT_EQ(open(3000).commit(updates({part("router", "a", "1"), part("router", "b", "three")}))->changes, 1u);
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
  ASSERT_TRUE(store.commit(updates({part("router", "a", "1"), part("router", "b", "2"), part("other", "a", "3")})));
  ASSERT_TRUE(store.commit(updates({part("router", "a", "1", "CausalInference")})));
  EXPECT_EQ(*store.load_all(), (std::vector{part("other", "a", "3"), part("router", "a", "1", "CausalInference")}));
}

TEST_F(Experience, IsForgottenByComponent) {
  auto store = open();
  ASSERT_TRUE(store.commit(updates({part("router", "a", "1"), part("router", "b", "2"), part("other", "a", "3")})));
  EXPECT_EQ(*store.forget("router"), 2u);
  const auto again = store.forget("ohter");
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, ErrorCode::NotFound);
  EXPECT_EQ(again.error().what.en, "holds nothing of \"ohter\"; did you mean \"other\"?");
  EXPECT_EQ(*store.load_all(), std::vector{part("other", "a", "3")});
}

TEST_F(Experience, GoesToAComponentOfAnotherName) {
  auto store = open();
  auto learned = updates({part("router", "a", "1"), part("router", "b", "2"), part("other", "a", "3")});
  learned[0].rests_on = {{"cell_m", "0.5"}};
  ASSERT_TRUE(store.commit(learned));
  EXPECT_EQ(*store.rename("router", "planner"), 2u);
  EXPECT_EQ(*store.load_all(),
            (std::vector{part("other", "a", "3"), part("planner", "a", "1"), part("planner", "b", "2")}));
  EXPECT_EQ(store.load_rests_on()->at("planner"), (std::vector<RestsOn>{{"cell_m", "0.5"}}));
  const auto missing = store.rename("plannr", "x");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().what.es, "no contiene nada de \"plannr\"; ¿quiso decir \"planner\"?");
  EXPECT_EQ(missing.error().subject.choices, (std::vector<std::string>{"other", "planner"}));
  const auto taken = store.rename("planner", "other");
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().what.en, "holds something of \"other\" already; forget it first, or choose another name");
  EXPECT_EQ(store.load_all()->size(), 3u);
}

TEST_F(Experience, DropsPartsThatAreGone) {
  auto store = open();
  ASSERT_TRUE(store.commit(updates({part("other", "a", "3"), part("router", "a", "1"), part("router", "b", "2")})));
  ComponentUpdate update{"router", "DynamicMapRouter", 1, {}, {"b"}, {}};
  EXPECT_EQ(store.commit(std::span(&update, 1))->changes, 1u);
  EXPECT_EQ(*store.load_all(), (std::vector{part("other", "a", "3"), part("router", "b", "2")}));
}

TEST_F(Experience, SaysOnWhatItRests) {
  auto store = open();
  ComponentUpdate update{"router", "DynamicMapRouter", 1, {{"cell_m", "0.5"}, {"a", "1"}}, {"x"}, {{"x", {}}}};
  EXPECT_EQ(store.commit(std::span(&update, 1))->changes, 2u);
  EXPECT_EQ(store.load_rests_on()->at("router"), (std::vector<RestsOn>{{"a", "1"}, {"cell_m", "0.5"}}));
  EXPECT_EQ(store.commit(std::span(&update, 1))->changes, 0u);
  update.rests_on = {{"cell_m", "0.25"}};
  EXPECT_EQ(store.commit(std::span(&update, 1))->changes, 1u);
  EXPECT_EQ(store.load_rests_on()->at("router"), (std::vector<RestsOn>{{"cell_m", "0.25"}}));
  update.present.clear();
  update.changed.clear();
  EXPECT_EQ(store.commit(std::span(&update, 1))->changes, 2u);
  EXPECT_TRUE(store.load_rests_on()->empty());
}

TEST_F(Experience, OfAnOlderProgramIsTakenAndRestsOnNothingKnown) {
  std::filesystem::create_directories(path().parent_path());
  execute_raw(
      "CREATE TABLE part(component TEXT NOT NULL, name TEXT NOT NULL, kind TEXT NOT NULL, version INTEGER NOT NULL, "
      "hash INTEGER NOT NULL, bytes BLOB NOT NULL, saved_s INTEGER NOT NULL, PRIMARY KEY (component, name));"
      "PRAGMA application_id = 0x47414e45; PRAGMA user_version = 1");
  execute_raw(fmt::format("INSERT INTO part VALUES ('router', 'a', 'DynamicMapRouter', 1, {}, x'', 7)", stored_hash({}))
                  .c_str());
  auto store = open();
  EXPECT_EQ(store.load_all()->size(), 1u);
  EXPECT_TRUE(store.load_rests_on()->empty());
  EXPECT_EQ(store.commit(updates({part("router", "a", "new")}))->changes, 1u);
}

TEST_F(Experience, ThatHoldsNonsenseBesidesIsRefusedAndLeftAsItIs) {
  ASSERT_TRUE(open().commit(updates({part("router", "a", "1")})));
  for (const char* nonsense :
       {"DELETE FROM state", "INSERT INTO state VALUES (0, '', 0, '', 0)", "UPDATE state SET generation = -1",
        "UPDATE state SET generation = 9223372036854775807"}) {
    const std::string good = *read_file(path());
    execute_raw(nonsense);
    execute_raw("PRAGMA wal_checkpoint(TRUNCATE)");
    const std::string bad = *read_file(path());
    const auto refused = ExperienceStore::open(path());
    ASSERT_FALSE(refused) << nonsense;
    EXPECT_EQ(refused.error().code, ErrorCode::Corrupt);
    EXPECT_EQ(*read_file(path()), bad);
    ASSERT_TRUE(write_file(path(), good));
  }
  execute_raw("INSERT INTO rests_on VALUES ('router', 'cell_m', hex(zeroblob(600000)))");
  const auto refused = open().load_rests_on();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::TooLarge);
}

TEST_F(Experience, HasAHashThatDoesNotDependOnTheOrder) {
  std::vector<StoredPart> parts = {part("a", "x", "1"), part("a", "y", "2"), part("b", "x", "3")};
  const auto hash = snapshot_hash(parts);
  ASSERT_TRUE(open().commit(updates(parts)));
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
  EXPECT_EQ(open().commit(updates({part("router", "a", "12345"), part("router", "b", "123456")}))->changes, 2u);
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
  ASSERT_TRUE(open().commit(updates({part("a", "x", "1")})));
  execute_raw("PRAGMA user_version = 9");
  const auto refused = ExperienceStore::open(path());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Unsupported);
  EXPECT_NE(refused.error().text().find("written by a newer program (its version is 9"), std::string::npos);
}

TEST_F(Experience, NamesAPartThatWasDamaged) {
  ASSERT_TRUE(open().commit(updates({part("a", "x", "1"), part("router", "tile 1", "2")})));
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
    ASSERT_TRUE(store.commit(updates(parts)));
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
    if (!store->commit(updates({part("a", "x", text), part("b", "y", text)}))) ::_exit(2);
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

}  // namespace
}  // namespace ganglion
