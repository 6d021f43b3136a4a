#include "ganglion/graph/schema.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "ganglion/graph/model.h"
#include "ganglion/graph/testing/example_kinds.h"

namespace ganglion {
namespace {

using Json = nlohmann::json;

Json json_of(const config::Value& value) {
  if (const auto* v = value.boolean()) return *v;
  if (const auto* v = value.integer()) return *v;
  if (const auto* v = value.real()) return *v;
  if (const auto* v = value.string()) return *v;
  if (const auto* items = value.array()) {
    Json list = Json::array();
    for (const config::Value& item : *items) list.push_back(json_of(item));
    return list;
  }
  Json object = Json::object();
  for (const auto& [key, member] : *value.table()) object[key] = json_of(member);
  return object;
}

/// The part of JSON Schema that our schemas use, after the specification; any other keyword is a failure.
class Validator {
 public:
  explicit Validator(const Json& root) : root_(root) {}

  bool accepts(const Json& schema, const Json& value) const {
    for (const auto& [keyword, wanted] : schema.items()) {
      if (!holds(keyword, wanted, schema, value)) return false;
    }
    return true;
  }

 private:
  bool holds(const std::string& keyword, const Json& wanted, const Json& schema, const Json& value) const {
    const auto accepted = [&](const Json& option) { return accepts(option, value); };
    if (keyword == "$ref") return accepts(root_["$defs"][wanted.get<std::string>().substr(8)], value);
    if (keyword == "type") return is(wanted, value);
    if (keyword == "const") return value == wanted;
    if (keyword == "enum") return std::count(wanted.begin(), wanted.end(), value) > 0;
    if (keyword == "minimum") return !value.is_number() || value >= wanted;
    if (keyword == "maximum") return !value.is_number() || value <= wanted;
    if (keyword == "minItems") return !value.is_array() || value.size() >= wanted;
    if (keyword == "maxItems") return !value.is_array() || value.size() <= wanted;
    if (keyword == "oneOf") return std::count_if(wanted.begin(), wanted.end(), accepted) == 1;
    if (keyword == "anyOf") return std::any_of(wanted.begin(), wanted.end(), accepted);
    if (keyword == "pattern") {
      return !value.is_string() || std::regex_search(value.get<std::string>(), std::regex(wanted.get<std::string>()));
    }
    if (keyword == "items") {
      return !value.is_array() ||
             std::all_of(value.begin(), value.end(), [&](const Json& item) { return accepts(wanted, item); });
    }
    if (keyword == "required") {
      return !value.is_object() ||
             std::all_of(wanted.begin(), wanted.end(), [&](const Json& key) { return value.contains(key); });
    }
    if (keyword == "properties" || keyword == "additionalProperties")
      return !value.is_object() || members(schema, value);
    static const std::set<std::string> kNotes = {"$schema", "$defs", "title", "description", "default"};
    EXPECT_TRUE(kNotes.contains(keyword)) << keyword;
    return true;
  }

  bool members(const Json& schema, const Json& value) const {
    for (const auto& [key, member] : value.items()) {
      if (schema["properties"].contains(key)) {
        if (!accepts(schema["properties"][key], member)) return false;
      } else if (schema.contains("additionalProperties")) {
        return false;
      }
    }
    return true;
  }

  static bool is(const std::string& type, const Json& value) {
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    if (type == "object") return value.is_object();
    return type == value.type_name();
  }

  const Json& root_;
};

bool accepted(const std::string& text) {
  static const Json schema = Json::parse(controller_schema(example::kKinds));
  const auto value = config::parse(text, "c.toml");
  EXPECT_TRUE(value);
  return Validator(schema).accepts(schema, json_of(*value));
}

const std::string kStart =
    "format = 1\n[[acting]]\nid = \"escape\"\nkind = \"BackOff\"\nin.left = \"a\"\nin.right = \"b\"\n";

TEST(ControllerSchema, AcceptsGoodFiles) {
  EXPECT_TRUE(accepted("format = 1"));
  EXPECT_TRUE(accepted(kStart));
  EXPECT_TRUE(accepted(kStart +
                       "command = \"drive\"\ntolerance = 0.1\npreemption = false\ntrigger_range_m = 0.3\n"
                       "side = \"left\"\nbursts = 2\nloud = true\nlabel = \"x\"\nin.heading = \"n.x@previous\"\n"
                       "[layout]\nescape = [1, 2]\n"));
  EXPECT_TRUE(
      accepted("format = 1\nname = \"x\"\nrobot = \"r.toml\"\ntick_s = 0.1\n"
               "[[sensation]]\nid = \"a\"\nchannel = \"a.b\"\n"
               "[[goal]]\nid = \"g\"\nkind = \"Target\"\nat_m = [1, 2.5]\n"
               "[[acting]]\nid = \"go\"\nkind = \"GoTo\"\nin.request = [\"g\"]\nin.position = \"a\"\n"
               "[[coordinator]]\nid = \"c\"\nkind = \"First\"\nin.commands = [\"go\", \"h\"]\n"));
  EXPECT_TRUE(accepted(kStart + "[[acting]]\nid = \"e\"\nkind = \"AmBk\"\nin.left = \"a\"\nin.right = \"b\"\n"));
}

TEST(ControllerSchema, RefusesWhatTheLoaderRefuses) {
  for (const char* line : {"triger_range_m = 1", "trigger_range_m = 5", "trigger_range_m = \"0.1\"", "side = \"up\"",
                           "bursts = 1.5", "bursts = 0", "loud = 1", "label = 3", "tolerance = -1",
                           "in.heading = \"a b\"", "in.lft = \"a\"", "in.heading = \"a@next\""}) {
    EXPECT_FALSE(accepted(kStart + line + "\n")) << line;
  }
  for (const char* text :
       {"name = \"x\"", "format = 2", "format = 1\nnam = \"x\"", "format = 1\n[acting]\nid = \"e\"",
        "format = 1\n[[acting]]\nid = \"e\"\nkind = \"BackOf\"", "format = 1\n[[sensation]]\nid = \"a\"",
        "format = 1\n[[acting]]\nid = \"e\"\nkind = \"BackOff\"\nin.left = \"a\"",
        "format = 1\n[[acting]]\nid = \"e\"\nkind = \"BackOff\"",
        "format = 1\n[[acting]]\nkind = \"BackOff\"\nin.left = \"a\"\nin.right = \"b\"",
        "format = 1\n[[sensation]]\nid = \"a-b\"\nchannel = \"c\"",
        "format = 1\n[[goal]]\nid = \"g\"\nkind = \"Target\"\nat_m = [1]"}) {
    EXPECT_FALSE(accepted(text)) << text;
  }
}

TEST(ControllerSchema, HasRoomForNoComponentWhereThereIsNoKind) {
  const Json schema = Json::parse(controller_schema({}));
  EXPECT_TRUE(Validator(schema).accepts(schema, Json::parse(R"({"format": 1, "acting": []})")));
  EXPECT_FALSE(Validator(schema).accepts(schema, Json::parse(R"({"format": 1, "acting": [{"kind": "BackOff"}]})")));
}

}  // namespace
}  // namespace ganglion
