#include "ganglion/config/table.h"

#include <gtest/gtest.h>

namespace ganglion::config {
namespace {

constexpr const char* kText = R"(format = 1
name = "Nimrod"
speed_mps = -1
duraton_s = 5
[run]
seed = "seven"
path = "maps/a.yaml"
[[acting]]
id = "escape"
range_m = 0.1
)";

TEST(Table, GathersEveryProblemWithItsPlace) {
  const auto value = parse(kText, "dir/x.toml");
  ASSERT_TRUE(value);
  Problems problems;
  {
    Table root(*value, "", problems);
    check_format(root);
    EXPECT_EQ(root.text("name"), "Nimrod");
    EXPECT_EQ(root.number("speed_mps", 0.5, kNotNegative), 0.5);
    root.number("duration_s", 60);
    Table run = root.table("run");
    EXPECT_EQ(run.integer("seed", 1), 1);
    EXPECT_EQ(run.path("path"), "dir/maps/a.yaml");
    for (Table& acting : root.tables("acting")) {
      EXPECT_EQ(acting.text("id"), "escape");
      acting.text("kind");
      acting.number("range_m", 0.2);
    }
  }
  EXPECT_EQ(problems.text(),
            "dir/x.toml:3:13: speed_mps is -1, must be >= 0\n"
            "dir/x.toml:4:13: \"duraton_s\" is no key here; did you mean \"duration_s\"?\n"
            "dir/x.toml:6:8: run: seed is a text, must be a whole number\n"
            "dir/x.toml:8:1: kind is missing\n");
}

TEST(Table, PlacesWhatIsMissingInAnAbsentTableAtTheOneAround) {
  const auto value = parse("\n[run]\nseed = 1\n", "x.toml");
  Problems problems;
  {
    Table root(*value, "", problems);
    Table run = root.table("run");
    run.integer("seed", 1);
    run.table("stop").text("reason");
  }
  EXPECT_EQ(problems.text(), "x.toml:2:1: run.stop: reason is missing\n");
}

TEST(Table, SaysNothingMoreOfWhatIsNoTable) {
  const auto value = parse("run = 3\n", "x.toml");
  Problems problems;
  Table(*value, "", problems).table("run").text("seed");
  EXPECT_EQ(problems.text(), "x.toml:1:7: run: is a whole number, must be a table\n");
}

TEST(Parse, SaysWhereTheSyntaxBreaks) {
  const auto value = parse("a = 1\nb = = 2\n", "x.toml");
  ASSERT_FALSE(value);
  EXPECT_EQ(value.error().code, ErrorCode::Syntax);
  EXPECT_EQ(value.error().place.line, 2);
}

TEST(Override, ReachesListsByIdAndSaysWhereItCameFrom) {
  auto value = parse(kText, "x.toml");
  ASSERT_TRUE(apply(*value, *parse_override("acting.escape.range_m=0.3")));
  ASSERT_TRUE(apply(*value, *parse_override("run.stop.at = [1, 2]")));
  ASSERT_TRUE(apply(*value, *parse_override("name=My robot")));
  EXPECT_EQ(*value->find("name")->string(), "My robot");
  EXPECT_EQ(value->find("run")->find("stop")->find("at")->array()->size(), 2u);
  const Value& range = *value->find("acting")->array()->front().find("range_m");
  EXPECT_EQ(*range.real(), 0.3);
  EXPECT_EQ(range.place().file, "--set acting.escape.range_m=0.3");
  const auto unknown = apply(*value, *parse_override("acting.escpe.range_m=0.3"));
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().what.en.find("did you mean \"escape\"?"), std::string::npos);
}

}  // namespace
}  // namespace ganglion::config
