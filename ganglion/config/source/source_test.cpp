#include <gtest/gtest.h>

#include <array>

#include "ganglion/config/source/sheet.h"
#include "ganglion/config/source/tolerant.h"

namespace ganglion::config {
namespace {

constexpr std::array<std::string_view, 2> kLists = {"pump", "valve"};

constexpr const char* kText = R"(name = "Plant"

# Feeds the boiler.
[[pump]]
id = "feed"
flow = 3  # litres
[pump.in]
level = "tank"

[[lamp]]
id = "red"

[[valve]]
id = "safety"
in = { pressure = "boiler", level = "tank" }
)";

TEST(SourceMap, TellsWhereSectionsAndMembersStand) {
  const SourceMap map = map_source(kText);
  ASSERT_EQ(map.sections.size(), 5u);  // the nameless one first
  EXPECT_EQ(map.sections[0].members[0].lines.of(kText), "name = \"Plant\"\n");
  const SectionSource& pump = map.sections[1];
  EXPECT_TRUE(pump.list);
  EXPECT_EQ(pump.line, 4);
  EXPECT_TRUE(std::string_view(kText).substr(pump.begin).starts_with("# Feeds"));
  EXPECT_EQ(pump.member("flow")->value.of(kText), "3");
  EXPECT_EQ(pump.member("flow")->line, 6);
  EXPECT_EQ(pump.member("head"), nullptr);
}

TEST(SourceMap, EndsAValueThatIsNotClosedWithItsLine) {
  const char* text = "a = [1,\nb = 2\n";
  const SourceMap map = map_source(text);
  ASSERT_EQ(map.sections[0].members.size(), 2u);
  EXPECT_EQ(map.sections[0].member("b")->value.of(text), "2");
}

TEST(SourceMap, ReadsAndWritesStringsOfToml) {
  EXPECT_EQ(unquoted("'a\\b'"), "a\\b");
  EXPECT_EQ(unquoted("\"a\\tb\""), "a\tb");
  EXPECT_EQ(unquoted("3"), "");
  EXPECT_EQ(toml_text("say \"\x01\""), "\"say \\\"\\u0001\\\"\"");
  const std::string_view list = "[\"a\", 'b' # \"c\"\n]";
  const auto found = strings_in(list, {0, list.size()});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[1].of(list), "'b'");
}

TEST(Sheet, FindsTheItemsOfItsListsWithTheirTables) {
  const Sheet sheet(kText, kLists);
  EXPECT_EQ(sheet.ids(), (std::vector<std::string>{"feed", "safety"}));
  EXPECT_EQ(sheet.find("red"), nullptr);
  EXPECT_TRUE(sheet.is_free("red"));
  EXPECT_EQ(sheet.free_id("feed"), "feed_2");
  ASSERT_TRUE(sheet.member("feed", "in.level"));
  EXPECT_EQ(sheet.member("feed", "in.level")->member->value.of(kText), "\"tank\"");
  std::vector<std::string> keys;
  for (const Sheet::Entry& entry : sheet.entries("in")) keys.push_back(entry.item->id + "." + entry.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"feed.level", "safety.pressure", "safety.level"}));
}

TEST(Sheet, WritesInThePlacesItFound) {
  Sheet sheet(kText, kLists);
  sheet.set("feed", "flow", "4");
  sheet.set("feed", "in.power", "\"grid\"");
  sheet.commit();
  EXPECT_NE(sheet.text().find("flow = 4  # litres\n[pump.in]\nlevel = \"tank\"\npower = \"grid\"\n"),
            std::string::npos);
  sheet.expand_inline("safety", "in");
  EXPECT_TRUE(sheet.text().ends_with("in.pressure = \"boiler\"\nin.level = \"tank\"\n"));
  sheet.erase("safety", *sheet.member("safety", "in.pressure"));
  sheet.commit();
  EXPECT_TRUE(sheet.text().ends_with("id = \"safety\"\nin.level = \"tank\"\n"));
}

TEST(Tolerant, PassesOverLinesThatAreNoTomlAndKeepsThePlacesOfTheRest) {
  const std::string text = "a = 1\nb = = 2\n[t]\nc = 3\nc = 4\n";
  Problems problems;
  const Value value = parse_tolerantly(text, map_source(text), "x.toml", problems);
  ASSERT_EQ(problems.size(), 2u);  // a line that is none, a key that comes twice
  EXPECT_EQ(problems.sorted()[0].place.line, 2);
  EXPECT_EQ(problems.sorted()[1].place.line, 5);
  ASSERT_NE(value.find("t"), nullptr);
  EXPECT_EQ(value.find("t")->find("c")->place().line, 4);
}

}  // namespace
}  // namespace ganglion::config
