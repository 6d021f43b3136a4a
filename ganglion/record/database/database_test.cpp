#include "ganglion/record/database/database.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>

#include <array>
#include <cmath>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"

namespace ganglion {
namespace {

constexpr std::array<std::string_view, 2> kSteps = {"CREATE TABLE note(id INTEGER PRIMARY KEY, words TEXT)",
                                                    "ALTER TABLE note ADD COLUMN weight REAL DEFAULT 2.5"};
constexpr DatabaseLayout kNewest{.what = {"a notebook", "un cuaderno"}, .application_id = 0x6e6f7465, .steps = kSteps};
constexpr DatabaseLayout kOlder{
    .what = {"a notebook", "un cuaderno"}, .application_id = 0x6e6f7465, .steps = std::span(kSteps).first<1>()};

class DatabaseTest : public FolderTest {
 protected:
  std::filesystem::path path() const { return folder_ / "deep" / "a.sqlite"; }
};

/// Anyone else's SQLite file, or a tampered one of ours.
void execute_raw(const std::filesystem::path& path, const char* sql) {
  sqlite3* connection = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &connection), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(connection, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(connection);
  sqlite3_close(connection);
}

TEST_F(DatabaseTest, KeepsValuesOfEveryType) {
  const auto database = Database::open(path(), kNewest);
  ASSERT_TRUE(database) << database.error().text();
  auto insert = *database->prepare("INSERT INTO note VALUES (?, ?, ?)");
  insert.bind(1, std::int64_t{-7});
  insert.bind(2, std::string_view("caf\0e", 5));
  insert.bind(3, INFINITY);
  ASSERT_TRUE(insert.run());
  insert.bind(1, std::int64_t{8});
  insert.bind(2, std::string_view());
  insert.bind(3, NAN);
  ASSERT_TRUE(insert.run());
  auto select = *database->prepare("SELECT id, words, weight, words IS NULL FROM note ORDER BY id");
  ASSERT_TRUE(*select.step());
  EXPECT_EQ(select.integer(0), -7);
  EXPECT_EQ(select.text(1), std::string("caf\0e", 5));
  EXPECT_EQ(select.number(2), INFINITY);
  ASSERT_TRUE(*select.step());
  EXPECT_TRUE(std::isnan(select.number(2)));
  EXPECT_EQ(select.integer(3), 0);
  EXPECT_FALSE(*select.step());
}

TEST_F(DatabaseTest, BringsAnOlderFileUpToDateAndKeepsItsRows) {
  {
    const auto older = Database::open(path(), kOlder);
    ASSERT_TRUE(older) << older.error().text();
    ASSERT_TRUE(older->execute("INSERT INTO note VALUES (1, 'kept')"));
  }
  const auto newest = Database::open(path(), kNewest);
  ASSERT_TRUE(newest) << newest.error().text();
  auto select = *newest->prepare("SELECT words, weight FROM note");
  ASSERT_TRUE(*select.step());
  EXPECT_EQ(select.text(0), "kept");
  EXPECT_EQ(select.number(1), 2.5);
}

TEST_F(DatabaseTest, RefusesANewerFileInWords) {
  ASSERT_TRUE(Database::open(path(), kNewest));
  const auto refused = Database::open(path(), kOlder);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Unsupported);
  EXPECT_NE(refused.error().what.en.find("its version is 2, this program knows up to 1"), std::string::npos);
}

TEST_F(DatabaseTest, LeavesOtherPeoplesFilesAlone) {
  const auto other = folder_ / "other.sqlite";
  execute_raw(other, "CREATE TABLE photo(id)");
  const std::string before = *read_file(other);
  const auto refused = Database::open(other, kNewest);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Unsupported);
  EXPECT_EQ(refused.error().what.en, "is an SQLite file, but not a notebook");
  EXPECT_EQ(refused.error().what.es, "es un archivo SQLite, pero no un cuaderno");
  EXPECT_EQ(*read_file(other), before);
}

TEST_F(DatabaseTest, RefusesTablesThatOnlyLookLikeOurs) {
  ASSERT_TRUE(Database::open(path(), kNewest));
  execute_raw(path(),
              "DROP TABLE note;"
              "CREATE VIEW note AS WITH RECURSIVE n(id, words, weight) AS "
              "(SELECT 1, '', 0 UNION ALL SELECT id + 1, '', 0 FROM n) SELECT * FROM n");
  const auto refused = Database::open(path(), kNewest);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Corrupt);
}

TEST_F(DatabaseTest, RefusesWhatIsNoDatabase) {
  const auto text = folder_ / "a.txt";
  ASSERT_TRUE(write_file(text, std::string(5000, 'x')));
  EXPECT_EQ(Database::open(text, kNewest).error().code, ErrorCode::Corrupt);
  EXPECT_EQ(Database::open(folder_, kNewest).error().code, ErrorCode::Unreadable);
}

TEST_F(DatabaseTest, SurvivesMutationsOfItsFile) {
  {
    const auto database = *Database::open(path(), kNewest);
    ASSERT_TRUE(
        database.execute("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 500) "
                         "INSERT INTO note SELECT i, hex(i * 12345), i FROM n"));
  }
  const std::string good = *read_file(path());
  std::size_t refused = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    std::string bad = good;
    for (std::size_t k = 0; k < 3; ++k)
      bad[(i * 7919 + k * 104729) % (i % 2 == 0 ? 100 : bad.size())] ^= static_cast<char>(i + 1);
    ASSERT_TRUE(write_file(path(), bad));
    const auto database = Database::open(path(), kNewest);
    if (!database) ++refused;
    if (database) static_cast<void>(database->execute("SELECT max(words), sum(weight) FROM note"));
  }
  EXPECT_GT(refused, 0u);
}

TEST_F(DatabaseTest, RollsBackWhatFailed) {
  const auto database = *Database::open(path(), kNewest);
  const auto outcome = database.transaction([&]() -> Result<void> {
    EXPECT_TRUE(database.execute("INSERT INTO note VALUES (1, 'a', 1)"));
    return fail(ErrorCode::BadParameter, {"changed my mind", "cambié de idea"});
  });
  EXPECT_FALSE(outcome);
  auto count = *database.prepare("SELECT count(*) FROM note");
  ASSERT_TRUE(*count.step());
  EXPECT_EQ(count.integer(0), 0);
}

TEST_F(DatabaseTest, IsMadeAndWrittenByManyProcessesAtOnce) {
  constexpr int kProcesses = 8, kRows = 20;
  std::vector<pid_t> children;
  for (int i = 0; i < kProcesses; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      const auto database = Database::open(path(), kNewest);
      bool good = database.has_value();
      if (!good) std::fprintf(stderr, "%s\n", database.error().text().c_str());
      for (int row = 0; good && row < kRows; ++row) {
        good = database->execute(fmt::format("INSERT INTO note VALUES ({}, 'x', 1)", i * kRows + row)).has_value();
      }
      ::_exit(good ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
  const auto database = *Database::open(path(), kNewest);
  auto count = *database.prepare("SELECT count(*) FROM note");
  ASSERT_TRUE(*count.step());
  EXPECT_EQ(count.integer(0), kProcesses * kRows);
}

}  // namespace
}  // namespace ganglion
