#include "ganglion/report/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "ganglion/plot/testing/markup.h"
#include "ganglion/plot/testing/sample_run.h"
#include "ganglion/report/embedded.h"
#include "ganglion/report/player_data.h"
#include "ganglion/report/words.h"

/// Fontconfig keeps what it found until the process ends; that is no leak of ours.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }  // NOLINT: the name is LSan's

namespace ganglion::report {
namespace {

using plot::Language;
using plot::RunView;

std::string page_of(const RunView& run, Language language = Language::English) {
  const auto html = report_page(run, {language});
  EXPECT_TRUE(html) << html.error().what.en;
  return html.value_or("");
}

/// All that stands between two marks, each time they occur.
std::vector<std::string> between(const std::string& text, std::string_view begin, std::string_view end) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    at += begin.size();
    found.push_back(text.substr(at, text.find(end, at) - at));
  }
  return found;
}

bool has_word(std::string_view key) {
  return std::ranges::any_of(kEntries, [&](const Entry& entry) { return std::string_view(entry.key) == key; });
}

/// A run as wide as the manual promises: 120 s at 10 Hz, twelve sonars.
RunView wide_run(double duration_s) {
  RunView run = plot::sample_behaviour_run(1, duration_s);
  for (int i = 0; i < 10; ++i) run.robots[0].sensors.push_back(run.robots[0].sensors[0]);
  return run;
}

TEST(Report, AsksNothingOfAnyNetwork) {
  const std::string html = page_of(plot::sample_router_run());
  for (const std::string_view mark :
       {"http://", "https://", "src=\"", "<link", "@import", "fetch(", "XMLHttpRequest", "WebSocket"})
    EXPECT_EQ(html.find(mark), std::string::npos) << mark;
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
}

TEST(Report, TakesLessThanAMegabyteForTwoMinutes) { EXPECT_LT(page_of(wide_run(120)).size(), 1'000'000u); }

