#include "ganglion/experience/writer.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <map>

#include "ganglion/base/testing/folder.h"

namespace ganglion {
namespace {

/// Remembers words.
class Memory final : public Learner {
 public:
  std::uint32_t experience_version() const noexcept override { return 1; }
  std::span<const PartState> parts() const noexcept override { return parts_; }
  void copy(std::size_t part, std::vector<std::byte>& into) const override {
    const auto bytes = std::as_bytes(std::span(words_.at(std::string(parts_[part].name))));
    into.assign(bytes.begin(), bytes.end());
    ++copies;
  }
  void learn(const std::string& part, std::string word) {
    words_[part] = std::move(word);
    generations_[part] = ++changes_;
    list();
  }
  void lose(const std::string& part) {
    words_.erase(part);
    list();
  }
  mutable int copies = 0;

 private:
  void list() {
    parts_.clear();
    for (const auto& [name, word] : words_) parts_.push_back({name, generations_[name]});
  }
  std::map<std::string, std::string> words_;
  std::map<std::string, std::uint64_t> generations_;
  std::vector<PartState> parts_;
  std::uint64_t changes_ = 0;
};

/// What is stored of a word: the word in front of the part's name.
void encode(std::string_view part, std::span<const std::byte> raw, std::vector<std::byte>& stored) {
  stored.assign(raw.begin(), raw.end());
  const auto name = std::as_bytes(std::span(part));
  stored.insert(stored.end(), name.begin(), name.end());
}

class Writers : public FolderTest {
 protected:
  std::filesystem::path path() const { return folder_ / "map.sqlite"; }
  ExperienceStore open() const { return std::move(*ExperienceStore::open(path())); }
  /// "part:bytes part:bytes"
  std::string stored(const std::filesystem::path& file) const {
    std::string all;
    const auto parts = ExperienceStore::open(file)->load_all();
    for (const StoredPart& part : *parts) {
      all += all.empty() ? "" : " ";
      all += part.name + ":" + std::string(reinterpret_cast<const char*>(part.bytes.data()), part.bytes.size());
    }
    return all;
  }
  std::string stored() const { return stored(path()); }
  void execute_raw(const char* sql) const {
    sqlite3* connection = nullptr;
    ASSERT_EQ(sqlite3_open(path().c_str(), &connection), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(connection, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(connection);
    sqlite3_close(connection);
  }

  Memory memory_;
  std::vector<LearningComponent> learners_ = {{"router", "Memory", &memory_, encode, {{"cell_m", "0.5"}}}};
};

TEST_F(Writers, KeepWhatIsOfferedInItsStoredForm) {
  ExperienceWriter writer(open());
  memory_.learn("a", "1");
  memory_.learn("b", "2");
  EXPECT_TRUE(writer.offer(learners_));
  ASSERT_TRUE(writer.conclude(learners_));
  EXPECT_EQ(stored(), "a:1a b:2b");
  EXPECT_EQ(open().load_rests_on()->at("router"), (std::vector<RestsOn>{{"cell_m", "0.5"}}));
}

TEST_F(Writers, CopyOnlyWhatChanged) {
  ExperienceWriter writer(open());
  memory_.learn("a", "1");
  memory_.learn("b", "2");
  ASSERT_TRUE(writer.conclude(learners_));
  EXPECT_EQ(memory_.copies, 2);
  EXPECT_TRUE(writer.offer(learners_));
  EXPECT_EQ(memory_.copies, 2);
  memory_.learn("b", "3");
  ASSERT_TRUE(writer.conclude(learners_));
  EXPECT_EQ(memory_.copies, 3);
  EXPECT_EQ(stored(), "a:1a b:3b");
}

TEST_F(Writers, DropWhatIsGone) {
  ExperienceWriter writer(open());
  memory_.learn("a", "1");
  memory_.learn("b", "2");
  ASSERT_TRUE(writer.conclude(learners_));
  memory_.lose("a");
  ASSERT_TRUE(writer.conclude(learners_));
  EXPECT_EQ(stored(), "b:2b");
  memory_.learn("a", "1");  // the same as it was, but anew
  ASSERT_TRUE(writer.conclude(learners_));
  EXPECT_EQ(stored(), "a:1a b:2b");
}

TEST_F(Writers, CommitWhatTheyTookBeforeTheyEnd) {
  memory_.learn("a", "1");
  {
    ExperienceWriter writer(open());
    EXPECT_TRUE(writer.offer(learners_));
  }
  EXPECT_EQ(stored(), "a:1a");
}

TEST_F(Writers, TakeNoMoreThanTheyHavePlaceFor) {
  ASSERT_EQ(ExperienceWriter::kHandovers, 2);
  memory_.learn("a", "0");
  ExperienceWriter writer(open());
  ASSERT_TRUE(writer.conclude(learners_));
  execute_raw("CREATE TRIGGER full BEFORE INSERT ON part BEGIN SELECT RAISE(ABORT, 'disk full'); END");
  int taken = 0;
  for (int i = 1; i <= 10; ++i) {
    memory_.learn("a", std::to_string(i));
    taken += writer.offer(learners_) ? 1 : 0;
  }
  EXPECT_EQ(taken, 2);
  const auto failed = writer.conclude(learners_);
  ASSERT_FALSE(failed);
  EXPECT_NE(failed.error().what.en.find("disk full"), std::string::npos);
  EXPECT_FALSE(writer.status());
  execute_raw("DROP TRIGGER full");
  EXPECT_EQ(stored(), "a:0a");
  EXPECT_TRUE(writer.conclude(learners_));
  EXPECT_TRUE(writer.status());
  EXPECT_EQ(stored(), "a:10a") << "what found no place is in the next";
}

TEST_F(Writers, KeepAllBesideAStoreThatSomebodyElseChanged) {
  memory_.learn("a", "1");
  memory_.learn("b", "2");
  ExperienceWriter writer(open());
  ASSERT_TRUE(writer.conclude(learners_));
  EXPECT_FALSE(writer.beside());
  ASSERT_TRUE(open().rename("router", "other"));
  memory_.learn("b", "3");
  ASSERT_TRUE(writer.conclude(learners_));
  EXPECT_EQ(stored(), "a:1a b:2b") << "not written over";
  const std::string beside = (folder_ / "map.beside.sqlite").string();
  EXPECT_EQ(writer.beside(), beside);
  EXPECT_EQ(stored(beside), "a:1a b:3b") << "all of it, not only what changed";
  memory_.learn("a", "4");
  ASSERT_TRUE(writer.conclude(learners_));
  EXPECT_EQ(stored(beside), "a:4a b:3b");
}

TEST_F(Writers, DoNotWriteOverWhatLiesBesideAlready) {
  memory_.learn("a", "1");
  ExperienceWriter writer(open());
  ASSERT_TRUE(writer.conclude(learners_));
  ASSERT_TRUE(ExperienceStore::open(folder_ / "map.beside.sqlite"));
  std::filesystem::remove(path());
  memory_.learn("a", "2");
  ASSERT_TRUE(writer.conclude(learners_));
  EXPECT_EQ(stored(folder_ / "map.beside-2.sqlite"), "a:2a");
  EXPECT_FALSE(std::filesystem::exists(path()));
}

}  // namespace
}  // namespace ganglion
