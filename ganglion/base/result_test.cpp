#include "ganglion/base/result.h"

#include <gtest/gtest.h>

#include "ganglion/base/file.h"
#include "ganglion/base/hash.h"

namespace ganglion {
namespace {

TEST(Error, SaysItsPlaceFirst) {
  const Error error{ErrorCode::BadWire,
                    say({"\"{}\" is no sensation", "\"{}\" no es una sensación"}, "sonar_lft"),
                    {"wall.toml", 41, 12}};
  EXPECT_EQ(error.text(), "wall.toml:41:12: \"sonar_lft\" is no sensation");
  EXPECT_EQ(error.text(Language::Spanish), "wall.toml:41:12: \"sonar_lft\" no es una sensación");
  EXPECT_EQ((Error{ErrorCode::Syntax, Sentence::quoted("no place")}.text()), "no place");
}

TEST(Problems, AreSortedByLineAndListedOnce) {
  Problems problems;
  problems.add({"a.toml", 9, 1}, ErrorCode::BadType, {"second", "segundo"});
  problems.add({"a.toml", 2, 5}, ErrorCode::BadType, {"first", "primero"});
  problems.add({"a.toml", 9, 1}, ErrorCode::BadType, {"second", "segundo"});
  EXPECT_EQ(problems.text(), "a.toml:2:5: first\na.toml:9:1: second\n");
}

TEST(Problems, AreCountedBeyondWhatAnyoneMends) {
  Problems problems;
  for (int line = 1; line <= 503; ++line) problems.add({"a.toml", line, 1}, ErrorCode::BadType, {"wrong", "mal"});
  EXPECT_TRUE(problems.full());
  EXPECT_EQ(problems.size(), 500u);
  EXPECT_TRUE(problems.text().ends_with("a.toml:500:1: wrong\nand 3 more problems\n"));
  EXPECT_TRUE(problems.text(Language::Spanish).ends_with("a.toml:500:1: mal\ny 3 problemas más\n"));
}

TEST(Error, ShowsControlCharactersInsteadOfSendingThem) {
  EXPECT_EQ((Error{ErrorCode::Syntax, Sentence::quoted("\"\x1b[2J\n\" is no name")}.text()),
            "\"\\x1b[2J\\x0a\" is no name");
}

TEST(File, IsWrittenWholeAndFoldersAreRefusedAsFiles) {
  const auto folder = std::filesystem::temp_directory_path() / "ganglion_file_test";
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(write_file(folder / "deep" / "a.txt", "hello"));
  EXPECT_EQ(*read_file(folder / "deep" / "a.txt"), "hello");
  EXPECT_EQ(read_file(folder / "deep").error().code, ErrorCode::Unreadable);
  EXPECT_EQ(read_file(folder / "none").error().code, ErrorCode::NotFound);
  EXPECT_EQ(read_file(folder / "deep" / "a.txt", 4).error().code, ErrorCode::TooLarge);
  std::filesystem::remove_all(folder);
}

TEST(Hash, OfNamesIsFnv1a) {
  EXPECT_EQ(hash_name(""), 0xcbf29ce484222325u);   // published offset basis
  EXPECT_EQ(hash_name("a"), 0xaf63dc4c8601ec8cu);  // published test vector
}

TEST(CanonicalBits, FoldsZerosAndNans) {
  EXPECT_EQ(canonical_bits(-0.0), canonical_bits(0.0));
  EXPECT_EQ(canonical_bits(-std::numeric_limits<double>::quiet_NaN()),
            canonical_bits(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace ganglion
