#include "ganglion/studio/document/drawing.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ganglion/base/file.h"
#include "ganglion/studio/document/connect.h"

namespace ganglion::studio {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const fs::path kExperiments = fs::path(GANGLION_SOURCE_DIR) / "experiments";
const DocumentPlace kNimrod{kExperiments / "nimrod/controller.toml", kExperiments};

Drawing opened(std::string_view text, const DocumentPlace& place) {
  DiskFiles files;
  return open_drawing(text, place, files);
}

std::string nimrod() { return read_file(kNimrod.file).value(); }

std::string with(std::string text, std::string_view old, std::string_view by) {
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

Json opened(const std::string& text) {
  return Json::parse(drawing_json(opened(text, kNimrod), text, Language::English));
}

const Json& component(const Json& model, const std::string& id) {
  for (const Json& one : model["components"]) {
    if (one["id"] == id) return one;
  }
  static const Json none;
  ADD_FAILURE() << "no component " << id;
  return none;
}

TEST(Drawing, OpensEveryControllerThatIsShippedWithoutProblems) {
  for (const auto& entry : fs::recursive_directory_iterator(kExperiments)) {
    if (!entry.path().filename().string().starts_with("controller")) continue;
    const Drawing drawing = opened(read_file(entry.path()).value(), {entry.path(), kExperiments});
    EXPECT_TRUE(drawing.problems.empty()) << entry.path() << drawing.problems.front().error.what.en;
  }
}

TEST(Drawing, TellsWiresParametersAndUnits) {
  const Json model = opened(nimrod());
  EXPECT_TRUE(model["runnable"]);
  EXPECT_EQ(model["robot"]["path"], "nimrod/robot.toml");
  const Json& hold = component(model, "hold");
  EXPECT_EQ(hold["kind"], "HoldHeading");
  EXPECT_EQ(hold["inputs"][1]["port"], "displaced_by");
  const Json& wire = hold["inputs"][1]["wires"][0];
  EXPECT_EQ(wire["from"], "escape");
  EXPECT_EQ(wire["output"], "active");
  EXPECT_TRUE(wire["previous"]);
  EXPECT_EQ(component(model, "sonar_left")["outputs"][0]["unit"], "m");
  EXPECT_EQ(component(model, "escape")["parameters"],
            Json::parse(R"([{"name":"trigger_range_m","value":0.1,"line":38}])"));
}

TEST(Drawing, PointsAtTheComponentAndPortOfAProblem) {
  const Json model = opened(
      with(nimrod(), "in.right = \"clear_right.range\"\nin.heading", "in.right = \"clear_rigt.range\"\nin.heading"));
  ASSERT_EQ(model["problems"].size(), 1u);
  const Json& problem = model["problems"][0];
  EXPECT_EQ(problem["component"], "escape");
  EXPECT_EQ(problem["port"], "right");
  EXPECT_EQ(problem["line"], 35);
  EXPECT_NE(problem["message"].get<std::string>().find("did you mean \"clear_right"), std::string::npos);
  EXPECT_FALSE(model["runnable"]);
}

TEST(Drawing, NamesTheInputThatIsNotWired) {
  const Json model = opened(with(nimrod(), "in.right = \"clear_right.range\"\nin.heading", "in.heading"));
  ASSERT_EQ(model["problems"].size(), 1u);
  EXPECT_EQ(model["problems"][0]["component"], "escape");
  EXPECT_EQ(model["problems"][0]["port"], "right");
}

TEST(Drawing, DrawsABrokenFileButForItsBrokenLines) {
  std::string text = with(nimrod(), "in.left = \"clear_left.range\"\n", "in.left = \"clear_left.range\nnonsense\n");
  text = with(text, "kind = \"AvoidObstacle\"", "kind = \"AvoidObstacel\"");
  const Json model = opened(text);
  EXPECT_EQ(model["components"].size(), 9u);
  EXPECT_EQ(component(model, "avoid")["kind"], "AvoidObstacel");
  EXPECT_EQ(component(model, "avoid")["inputs"].size(), 2u);
  EXPECT_EQ(component(model, "escape")["inputs"].size(), 3u);
  std::vector<int> lines;
  for (const Json& problem : model["problems"]) lines.push_back(problem["line"]);
  EXPECT_EQ(lines, (std::vector<int>{32, 34, 35, 43}));  // input not wired; the open text; nonsense; the kind
}

TEST(Drawing, OpensAnythingAtAll) {
  for (const std::string text : {"", "[", "[[acting]]", "\xff\xfe", "= 1\n=\n[[[[", "[layout]\na = [1", "a = {", "'''",
                                 "[[acting]]\nin = 3\nid = 4"}) {
    EXPECT_FALSE(opened(text)["runnable"]) << text;
  }
}

TEST(Drawing, ReadsNoRobotOutsideOfItsFolder) {
  const std::string text = with(nimrod(), "robot = \"robot.toml\"", "robot = \"../../../../etc/passwd\"");
  const Json model = opened(text);
  ASSERT_EQ(model["problems"].size(), 1u);
  EXPECT_NE(model["problems"][0]["message"].get<std::string>().find("outside of the folder"), std::string::npos);
  EXPECT_EQ(model["robot"]["path"], "");
}

TEST(Drawing, TakesThePositionsOfTheLayout) {
  const Json model = opened(nimrod() + "\n[layout]\nescape = [10, -20.5]\nhold = \"nowhere\"\n");
  EXPECT_EQ(component(model, "escape")["position"], Json::parse("[10.0, -20.5]"));
  EXPECT_TRUE(component(model, "hold")["position"].is_null());
}

TEST(Connect, MayWhatTheChecksAllow) {
  const std::string text = with(nimrod(), "in.heading = \"heading\"\nin.side", "in.side");
  const Drawing drawing = opened(text, kNimrod);
  EXPECT_TRUE(may_connect(drawing, "heading", "escape", "heading").reasons.empty());
}

TEST(Connect, SaysWhyNot) {
  const Drawing drawing = opened(nimrod(), kNimrod);
  const auto reason = [&](const char* from, const char* id, const char* port) {
    const Connection connection = may_connect(drawing, from, id, port);
    return connection.reasons.empty() ? std::string("none") : connection.reasons.front().en;
  };
  EXPECT_NE(reason("sonar_left", "hold", "heading").find("input \"heading\" is in [rad], \"sonar_left\" is in [m]"),
            std::string::npos);
  EXPECT_NE(reason("escape", "arbiter", "commands").find("already"), std::string::npos);
  EXPECT_NE(reason("nobody", "escape", "left").find("is no sensation"), std::string::npos);
}

TEST(Connect, RefusesACircle) {
  const std::string text =
      with(nimrod(), "in.left = \"clear_left.range\"\nin.right = \"clear_right.range\"\ntrigger_range_m = 0.40",
           "in.left = \"clear_left.range\"\nin.right = \"clear_right.range\"\nin.escaping = \"escape.active\"");
  const Drawing drawing = opened(text, kNimrod);
  const Connection circle = may_connect(drawing, "avoid.side", "escape", "side");
  ASSERT_FALSE(circle.reasons.empty());
  EXPECT_NE(circle.reasons.front().en.find("circle"), std::string::npos);
  const Connection again = may_connect(drawing, "avoid.side@previous", "escape", "side");
  EXPECT_EQ(again.reasons, std::vector{say({"\"avoid.side@previous\" is wired to it already",
                                            "\"avoid.side@previous\" ya está conectado a ella"})});
}

TEST(Connect, TargetsAreWhatEachPortWouldSayByItself) {
  const Drawing drawing = opened(nimrod(), kNimrod);
  for (const char* from : {"sonar_left", "escape.active", "heading", "hold"}) {
    const auto targets = targets_of(drawing, from);
    EXPECT_GT(targets.size(), 10u);
    for (const Connection& one : targets) {
      EXPECT_EQ(one.reasons, may_connect(drawing, from, one.component, one.port).reasons)
          << from << " to " << one.component << " " << one.port;
    }
  }
}

TEST(Connect, SourcesForAPortHoldTheOnesThatFit) {
  std::vector<std::string> fitting;
  for (const Connection& one : sources_for(opened(nimrod(), kNimrod), "escape", "left")) {
    if (one.reasons.empty()) fitting.push_back(one.from);
  }
  EXPECT_EQ(fitting, (std::vector<std::string>{"sonar_left", "sonar_right", "clear_right.range", "avoid.difference"}));
}

}  // namespace
}  // namespace ganglion::studio
