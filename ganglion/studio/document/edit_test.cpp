#include "ganglion/studio/document/edit.h"

#include <gtest/gtest.h>

#include "ganglion/config/format.h"

namespace ganglion::studio {
namespace {

constexpr std::string_view kText = R"(# What it is for.
format = 1
name = "Two sonars"
robot = "robot.toml"

[[sensation]]
id = "left"
channel = "sonar_left.range"  # the better one

[[sensation]]
id = "right"
channel = "sonar_right.range"

# Gets out of corners.
[[acting]]
id = "escape"
kind = "Escape"
in.left = "left"
in.right = "right"  # swapped on the old body
trigger_range_m = 0.10  # cm were 10

[[acting]]
id = "hold"
kind = "HoldHeading"
in.heading = "left"
in.displaced_by = [
  "escape.active@previous",  # first
  "left",
]

[[coordinator]]
id = "arbiter"
kind = "Priority"
in.commands = ["escape", "hold"]  # first wins
command = "drive"

[layout]
escape = [10, 20]
hold = [30, 40]
)";

std::string edited(std::string_view text, const char* operations) {
  const auto result = edit(text, Json::parse(operations));
  EXPECT_TRUE(result) << result.error().what.en;
  if (!result) return "";
  EXPECT_EQ(config::format(result->text, "").value(), result->text) << "format must leave it as it is";
  return result->text;
}

/// The text with one passage replaced.
std::string with(std::string text, std::string_view old, std::string_view by) {
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

TEST(Edit, LeavesAFormattedTextAsItIsWhereNothingIsAsked) { EXPECT_EQ(edited(kText, "[]"), kText); }

TEST(Edit, SetsAParameterAndKeepsItsComment) {
  EXPECT_EQ(edited(kText, R"([{"op":"set","id":"escape","key":"trigger_range_m","value":0.15}])"),
            with(std::string(kText), "= 0.10  # cm", "= 0.15  # cm"));
}

TEST(Edit, AddsAParameterAtTheEndOfItsComponent) {
  EXPECT_EQ(edited(kText, R"([{"op":"set","id":"left","key":"channel","value":"a\"b"},
                             {"op":"set","id":"hold","key":"hold_s","value":3}])"),
            with(with(std::string(kText), "channel = \"sonar_left.range\"", R"(channel = "a\"b")"), "  \"left\",\n]\n",
                 "  \"left\",\n]\nhold_s = 3\n"));
}

TEST(Edit, UnsetsAParameter) {
  EXPECT_EQ(edited(kText, R"([{"op":"unset","id":"escape","key":"trigger_range_m"}])"),
            with(std::string(kText), "trigger_range_m = 0.10  # cm were 10\n", ""));
}

TEST(Edit, SetsTheNameOfTheController) {
  EXPECT_EQ(
      edited(kText,
             R"([{"op":"set","id":"","key":"name","value":"One"},{"op":"set","id":"","key":"tick_s","value":0.1}])"),
      with(with(std::string(kText), "Two sonars", "One"), "robot.toml\"\n", "robot.toml\"\ntick_s = 0.1\n"));
}

TEST(Edit, RenamesAComponentWhereverItIsNamed) {
  const std::string text = edited(kText, R"([{"op":"rename","id":"escape","to":"flee"}])");
  std::string expected = with(std::string(kText), "id = \"escape\"", "id = \"flee\"");
  expected = with(expected, "\"escape.active@previous\"", "\"flee.active@previous\"");
  expected = with(expected, "[\"escape\", \"hold\"]", "[\"flee\", \"hold\"]");
  EXPECT_EQ(text, with(expected, "escape = [10, 20]", "flee = [10, 20]"));
}

TEST(Edit, RenamesNothingThatOnlyBeginsAlike) {
  const std::string longer = with(std::string(kText), "  \"left\",", "  \"lefty\",");
  EXPECT_NE(edited(longer, R"([{"op":"rename","id":"left","to":"west"}])").find("\"lefty\""), std::string::npos);
}

TEST(Edit, RemovesAComponentWithItsWiresAndPosition) {
  const std::string text = edited(kText, R"([{"op":"remove","ids":["escape"]}])");
  std::string expected(kText);
  const auto from = expected.find("# Gets out"), to = expected.find("[[acting]]\nid = \"hold\"");
  expected.erase(from, to - from);
  expected = with(expected, "  \"escape.active@previous\",  # first\n", "  # first\n");
  expected = with(expected, "[\"escape\", \"hold\"]", "[\"hold\"]");
  EXPECT_EQ(text, with(expected, "escape = [10, 20]\n", ""));
}