TEST(Report, ThinsOutALongRun) {
  EXPECT_LT(player_data(wide_run(3600)).size(), 900'000u);
  EXPECT_GT(player_data(wide_run(3600)).size(), 300'000u);
}

TEST(Report, StaysMarkupWhateverTheNamesSay) {
  RunView run = plot::sample_behaviour_run(2, 5);
  const std::string attack = "</script><script>alert(1)</script><img src=x onerror=alert(1)>\"'";
  run.name = run.robots[0].name = run.robots[0].sensors[0].id = run.robots[0].coordinations[0].coordinator = attack;
  run.robots[0].coordinations[0].candidates[1] = run.measures[0].name = attack;
  run.outcome->reason = run.outcome->criterion = run.events[0].text = {attack, attack};
  run.outcome->digest = run.robots[1].signals.columns[2].name = attack;
  const std::string html = page_of(run);
  EXPECT_EQ(between(html, "<script", ">").size(), 3u);  // two blocks of data and the player
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_EQ(html.find("<script>"), std::string::npos);
  EXPECT_NE(html.find("&lt;/script&gt;"), std::string::npos);
}

TEST(Report, SaysEventsInBothLanguagesAndWhichIsInEnglishOnly) {
  const std::string html = page_of(plot::sample_behaviour_run(1, 5), Language::Spanish);
  EXPECT_NE(html.find("<span class=\"said-es\" lang=\"es\">empezó</span>"), std::string::npos);
  EXPECT_NE(html.find("<span lang=\"en\">stuck</span>"), std::string::npos);
}

TEST(Report, ShowsEveryFormInPictureAndPlayer) {
  const std::string html = page_of(plot::sample_exhibits_run());
  const auto block = between(html, "id=\"run\">", "</script>");
  ASSERT_EQ(block.size(), 1u);
  const auto json = nlohmann::json::parse(block[0], nullptr, false);
  std::map<std::string, int> forms;
  for (const auto& exhibit : json["exhibits"]) ++forms[exhibit["of"]];
  EXPECT_EQ(forms, (std::map<std::string, int>{
                       {"field", 2}, {"frame", 2}, {"marks", 1}, {"curve", 1}, {"bars", 1}, {"network", 1}}));
  EXPECT_TRUE(json["robots"][0]["columns"].contains("truth.yaw_rad"));
  EXPECT_NE(html.find("data-en=\"Meadow: Warmth\" data-es=\"Prado: Calor\""), std::string::npos);
  EXPECT_NE(html.find("data-en=\"a pit\" data-es=\"un foso\""), std::string::npos);
  EXPECT_NE(html.find("data-en=\"Warmth, 10 to 30 degC\" data-es=\"Calor, de 10 a 30 degC\""), std::string::npos);
  EXPECT_EQ(between(html, "<figcaption", ">").size(),
            9u);  // way, marks, two fields, behaviours, signals and three more
}

TEST(Player, HasAShapeForTheTimeItWasThere) {
  const auto block = between(page_of(plot::sample_exhibits_run()), "id=\"run\">", "</script>");
  const auto json = nlohmann::json::parse(block.at(0), nullptr, false);
  for (const auto& exhibit : json["exhibits"]) {
    if (exhibit["of"] != "marks") continue;
    std::vector<std::string> goal;
    for (const auto& shape : exhibit["shapes"]) {
      if (shape.value("id", "") == "goal 1")
        goal.push_back(fmt::format("{} {} {}", shape["role"].get<std::string>(), shape["t"].get<double>(),
                                   shape.value("until", -1.0)));
    }
    EXPECT_EQ(goal, (std::vector<std::string>{"goal 0 20", "reached 20 -1"}));
    EXPECT_EQ(exhibit["shapes"].size(), 8u);  // what stays the same is told once
  }
}

TEST(Report, CarriesTheRunAsJsonThatReadsBack) {
  RunView run = plot::sample_behaviour_run(1, 5);
  run.robots[0].sensors[0].id = "</script>&";
  const auto block = between(page_of(run), "id=\"run\">", "</script>");
  ASSERT_EQ(block.size(), 1u);
  const auto json = nlohmann::json::parse(block[0], nullptr, false);
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["robots"][0]["sensors"][0]["id"], "</script>&");
  EXPECT_EQ(json["robots"][0]["t"].get<std::string>().size(), 268u);  // 50 ticks of 4 bytes in base64
}

TEST(Report, IsOfTheLanguageAskedFor) {
  for (const Language language : {Language::English, Language::Spanish}) {
    const std::string html = page_of(plot::sample_router_run(), language);
    const std::regex marked("data-word=\"([^\"]+)\">([^<]*)<");
    int seen = 0;
    for (std::sregex_iterator i(html.begin(), html.end(), marked), end; i != end; ++i, ++seen) {
      const auto entry =
          std::ranges::find_if(kEntries, [&](const Entry& e) { return std::string_view(e.key) == (*i)[1].str(); });
      ASSERT_NE(entry, kEntries.end()) << (*i)[1];
      EXPECT_EQ((*i)[2].str(), std::string_view(language == Language::Spanish ? entry->spanish : entry->english));
    }
    EXPECT_GT(seen, 40);
  }
}

/// The markup without elements that begin with `begin` (of the tag's name) and end with `end`.
std::string without(std::string html, std::string_view begin, std::string_view end) {
  for (std::size_t at = html.find(begin); at != std::string::npos; at = html.find(begin, at))
    html.erase(at, html.find(end, at) + end.size() - at);
  return html;
}

TEST(Report, HasNoWordInItsMarkupThatIsNotInTheDictionary) {
  std::string html = page_of(plot::sample_router_run(), Language::Spanish);
  html = without(html.substr(html.find("<main>")), "<script", "</script>");
  html = without(without(html, "<figure", "</figure>"), "<code", "</code>");
  html = without(without(html, "<option value=\"0", "</option>"), "<svg", "</svg>");
  // What is left after marked words and recorded words (lang) are taken out; units and numbers stay.
  html = std::regex_replace(html, std::regex("<(\\w+)[^>]*(data-word|lang=)[^>]*>[^<]*</\\1>"), "");
  html = std::regex_replace(html, std::regex("<[^>]*>|&\\w+;|m/s|[0-9.]+x"), " ");
  std::smatch word;
  EXPECT_FALSE(std::regex_search(html, word, std::regex("[A-Za-z]{2,}"))) << word.str();
}

TEST(Player, UsesOnlyWordsOfTheDictionary) {
  const std::string script(kPlayerScript);
  const auto keys = between(script, "word('", "'");
  EXPECT_GE(keys.size(), 5u);
  for (const std::string& key : keys) EXPECT_TRUE(has_word(key)) << key;
  for (const std::string& key : between(page_of(plot::sample_router_run()), "data-label=\"", "\""))
    EXPECT_TRUE(has_word(key)) << key;
}

TEST(Dictionary, HasBothLanguagesForEveryKeyOnce) {
  std::set<std::string_view> keys;
  for (const Entry& entry : kEntries) {
    EXPECT_TRUE(keys.insert(entry.key).second) << std::string_view(entry.key);
    EXPECT_FALSE(std::string_view(entry.english).empty());
    EXPECT_FALSE(std::string_view(entry.spanish).empty());
  }
}

TEST(Report, IsWrittenForRunsThatHaveNothing) {
  for (const RunView& run : {plot::empty_run(), plot::unreadable_run(), RunView{}}) {
    const std::string html = page_of(run, Language::Spanish);
    EXPECT_NE(html.find("Interrumpida"), std::string::npos);
    EXPECT_EQ(html.find("NaN"), html.find("Number.isNaN") + 9) << "only the player's own code speaks of it";
  }
}

TEST(Report, LeavesOutWhatCannotBeWatched) {
  RunView run = plot::sample_behaviour_run(1, 2);
  run.scene = {};
  run.exhibits.clear();
  run.events = {{0.5, plot::Severity::Info, {"the load changed", "cambió la carga"}}};
  for (plot::RobotView& robot : run.robots) {
    robot.track = {};
    robot.sensors.clear();
  }
  const std::string behaving = page_of(run);
  EXPECT_NE(behaving.find("id=\"bands\""), std::string::npos)
      << "which behaviour drives is watched without a place, too";
  EXPECT_EQ(behaving.find("data-layer=\"trail\""), std::string::npos);
  EXPECT_EQ(behaving.find("data-word=\"touching\""), std::string::npos);

  for (plot::RobotView& robot : run.robots) robot.coordinations.clear();
  const std::string html = page_of(run);
  for (const std::string_view mark : {"<canvas", "id=\"watch\"", "<noscript", "data-seek=", "requestAnimationFrame"})
    EXPECT_EQ(html.find(mark), std::string::npos) << mark;
  for (const std::string_view mark :
       {"the load changed", "cambió la carga", "0.50 s", "id=\"language\"", "id=\"words\""})
    EXPECT_NE(html.find(mark), std::string::npos) << mark;
}

TEST(Report, NamesEveryControlForThoseWhoCannotSeeIt) {
  const std::string html = page_of(plot::sample_router_run());
  for (const std::string& button : between(html, "<button ", ">"))
    EXPECT_TRUE(button.find("aria-label=") != std::string::npos || button.find("data-word=") != std::string::npos ||
                button.find("data-seek=") != std::string::npos)
        << button;
  for (const std::string& canvas : between(html, "<canvas ", ">"))
    EXPECT_NE(canvas.find("aria-label="), std::string::npos);
}

TEST(Report, SaysInWordsHowTheRunEnded) {
  RunView run = plot::sample_behaviour_run(1, 5);
  EXPECT_NE(page_of(run).find("Succeeded"), std::string::npos);
  run.outcome->verdict = Verdict::NotJudged;
  EXPECT_NE(page_of(run).find("badge neutral"), std::string::npos);
  EXPECT_NE(page_of(run).find("data-word=\"not_judged\">Not judged: "), std::string::npos);
  run.outcome->verdict = Verdict::Failed;
  EXPECT_NE(page_of(run).find("data-word=\"failed\">Failed"), std::string::npos);
}

}  // namespace
}  // namespace ganglion::report
