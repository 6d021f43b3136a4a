#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ganglion/base/file.h"
#include "ganglion/base/testing/folder.h"
#include "ganglion/config/testing/schema_validator.h"
#include "ganglion/descriptor/kind_page.h"
#include "ganglion/descriptor/kinds_json.h"
#include "ganglion/graph/schema.h"
#include "ganglion/graph/testing/rig.h"
#include "ganglion/graph/testing/ruled.h"

// Parameters that name a file: who reads it, what may be wrong with it, and where that is told. The kind Ruled has an
// output for each line of its file.
namespace ganglion {
namespace {

namespace fs = std::filesystem;

const std::string kRuled =
    "[[sensation]]\nid = \"a\"\nchannel = \"a\"\n"
    "[[sensing]]\nid = \"x\"\nkind = \"Ruled\"\nin.in = \"a\"\n";  // line 5 ff.

class FileParameters : public FolderTest {
 protected:
  void put(const std::string& name, std::string_view text) const { EXPECT_TRUE(write_file(folder_ / name, text)); }

  /// The drawing with further lines for "x", read as a file of the folder; line 9 is the first of them.
  ControllerModel read(const std::string& more, const std::vector<config::Override>& overrides = {}) {
    const int file = files_.hold("controller", folder_ / "c.toml", "format = 1\n" + kRuled + more);
    auto root = config::parse(files_.at(file));
    EXPECT_TRUE(root);
    for (const config::Override& one : overrides) EXPECT_TRUE(config::apply(*root, one));
    return read_controller(*root, testing::kinds(), problems_, &files_);
  }
  /// Every problem, folder left out.
  std::string told(const std::string& more) {
    problems_ = {};
    read(more);
    std::string text = problems_.text();
    const std::string start = folder_.string() + "/";
    for (auto at = text.find(start); at != std::string::npos; at = text.find(start)) text.erase(at, start.size());
    return text;
  }
  /// The first value of an output after one tick with a = 3.
  double after_a_tick(ControllerModel model, std::string_view output) {
    const Description robot = testing::test_robot();
    resolve(model, robot, problems_);
    EXPECT_EQ(problems_.text(), "");
    auto controller = Controller::compile(model, robot, testing::kinds(), {});
    EXPECT_TRUE(controller);
    SenseFrame sense = make_sense_frame(robot);
    ActFrame act = make_act_frame(robot);
    sense.values[static_cast<std::size_t>(robot.sensation_offset(4))] = 3;
    sense.ages_s.assign(sense.ages_s.size(), 0);
    controller->tick(sense, 0.1, act);
    for (std::size_t i = 0; i < controller->signals().size(); ++i) {
      if (controller->signals()[i].name == output) return controller->values()[i];
    }
    ADD_FAILURE() << "no output " << output;
    return 0;
  }