TEST(Edit, RemovesThePortWhoseOnlyWireGoes) {
  const std::string text = edited(kText, R"([{"op":"remove","ids":["right"]}])");
  EXPECT_EQ(text.find("in.right"), std::string::npos);
  EXPECT_NE(text.find("in.left = \"left\""), std::string::npos);
}

TEST(Edit, RemovesTheLastAndTheMiddleOfAList) {
  const std::string three = with(std::string(kText), "[\"escape\", \"hold\"]", "[\"escape\", \"left\", \"hold\"]");
  EXPECT_NE(edited(three, R"([{"op":"disconnect","id":"arbiter","port":"commands","from":"left"}])")
                .find("[\"escape\", \"hold\"]  # first wins"),
            std::string::npos);
  EXPECT_NE(edited(three, R"([{"op":"disconnect","id":"arbiter","port":"commands","from":"hold"}])")
                .find("[\"escape\", \"left\"]  # first wins"),
            std::string::npos);
}

TEST(Edit, ConnectsASingleInputAnewAndAListOnceMore) {
  EXPECT_EQ(edited(kText, R"([{"op":"connect","from":"right","id":"escape","port":"left"},
                             {"op":"connect","from":"third","id":"arbiter","port":"commands","index":1}])"),
            with(with(std::string(kText), "in.left = \"left\"", "in.left = \"right\""), "[\"escape\", \"hold\"]",
                 "[\"escape\", \"third\", \"hold\"]"));
}

TEST(Edit, StartsAListForAPortThatTakesMany) {
  const std::string bare = with(std::string(kText), "in.commands = [\"escape\", \"hold\"]  # first wins\n", "");
  EXPECT_NE(edited(bare, R"([{"op":"connect","from":"hold","id":"arbiter","port":"commands"}])")
                .find("in.commands = [\"hold\"]"),
            std::string::npos);
}

TEST(Edit, ConnectsAtTheEndOfAListWithCommentsInIt) {
  EXPECT_EQ(edited(kText, R"([{"op":"connect","from":"right@previous","id":"hold","port":"displaced_by"}])"),
            with(std::string(kText), "  \"left\",\n]", "  \"left\",\n  \"right@previous\",\n]"));
}

TEST(Edit, ReordersAList) {
  EXPECT_EQ(edited(kText, R"([{"op":"reorder","id":"arbiter","port":"commands","order":["hold","escape"]}])"),
            with(std::string(kText), "[\"escape\", \"hold\"]", "[\"hold\", \"escape\"]"));
  EXPECT_FALSE(edit(kText, Json::parse(R"([{"op":"reorder","id":"arbiter","port":"commands","order":["hold"]}])")));
}

TEST(Edit, MovesBoxesInTheLayoutOnly) {
  EXPECT_EQ(edited(kText, R"([{"op":"move","positions":{"hold":[-5,7.6],"left":[1,2]}}])"),
            with(std::string(kText), "hold = [30, 40]\n", "hold = [-5, 8]\nleft = [1, 2]\n"));
}

TEST(Edit, MakesALayoutAtTheEndWhereThereIsNone) {
  const std::string bare(kText.substr(0, kText.find("\n[layout]")));
  EXPECT_EQ(edited(bare, R"([{"op":"move","positions":{"left":[1,2]}}])"), bare + "\n[layout]\nleft = [1, 2]\n");
}

TEST(Edit, AddsAComponentBehindThoseOfItsClass) {
  const auto result = edit(kText, Json::parse(R"([{"op":"add","class":"acting","kind":"AvoidObstacle","position":[5,6]},
      {"op":"add","class":"sensation","set":{"channel":"compass.heading"}}])"));
  ASSERT_TRUE(result) << result.error().what.en;
  EXPECT_EQ(result->ids, (std::vector<std::string>{"avoid_obstacle", "compass_heading"}));
  std::string expected = with(std::string(kText), "  \"left\",\n]\n",
                              "  \"left\",\n]\n\n[[acting]]\nid = \"avoid_obstacle\"\nkind = \"AvoidObstacle\"\n");
  expected = with(expected, "# Gets out",
                  "[[sensation]]\nid = \"compass_heading\"\nchannel = \"compass.heading\"\n\n# Gets out");
  EXPECT_EQ(result->text, expected + "avoid_obstacle = [5, 6]\n");
}

