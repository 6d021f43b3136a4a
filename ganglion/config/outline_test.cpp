#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ganglion/config/outline_schema.h"
#include "ganglion/config/table.h"
#include "ganglion/config/testing/outline_names.h"
#include "ganglion/config/testing/schema_validator.h"

namespace ganglion::config {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 2> kColours = {"red", "blue"};

/// A reader with a form that depends on what it finds: a lamp has watts or a candle's height.
void read(std::string_view text, Problems& problems, Outline* outline) {
  const auto value = parse(text, "x.toml");
  ASSERT_TRUE(value);
  Table root(*value, "", problems, outline);
  check_format(root);
  root.number("share", 0.5, Range{0, 1, true});
  root.integer("count", 3, Range{1, 10});
  root.boolean("loud", false);
  root.choice("colour", kColours, 1);
  root.numbers("area", {}, 2);
  root.texts("words");
  root.table("body").number("mass_kg", kPositive);
  root.table("more").text("note", "none");
  for (Table& lamp : root.tables("lamp")) {
    lamp.text("id");
    if (lamp.has("height_m")) {
      lamp.number("height_m", kPositive);
    } else {
      lamp.number("power_W", kNotNegative);
    }
  }
  for (Table& chair : root.tables("chair")) chair.integer("legs", 4);
}

constexpr const char* kLamps =
    "format = 1\n[body]\nmass_kg = 1\n[[lamp]]\nid = \"a\"\nheight_m = 0.1\n[[lamp]]\nid = \"b\"\npower_W = 9\n";

Json schema_of(const char* sample) {
  std::list<Outline> samples(1);
  Problems problems;
  read(sample, problems, &samples.front());
  EXPECT_EQ(problems.text(), "");
  return Json::parse(schema_text("Sample", samples));
}

TEST(Outline, BecomesASchemaWithTypesLimitsAndDefaults) {
  const Json schema = schema_of(kLamps);
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(schema["title"], "Sample");
  EXPECT_EQ(schema["additionalProperties"], false);
  const Json& keys = schema["properties"];
  EXPECT_EQ(keys["format"], Json::parse(R"({"const": 1})"));
  EXPECT_EQ(keys["share"],
            Json::parse(R"({"type": "number", "exclusiveMinimum": 0.0, "maximum": 1.0, "default": 0.5})"));
  EXPECT_EQ(keys["count"], Json::parse(R"({"type": "integer", "minimum": 1, "maximum": 10, "default": 3})"));
  EXPECT_EQ(keys["loud"], Json::parse(R"({"type": "boolean", "default": false})"));
  EXPECT_EQ(keys["colour"], Json::parse(R"({"enum": ["red", "blue"], "default": "blue"})"));
  EXPECT_EQ(keys["area"],
            Json::parse(R"({"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2})"));
  EXPECT_EQ(keys["more"]["properties"]["note"], Json::parse(R"({"type": "string", "default": "none"})"));
}

TEST(Outline, RequiresATableThatMustHaveKeys) {
  EXPECT_EQ(schema_of(kLamps)["required"], Json::parse(R"(["format", "body"])"));  // not `more`: it may be empty
}

TEST(Outline, KnowsWhatEachFormOfATableRequiresAndBars) {
  const Json schema = schema_of(kLamps);
  const std::string start = "format = 1\nbody = { mass_kg = 1 }\n[[lamp]]\nid = \"a\"\n";
  EXPECT_TRUE(schema_accepts(schema, start + "height_m = 0.1\n"));
  EXPECT_TRUE(schema_accepts(schema, start + "power_W = 0\n"));
  EXPECT_FALSE(schema_accepts(schema, start));
  EXPECT_FALSE(schema_accepts(schema, start + "height_m = 0.1\npower_W = 0\n"));
  EXPECT_FALSE(schema_accepts(schema, start + "height_m = 0\n"));
}

TEST(Outline, AsksAlsoForTheKeysOfListsThatNoSampleHas) {
  const Json schema = schema_of(kLamps);
  EXPECT_EQ(schema["properties"]["chair"]["items"]["properties"]["legs"]["default"], 4);
  EXPECT_FALSE(schema["properties"]["chair"]["items"].contains("required"));
}

TEST(Outline, LeavesOpenWhatSamplesSayDifferently) {
  std::list<Outline> samples(2);
  samples.front().ask("x", {.form = Asked::Form::Number, .range = {0, 1}, .preset = 0.5});
  samples.back().ask("x", {.form = Asked::Form::Number, .range = {0, 2}, .preset = 0.7});
  const Json schema = Json::parse(schema_text("Sample", samples));
  EXPECT_EQ(schema["properties"]["x"], Json::parse(R"({"type": "number", "minimum": 0.0})"));
}

TEST(Outline, TakesAKeyInAnyOfTheFormsItMayHave) {
  std::list<Outline> samples(2);
  samples.front().ask("from_s", {.form = Asked::Form::Number, .preset = 0.0});
  samples.back().ask("from_s", {.form = Asked::Form::Numbers, .least = 2, .most = 2});
  const Json schema = Json::parse(schema_text("Sample", samples));
  EXPECT_TRUE(schema_accepts(schema, "from_s = 1"));
  EXPECT_TRUE(schema_accepts(schema, "from_s = [1, 2]"));
  EXPECT_FALSE(schema_accepts(schema, "from_s = [1]"));
  EXPECT_FALSE(schema_accepts(schema, "from_s = \"1\""));
}

TEST(Outline, TellsWhatASampleLacks) {
  std::list<Outline> samples(1);
  Problems problems;
  read("format = 1\n[body]\nmass_kg = 1\n[[lamp]]\nid = \"a\"\npower_W = 9\n", problems, &samples.front());
  EXPECT_EQ(unasked_keys(samples), KeyNames{"lamp.height_m"});
}

TEST(Outline, ChangesNothingOfWhatIsRead) {
  Problems problems;
  read("format = 1\nshare = 2\n", problems, nullptr);
  EXPECT_EQ(problems.text(),
            "x.toml:1:1: body: mass_kg is missing\n"
            "x.toml:2:9: share is 2, must be in (0, 1]\n");
}

}  // namespace
}  // namespace ganglion::config
