#include "ganglion/config/format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace ganglion::config {
namespace {

std::string formatted(std::string_view text) {
  const auto result = format(text, "x.toml");
  EXPECT_TRUE(result) << result.error().text();
  return result ? *result : "";
}

TEST(Format, LaysAFileOutInOneWay) {
  EXPECT_EQ(formatted("\n\n# Nimrod\n\n\n\nformat=1\r\n"
                      "  name   =  \"Nim # rod\"# its name\n"
                      "[[sensation]]\n\n id='a'\n"
                      "# the right one\n[[ sensation ]]#right\nid = 'b'\nin . left = 'a'\n\n\n"),
            "# Nimrod\n\n"
            "format = 1\n"
            "name = \"Nim # rod\"  # its name\n"
            "\n[[sensation]]\nid = 'a'\n"
            "\n# the right one\n[[sensation]]  #right\nid = 'b'\nin.left = 'a'\n");
}

TEST(Format, KeepsTheSpellingOfNumbersAndStrings) {
  const std::string text =
      "a = 1_000\nb = 0xFF\nc = +1.50e+03\nd = -inf\ne = nan\nf = \"\\u00e9\\\"#\"\ng = 'C:\\x'\n"
      "\"quoted key\" = true\nh = \"\"\"\n  two # no comment\n\n lines\"\"\"\ni = '''a''''\n";
  EXPECT_EQ(formatted(text), text);
}

TEST(Format, PutsLayoutLastWithTheCommentsAboveIt) {
  EXPECT_EQ(
      formatted("a = 1\n[layout.escape]\nx = 1\n# places of the boxes\n['layout']\ny = 2\n[[acting]]\nid = 'e'\n"),
      "a = 1\n\n[[acting]]\nid = 'e'\n\n[layout.escape]\nx = 1\n\n# places of the boxes\n['layout']\ny = 2\n");
  EXPECT_EQ(formatted("[\"lay\\u006fut\"]\na = 1\n[b]\n"), "[b]\n\n[\"lay\\u006fut\"]\na = 1\n");
}

TEST(Format, KeepsShortListsOnALineAndBreaksLongOnes) {
  EXPECT_EQ(formatted("a = [ 1,2 ,\n 3, ]\nb = { x=1,y = [ ] }\nc = {}\n"),
            "a = [1, 2, 3]\nb = { x = 1, y = [] }\nc = {}\n");
  // "a = [" + 30 items of 'xx' with separators is 5 + 30 * 4 + 29 * 2 + 1 = 184 columns; 15 items are 94.
  const auto list = [](int count, const char* item, const char* open, const char* between, const char* close) {
    std::string text = open;
    for (int i = 0; i < count; ++i) text += (i == 0 ? "" : between) + std::string(item);
    return text + close;
  };
  EXPECT_EQ(formatted(list(30, "'xx'", "a=[", ",", "]")), list(30, "'xx'", "a = [\n  ", ",\n  ", ",\n]\n"));
  EXPECT_EQ(formatted(list(15, "'xx'", "a=[", ",", "]")), list(15, "'xx'", "a = [", ", ", "]\n"));
  // Columns are letters, not bytes: 24 items of one two-byte letter are 5 + 24 * 3 + 23 * 2 + 1 = 124, 19 are 99.
  EXPECT_EQ(formatted(list(19, "'ñ'", "a=[", ",", "]")), list(19, "'ñ'", "a = [", ", ", "]\n"));
}

TEST(Format, BreaksAListExactlyBeyondItsLimit) {
  const std::string word(kFormatColumns - std::string("a = [\"\"]").size(), 'w');
  EXPECT_EQ(formatted("a=[\"" + word + "\"]"), "a = [\"" + word + "\"]\n");
  EXPECT_EQ(formatted("a=[\"" + word + "w\"]"), "a = [\n  \"" + word + "w\",\n]\n");
}

TEST(Format, KeepsEveryCommentOfAList) {
  const std::string text =
      "a = [  # opens\n"
      "  # the first\n"
      "  1,  # one\n"
      "\n"
      "  # the second\n"
      "  [2, 3],\n"
      "  # the end\n"
      "]  # closes\n";
  EXPECT_EQ(formatted("a=[# opens\n# the first\n1# one\n\n\n\n, # the second\n[2,3]# the end\n]# closes"),
            "a = [  # opens\n  # the first\n  1,  # one\n\n  # the second\n  [2, 3],  # the end\n]  # closes\n");
  EXPECT_EQ(formatted(text), text);
  EXPECT_EQ(formatted("p = {x=[1, # one\n2], y=3} # p\n"), "p = { x = [\n  1,  # one\n  2,\n], y = 3 }  # p\n");
}

TEST(Format, GroupsByOneBlankLine) {
  EXPECT_EQ(formatted("[a]\n\n# about x\nx = 1\n\n\n\ny = 2\n# about b\n[b]\n# last\n"),
            "[a]\n# about x\nx = 1\n\ny = 2\n\n# about b\n[b]\n# last\n");
}

TEST(Format, LeavesAnEmptyFileEmptyAndDropsAByteOrderMark) {
  EXPECT_EQ(formatted(""), "");
  EXPECT_EQ(formatted("\n \r\n"), "");
  EXPECT_EQ(formatted("\xEF\xBB\xBF"
                      "a=1"),
            "a = 1\n");
}

TEST(Format, RefusesWhatIsNotTomlWithItsPlace) {
  const auto result = format("a = 1\nb = = 2\n", "x.toml");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().place.file, "x.toml");
  EXPECT_EQ(result.error().place.line, 2);
}