  DiskFiles files_;
  Problems problems_;
};

TEST_F(FileParameters, ShapeThePortsOfTheirComponent) {
  put("rules.txt", "near 2\nfar -0.5\n");
  const ControllerModel model = read("rules = \"rules.txt\"\n");
  ASSERT_EQ(problems_.text(), "");
  EXPECT_EQ(model.components.back().ports().size(), 3u);
  EXPECT_EQ(after_a_tick(model, "x.near"), 6);
  EXPECT_EQ(after_a_tick(model, "x.far"), -1.5);
  const OpenedFile& file = files_.opened().back();
  EXPECT_EQ(file.role, "sensing.x.rules");
  EXPECT_EQ(file.named, "rules.txt");
  EXPECT_EQ(file.resolved, folder_ / "rules.txt") << "relative to the controller";
  EXPECT_EQ(files_.at(file.by).role, "controller");
}

TEST_F(FileParameters, HaveATextOfTheProgramAsTheirPreset) {
  EXPECT_EQ(after_a_tick(read(""), "x.out"), 6);
  const OpenedFile file = files_.opened().back();
  EXPECT_EQ(file.named, "builtin:twice.txt");
  EXPECT_TRUE(file.resolved.empty());
  EXPECT_EQ(*file.text, "out 2\n");
  EXPECT_EQ(told("rules = \"builtin:twice.txt\"\n"), "");
  EXPECT_EQ(told("rules = \"builtin:twise.txt\"\n"),
            "c.toml:9:9: x: rules = \"builtin:twise.txt\" is no text of the program; did you mean "
            "\"builtin:twice.txt\"?\n");
}

TEST_F(FileParameters, MayBeSetFromOutside) {
  put("other.txt", "out 5\n");
  const std::string path = (folder_ / "other.txt").string();
  EXPECT_EQ(after_a_tick(read("rules = \"none.txt\"\n", {{"sensing.x.rules", path}}), "x.out"), 15);
  EXPECT_EQ(files_.opened().back().by, -1) << "the drawing does not name it";
  read("", {{"sensing.x.rules", "surely_not_here.txt"}});
  EXPECT_EQ(problems_.text(),
            "--set sensing.x.rules=surely_not_here.txt: x: rules: there is no file \"surely_not_here.txt\"\n");
}

TEST_F(FileParameters, ThatCannotBeReadAreToldWhereTheyAreNamed) {
  fs::create_directories(folder_ / "sub");
  fs::create_symlink(folder_ / "loop", folder_ / "loop");
  put("latin.txt", "good 1\na\xf1o 2\n");
  put("large.txt", std::string(kMaxFileText + 1, '\n'));
  put("just.txt", std::string(kMaxFileText - 6, '\n') + "out 1\n");
  EXPECT_EQ(told("rules = \"none.txt\"\n"), "c.toml:9:9: x: rules: there is no file \"none.txt\"\n");
  EXPECT_EQ(told("rules = \"sub\"\n"), "c.toml:9:9: x: rules: \"sub\" is not a regular file\n");
  EXPECT_EQ(told("rules = \"large.txt\"\n"),
            "c.toml:9:9: x: rules: \"large.txt\" has 1048577 bytes; the limit here is 1048576\n");
  EXPECT_EQ(told("rules = \"latin.txt\"\n"),
            "c.toml:9:9: x: rules: \"latin.txt\" is not UTF-8 text: its line 2 holds the byte 0xf1\n");
  EXPECT_EQ(told("rules = \"loop\"\n"),
            "c.toml:9:9: x: rules: \"loop\" cannot be read: Too many levels of symbolic links\n");
  EXPECT_EQ(told("rules = \"\"\n"), "c.toml:9:9: x: rules is empty; name a file, or \"builtin:twice.txt\"\n");
  EXPECT_EQ(told("rules = 3\n"), "c.toml:9:9: x: rules is a whole number, must be a text in quotes\n");
  EXPECT_EQ(told("rules = \"just.txt\"\n"), "");
}

TEST_F(FileParameters, HaveALimitTogether) {
  put("long.txt", std::string(kMaxFileText - 3, 'n') + " 2\n");  // one output with a name of 1 MiB
  std::string text;
  for (int i = 0; i < 64; ++i)
    text += fmt::format("[[sensing]]\nid = \"y{}\"\nkind = \"Ruled\"\nrules = \"long.txt\"\nin.in = \"a\"\n", i);
  EXPECT_EQ(told(text), "") << "64 MiB and the preset of x: the last of them is over";
  for (const char* id : {"z", "zz"})
    text += fmt::format("[[sensing]]\nid = \"{}\"\nkind = \"Ruled\"\nin.in = \"a\"\n", id);
  EXPECT_EQ(told(text), "c.toml:329:1: the files that parameters name have more than 67108864 bytes together\n");
}

TEST_F(FileParameters, TellAnErrorOfTheirOwnAtTheirOwnLine) {
  put("rules.txt", "near 2\nfar away\n");
  EXPECT_EQ(told("rules = \"rules.txt\"\n"), "rules.txt:2:5: x: no number\n");
  const Error error = problems_.sorted().front();
  EXPECT_EQ(error.subject.component, "x");
  EXPECT_EQ(error.subject.part, "rules");
}

TEST_F(FileParameters, NameNothingWhereNobodyReads) {
  const auto root = config::parse("format = 1\n" + kRuled + "rules = \"rules.txt\"\n", "c.toml");
  read_controller(*root, testing::kinds(), problems_);
  EXPECT_EQ(problems_.text(), "c.toml:9:9: x: rules: no file can be read here\n");
}

TEST_F(FileParameters, AreTextsToSchemasManualAndForms) {
  const auto schema = nlohmann::json::parse(controller_schema(testing::kinds()));
  EXPECT_TRUE(config::schema_accepts(schema, "format = 1\n" + kRuled + "rules = \"rules.txt\"\n"));
  EXPECT_FALSE(config::schema_accepts(schema, "format = 1\n" + kRuled + "rules = 3\n"));
  const std::array<const Descriptor*, 1> kinds = {&testing::ruled_kind.descriptor};
  const auto parameter = nlohmann::json::parse(kinds_json(kinds))[0]["parameters"][0];
  EXPECT_EQ(parameter["type"], "file");
  EXPECT_EQ(parameter["default"], "builtin:twice.txt");
  EXPECT_NE(kind_page(*kinds[0], Language::Spanish).find("| archivo | `\"builtin:twice.txt\"` |"), std::string::npos);
}

}  // namespace
}  // namespace ganglion
