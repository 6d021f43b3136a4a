#include "ganglion/graph/schema.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ganglion/config/testing/schema_validator.h"
#include "ganglion/graph/testing/example_kinds.h"

namespace ganglion {
namespace {

using Json = nlohmann::json;

bool accepted(const std::string& text) {
  static const Json schema = Json::parse(controller_schema(example::kKinds));
  return config::schema_accepts(schema, text);
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
  EXPECT_TRUE(config::SchemaValidator(schema).accepts(schema, Json::parse(R"({"format": 1, "acting": []})")));
  EXPECT_FALSE(config::SchemaValidator(schema).accepts(
      schema, Json::parse(R"({"format": 1, "acting": [{"kind": "BackOff"}]})")));
}

}  // namespace
}  // namespace ganglion