constexpr const char* kRich = R"(# Of everything something
format = 1  # always
name = "Nimrod \"the # hunter\""
text = """one
  two"""
raw = 'C:\#'

[[sensation]]
id = "left"
range_m = [0.02, 3.00]  # of the data sheet

# The middle one
[[acting]]
id = "escape"
in.left = "left"
in."right" = 'right'
table = [
  # nearer, slower
  { at_m = 0.1, turn = [1, -1] },
  { at_m = 1_0.5, turn = [1e3, +2] },  # not tried
]

[layout]
escape = [10, 20]

[run]
on = true
)";

/// Words of the text that carry meaning, in any order: what must survive formatting.
std::string letters(std::string_view text) {
  std::string kept;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) > ' ' && c != ',') kept += c;
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

std::string mutated(std::string text, std::mt19937& random) {
  constexpr std::string_view kPieces[] = {"\n",         "#", "# note\n", "\"", "'",      "[",    "]",      "{",
                                          "}",          ",", "=",        ".",  " ",      "\r\n", "\"\"\"", "'''",
                                          "[layout]\n", "x", "1",        "\\", "\n\n\n", "\t",   "ñ"};
  const auto below = [&](std::size_t limit) { return static_cast<std::size_t>(random()) % limit; };
  for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
    const std::size_t at = below(text.size());
    if (below(3) == 0) {
      text.erase(at, 1 + below(8));
    } else {
      text.insert(at, kPieces[below(std::size(kPieces))]);
    }
  }
  return text;
}

TEST(Format, ChangesNeitherValuesNorCommentsOfWhateverParses) {
  std::mt19937 random(7);
  int accepted = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::string text = mutated(kRich, random);
    const auto value = parse(text, "x.toml");
    const auto once = format(text, "x.toml");
    ASSERT_EQ(value.has_value(), once.has_value()) << text << (once ? "" : once.error().text());
    if (!once) continue;
    ++accepted;
    const auto again = parse(*once, "x.toml");
    ASSERT_TRUE(again && equal(*value, *again)) << text << "-----\n" << *once;
    ASSERT_EQ(letters(text), letters(*once)) << text << "-----\n" << *once;
    const auto twice = format(*once, "x.toml");
    ASSERT_TRUE(twice);
    ASSERT_EQ(*once, *twice) << text;
  }
  EXPECT_GT(accepted, 2'000);
}

TEST(Equal, LooksAtValuesAndNotAtPlacesOrOrder) {
  const auto same = [](const char* a, const char* b) { return equal(*parse(a, "a"), *parse(b, "b")); };
  EXPECT_TRUE(same("a = 1\nb = [1, {x = nan}]\n", "\n\nb = [1, {x = nan}]\na = 1\n"));
  EXPECT_FALSE(same("a = 1", "a = 1.0"));
  EXPECT_FALSE(same("a = 1", "a = 2"));
  EXPECT_FALSE(same("a = 'x'", "a = 'y'"));
  EXPECT_FALSE(same("a = true", "a = false"));
  EXPECT_FALSE(same("a = 1.5", "a = nan"));
  EXPECT_FALSE(same("a = [1, 2]", "a = [2, 1]"));
  EXPECT_FALSE(same("a = [1]", "a = [1, 1]"));
  EXPECT_FALSE(same("a = 1", "b = 1"));
  EXPECT_FALSE(same("a = 1", "a = 1\nb = 1"));
}

TEST(Parse, RefusesWhatLiesTooDeepInsteadOfEndingTheProgram) {
  std::string dots = "[a";
  for (int i = 0; i < 300'000; ++i) dots += ".a";
  const std::string brackets(300'000, '[');
  std::string tables = "a = ";
  for (int i = 0; i < 100; ++i) tables += "{ a.b.c.d = ";
  for (const std::string& text : {dots + "]\n", dots.substr(1) + " = 1\n", "x = 1\na = " + brackets, tables}) {
    const auto value = parse(text, "x.toml");
    ASSERT_FALSE(value);
    EXPECT_EQ(value.error().code, ErrorCode::TooLarge);
    EXPECT_GT(value.error().place.line, 0);
  }
}

TEST(Parse, CountsNoDotsOfTextCommentsOrNumbersAsDepth) {
  std::string text = "a = \"" + std::string(500, '.') + "\"  # " + std::string(500, '.') + "\nb = [";
  for (int i = 0; i < 500; ++i) text += "1.5,\n";
  EXPECT_TRUE(parse(text + "]\n", "x.toml"));
}

TEST(Parse, RefusesTablesOfTooManyKeys) {
  std::string text;
  for (int i = 0; i < 10'001; ++i) text += "k" + std::to_string(i) + " = 1\n";
  const auto value = parse(text, "x.toml");
  ASSERT_FALSE(value);
  EXPECT_EQ(value.error().code, ErrorCode::TooLarge);
}

}  // namespace
}  // namespace ganglion::config