TEST(Edit, DrawsIntoAnEmptyText) {
  EXPECT_EQ(
      edited("", R"([{"op":"set","id":"","key":"format","value":1},{"op":"add","class":"acting","kind":"Escape"}])"),
      "format = 1\n\n[[acting]]\nid = \"escape\"\nkind = \"Escape\"\n");
}

TEST(Edit, PastesACopyUnderNewNames) {
  const auto copied = copy(kText, {"escape", "hold"});
  ASSERT_TRUE(copied);
  const auto result = edit(kText, {{{"op", "paste"}, {"toml", *copied}, {"offset", {100, 0}}}});
  ASSERT_TRUE(result) << result.error().what.en;
  EXPECT_EQ(result->ids, (std::vector<std::string>{"escape_2", "hold_2"}));
  EXPECT_NE(result->text.find("# Gets out of corners.\n[[acting]]\nid = \"escape_2\""), std::string::npos);
  EXPECT_NE(result->text.find("  \"escape_2.active@previous\",  # first\n  \"left\",\n"), std::string::npos);
  EXPECT_NE(result->text.find("escape_2 = [110, 20]\nhold_2 = [130, 40]\n"), std::string::npos);
  EXPECT_EQ(config::format(result->text, "").value(), result->text);
}

TEST(Edit, WritesAnInlineTableOfInputsOutWhenOneOfThemChanges) {
  const std::string text =
      with(std::string(kText), "in.left = \"left\"\nin.right = \"right\"  # swapped on the old body\n",
           "in = { left = \"left\", right = \"right\" }  # both\n");
  EXPECT_NE(edited(text, R"([{"op":"connect","from":"right","id":"escape","port":"left"}])")
                .find("# both\nin.left = \"right\"\nin.right = \"right\"\n"),
            std::string::npos);
}

TEST(Edit, KnowsInputsInATableOfTheirOwn) {
  const std::string text =
      with(std::string(kText),
           "in.left = \"left\"\nin.right = \"right\"  # swapped on the old body\ntrigger_range_m = "
           "0.10  # cm were 10\n",
           "trigger_range_m = 0.10\n\n[acting.in]\nleft = \"left\"\n");
  const std::string wired = edited(text, R"([{"op":"connect","from":"right","id":"escape","port":"right"}])");
  EXPECT_NE(wired.find("[acting.in]\nleft = \"left\"\nright = \"right\"\n"), std::string::npos);
}

TEST(Edit, KeepsWhatItCannotReadAndStillEditsTheRest) {
  const std::string broken = with(std::string(kText), "in.left = \"left\"\n", "in.left = \"left\nwhat is this\n");
  const auto result = edit(broken, Json::parse(R"([{"op":"set","id":"escape","key":"trigger_range_m","value":0.2}])"));
  ASSERT_TRUE(result) << result.error().what.en;
  EXPECT_EQ(result->text, with(broken, "= 0.10  # cm", "= 0.2  # cm"));
}

TEST(Edit, RefusesAllWhereOneOperationCannotBe) {
  const auto result = edit(kText, Json::parse(R"([{"op":"unset","id":"escape","key":"trigger_range_m"},
                                                  {"op":"rename","id":"escpe","to":"x"}])"));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().place.line, 1);
  EXPECT_NE(result.error().what.en.find("did you mean \"escape\""), std::string::npos);
}

TEST(Edit, RefusesIdsThatAreNone) {
  for (const char* id : {"", "a b", "1a", "<script>", "a\\nkind = 1", "left"}) {
    const Json operation = {{"op", "rename"}, {"id", "escape"}, {"to", id}};
    EXPECT_FALSE(edit(kText, Json::array({operation}))) << id;
  }
}

TEST(Edit, WritesHostileTextsAsPlainStrings) {
  const Json set = {{"op", "set"}, {"id", "escape"}, {"key", "preset"}, {"value", "\"\n[[acting]]\nid=\"x\x01"}};
  const auto result = edit(kText, Json::array({set}));
  ASSERT_TRUE(result);
  EXPECT_NE(result->text.find(R"(preset = "\"\u000a[[acting]]\u000aid=\"x\u0001")"), std::string::npos);
}

}  // namespace
}  // namespace ganglion::studio
