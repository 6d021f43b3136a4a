#include "ganglion/descriptor/parameter.h"

#include <gtest/gtest.h>

#include <array>

#include "ganglion/descriptor/parameters.h"

namespace ganglion {
namespace {

struct BaseConfig {
  int tries = 3;
};
struct Config : BaseConfig {
  double reach_m = 0.2;
  bool loud = true;
  enum class Side { Left, Right } side = Side::Right;
  Angle slack = Angle::from_deg(7);
  std::string word = "a";
  std::vector<double> cells = {1, 2};
  std::array<double, 2> gains = {0.5, 0.25};
};

constexpr std::array<std::string_view, 2> kSides = {"left", "right"};
constexpr auto kSecondGain = [](Config & c) -> auto& { return c.gains[1]; };
constexpr Text kAny = Text::same("x");
constexpr std::array kParameters = {
    parameter<Config, &Config::reach_m>({.name = "reach_m", .title = kAny, .help = kAny}),
    parameter<Config, &Config::tries>({.name = "tries", .title = kAny, .help = kAny}),
    parameter<Config, &Config::loud>({.name = "loud", .title = kAny, .help = kAny}),
    parameter<Config, &Config::side>({.name = "side", .title = kAny, .help = kAny, .choices = kSides}),
    parameter<Config, &Config::slack>({.name = "slack_deg", .title = kAny, .help = kAny, .unit = "deg"}),
    parameter<Config, &Config::word>({.name = "word", .title = kAny, .help = kAny}),
    parameter<Config, &Config::cells>({.name = "cells", .title = kAny, .help = kAny}),
    parameter<Config, kSecondGain>({.name = "gain", .title = kAny, .help = kAny}),
};

TEST(Parameter, TakesItsDefaultAndTypeFromTheMember) {
  const Parameters parameters(kParameters);
  EXPECT_EQ(parameters.real("reach_m"), 0.2);
  EXPECT_EQ(parameters.integer("tries"), 3);
  EXPECT_TRUE(parameters.boolean("loud"));
  EXPECT_EQ(parameters.choice("side"), "right");
  EXPECT_EQ(parameters.real("slack_deg"), 7) << "not 7.000000000000001";
  EXPECT_EQ(parameters.word("word"), "a");
  EXPECT_EQ(parameters.reals("cells").size(), 2u);
  EXPECT_EQ(parameters.real("gain"), 0.25);
}

TEST(Parameter, SaysItsValueAsText) {
  const Parameters parameters(kParameters);
  EXPECT_EQ(parameters.text("reach_m"), "0.2");
  EXPECT_EQ(parameters.text("tries"), "3");
  EXPECT_EQ(parameters.text("loud"), "true");
  EXPECT_EQ(parameters.text("side"), "right");
  EXPECT_EQ(parameters.text("word"), "a");
  EXPECT_EQ(parameters.text("cells"), "[1, 2]");
}

struct RulesConfig {
  FileText rules{"builtin:rules", "one", ""};
};
constexpr std::array kRules = {
    parameter<RulesConfig, &RulesConfig::rules>({.name = "rules", .title = kAny, .help = kAny})};

TEST(Parameter, SaysOfAFileWhatItHoldsNotItsName) {
  Parameters one(kRules), same(kRules), other(kRules);
  same.set_file("rules", {"elsewhere.txt", "one", ""});
  other.set_file("rules", {"builtin:rules", "two", ""});
  EXPECT_EQ(one.text("rules").size(), 16u);
  EXPECT_EQ(one.text("rules"), same.text("rules"));
  EXPECT_NE(one.text("rules"), other.text("rules"));
}

TEST(Parameter, PutsWhatWasGivenIntoTheConfigAndNothingElse) {
  Parameters parameters(kParameters);
  EXPECT_EQ(parameters.filled<Config>().slack.rad(), Angle::from_deg(7).rad()) << "to the bit: it was not given";
  parameters.set("tries", 5);
  parameters.set("loud", 0);
  parameters.set("side", 0);
  parameters.set("slack_deg", 30);
  parameters.set("gain", 2);
  parameters.set_word("word", "b");
  parameters.set_reals("cells", {4});
  const auto config = parameters.filled<Config>();
  EXPECT_EQ(config.reach_m, 0.2);
  EXPECT_EQ(config.tries, 5);
  EXPECT_FALSE(config.loud);
  EXPECT_EQ(config.side, Config::Side::Left);
  EXPECT_EQ(config.slack.rad(), Angle::from_deg(30).rad());
  EXPECT_EQ(config.word, "b");
  EXPECT_EQ(config.cells, std::vector<double>{4});
  EXPECT_EQ(config.gains[0], 0.5);
  EXPECT_EQ(config.gains[1], 2);
  EXPECT_TRUE(parameters.given("gain"));
  EXPECT_FALSE(parameters.given("reach_m"));
}

}  // namespace
}  // namespace ganglion
