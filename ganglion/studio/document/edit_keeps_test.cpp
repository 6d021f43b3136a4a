#include <gtest/gtest.h>

#include <sstream>

#include "ganglion/config/value.h"
#include "ganglion/studio/document/edit.h"

// A file that somebody laid out by hand: an edit changes the lines it is about, and no other byte.
namespace ganglion::studio {
namespace {

const std::string kText = R"(# Three layers.
format   = 1
name     = 'By hand'
robot    = "robot.toml"

[[sensation]]
id       = "left"
channel  = "sonar_left.range"   # the better one

[[acting]]
    id              = "escape"
    kind            = "Escape"
    in.left         = "left"
    trigger_range_m = 0.10      # as in the book
    turn_deg        = 45.0

[[acting]]
    id   = "hold"
    kind = "HoldHeading"


[[coordinator]]
id      = "arbiter"
kind    = "Priority"
command = "drive"
in.commands = [  # the first one wins
    "escape",    # out of corners
    "avoid",     # away from what is near
    "hold"       # else
]

[layout]
escape  = [ 10, 20 ]
hold    = [ 30,40 ]   # below
)";

std::string edited(const std::string& text, const char* operations) {
  const auto result = edit(text, Json::parse(operations));
  EXPECT_TRUE(result) << result.error().what.en;
  if (!result) return "";
  EXPECT_TRUE(config::parse(result->text, "")) << result->text;
  return result->text;
}

std::string with(std::string text, std::string_view old, std::string_view by) {
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

std::string with_returns(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

TEST(EditOfAFileLaidOutByHand, ChangesTheOneLineOfAParameter) {
  EXPECT_EQ(edited(kText, R"([{"op":"set","id":"escape","key":"trigger_range_m","value":0.15}])"),
            with(kText, "= 0.10  ", "= 0.15  "));
}

TEST(EditOfAFileLaidOutByHand, ChangesTheOneLineOfABoxThatMoves) {
  EXPECT_EQ(edited(kText, R"([{"op":"move","positions":{"hold":[31,40],"escape":[10,20]}}])"),
            with(kText, "[ 30,40 ]", "[31, 40]"));
}

TEST(EditOfAFileLaidOutByHand, ChangesNothingWhereTheValueIsThatAlready) {
  for (const char* same : {R"([{"op":"set","id":"escape","key":"trigger_range_m","value":0.1}])",
                           R"([{"op":"set","id":"escape","key":"turn_deg","value":45}])",
                           R"([{"op":"set","id":"","key":"name","value":"By hand"}])",
                           R"([{"op":"connect","id":"escape","port":"left","from":"left"}])",
                           R"([{"op":"rename","id":"hold","to":"hold"}])",
                           R"([{"op":"reorder","id":"arbiter","port":"commands","order":["escape","avoid","hold"]}])",
                           R"([{"op":"move","positions":{"hold":[30,40]}}])"}) {
    EXPECT_EQ(edited(kText, same), kText) << same;
  }
}

TEST(EditOfAFileLaidOutByHand, AddsALineIndentedAsItsNeighbours) {
  EXPECT_EQ(edited(kText, R"([{"op":"set","id":"hold","key":"hold_s","value":3}])"),
            with(kText, "    kind = \"HoldHeading\"\n", "    kind = \"HoldHeading\"\n    hold_s = 3\n"));
}

TEST(EditOfAFileLaidOutByHand, TakesTheCommentsOfItemsAlong) {
  EXPECT_EQ(edited(kText, R"([{"op":"reorder","id":"arbiter","port":"commands","order":["avoid","escape","hold"]}])"),
            with(kText, "    \"escape\",    # out of corners\n    \"avoid\",     # away from what is near\n",
                 "    \"avoid\",     # away from what is near\n    \"escape\",    # out of corners\n"));
  EXPECT_EQ(edited(kText, R"([{"op":"reorder","id":"arbiter","port":"commands","order":["escape","hold","avoid"]}])"),
            with(kText, "    \"avoid\",     # away from what is near\n    \"hold\"       # else\n",
                 "    \"hold\",       # else\n    \"avoid\"     # away from what is near\n"));
}

TEST(EditOfAFileLaidOutByHand, TakesTheLinesOfCommentAboveItemsAlong) {
  const std::string list = R"([
    # out of corners
    "escape",
    # away from what is near,
    # and round it
    "avoid",
    "hold",
])";
  const std::string text =
      with(kText, kText.substr(kText.find("[  # the"), kText.find("]\n\n[layout]") + 1 - kText.find("[  # the")), list);
  const std::string moved =
      edited(text, R"([{"op":"reorder","id":"arbiter","port":"commands","order":["hold","avoid","escape"]}])");
  EXPECT_EQ(moved, with(text, list, R"([
    "hold",
    # away from what is near,
    # and round it
    "avoid",
    # out of corners
    "escape",
])"));
}

TEST(EditOfAFileLaidOutByHand, LeavesACommentAboveTheFirstItemAlone) {
  const std::string text = with(kText, "    \"escape\",    # out", "    # highest first\n    \"escape\",    # out");
  const std::string moved =
      edited(text, R"([{"op":"reorder","id":"arbiter","port":"commands","order":["avoid","escape","hold"]}])");
  EXPECT_NE(moved.find("    # highest first\n    \"avoid\",     # away"), std::string::npos) << moved;
}

TEST(EditOfAFileLaidOutByHand, BreaksTheLineWhereACommentWouldSwallowWhatFollows) {
  const std::string list = "[\"escape\", \"avoid\",  # near\n    \"hold\"]";
  const std::string text =
      with(kText, kText.substr(kText.find("[  # the"), kText.find("]\n\n[layout]") + 1 - kText.find("[  # the")), list);
  const std::string moved =
      edited(text, R"([{"op":"reorder","id":"arbiter","port":"commands","order":["avoid","escape","hold"]}])");
  EXPECT_NE(moved.find("[\"avoid\",  # near\n"), std::string::npos) << moved;
  EXPECT_NE(moved.find("\"escape\",\n    \"hold\"]"), std::string::npos) << moved;
}

TEST(EditOfAFileLaidOutByHand, PutsAnItemOnALineOfItsOwn) {
  EXPECT_EQ(edited(kText, R"([{"op":"connect","id":"arbiter","port":"commands","from":"seek"}])"),
            with(kText, "\"hold\"       # else\n", "\"hold\",       # else\n    \"seek\"\n"));
  EXPECT_EQ(edited(kText, R"([{"op":"connect","id":"arbiter","port":"commands","from":"seek","index":1}])"),
            with(kText, "    \"avoid\",", "    \"seek\",\n    \"avoid\","));
}

TEST(EditOfAFileLaidOutByHand, TakesAnItemOutWithItsLine) {
  const std::string bare = with(kText, "\"avoid\",     # away from what is near\n", "\"avoid\",\n");
  EXPECT_EQ(edited(bare, R"([{"op":"disconnect","id":"arbiter","port":"commands","from":"avoid"}])"),
            with(bare, "    \"avoid\",\n", ""));
}

TEST(EditOfAFileLaidOutByHand, KeepsTheCommentOfABoxThatIsRenamed) {
  const std::string text = edited(kText, R"([{"op":"rename","id":"hold","to":"keep"}])");
  EXPECT_EQ(text, with(with(with(kText, "id   = \"hold\"", "id   = \"keep\""), "    \"hold\" ", "    \"keep\" "),
                       "hold    = [", "keep    = ["));
}

TEST(EditOfAFileLaidOutByHand, RemovesAComponentAndNothingElse) {
  const std::string text = edited(kText, R"([{"op":"remove","ids":["hold"]}])");
  std::string expected = with(kText, "[[acting]]\n    id   = \"hold\"\n    kind = \"HoldHeading\"\n\n\n", "");
  expected = with(expected, "    \"hold\"       # else\n", "           # else\n");
  EXPECT_EQ(text, with(expected, "hold    = [ 30,40 ]   # below\n", ""));
}

TEST(EditOfAFileLaidOutByHand, RemovesTwoThatEndAListTogether) {
  const std::string list = "[\"left\", \"escape\", \"hold\"]";
  const std::string text =
      with(kText, kText.substr(kText.find("[  # the"), kText.find("]\n\n[layout]") + 1 - kText.find("[  # the")), list);
  EXPECT_NE(edited(text, R"([{"op":"remove","ids":["escape","hold"]}])").find("in.commands = [\"left\", ]"),
            std::string::npos);
}

TEST(EditOfAFileLaidOutByHand, KeepsLineEndsAndTheByteOrderMark) {
  const std::string text = "\xEF\xBB\xBF" + with_returns(kText);
  const char* operations = R"([{"op":"set","id":"escape","key":"trigger_range_m","value":0.15},
      {"op":"set","id":"hold","key":"hold_s","value":3},
      {"op":"connect","id":"arbiter","port":"commands","from":"seek"},
      {"op":"connect","id":"hold","port":"heading","from":"left"},
      {"op":"move","positions":{"left":[1,2]}},
      {"op":"add","class":"acting","kind":"Escape"},
      {"op":"reorder","id":"arbiter","port":"commands","order":["seek","escape","avoid","hold"]}])";
  EXPECT_EQ(edited(text, operations), "\xEF\xBB\xBF" + with_returns(edited(kText, operations)));
}

TEST(EditOfAFileLaidOutByHand, KeepsLineEndsOfAFileThatIsLaidOutByUsBesides) {
  const std::string text = "format = 1\r\nname = \"a\"\r\n";
  EXPECT_EQ(edited(text, R"([{"op":"set","id":"","key":"tick_s","value":0.2}])"), text + "tick_s = 0.2\r\n");
}

}  // namespace
}  // namespace ganglion::studio
