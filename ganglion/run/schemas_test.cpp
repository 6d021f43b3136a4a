#include <gtest/gtest.h>

#include "ganglion/base/file.h"
#include "ganglion/base/text.h"
#include "ganglion/config/testing/outline_names.h"
#include "ganglion/config/testing/schema_validator.h"
#include "ganglion/graph/model.h"
#include "ganglion/graph/schema.h"
#include "ganglion/kinds/applications.h"
#include "ganglion/kinds/kinds.h"
#include "ganglion/run/check_file.h"
#include "ganglion/run/experiment.h"
#include "ganglion/run/experiment_schema.h"
#include "ganglion/sim/robot/robot_schema.h"
#include "ganglion/sim/world/plan/plan.h"
#include "ganglion/sim/world/plan/world_schema.h"

// Schemas of all files people edit, held beside the readers and the files that we ship.
namespace ganglion {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kExperiments = fs::path(GANGLION_SOURCE_DIR) / "experiments";

/// A type of file: its schema, and what its reader says of a text.
struct FileType {
  std::string name;
  Json schema;
  void (*read)(const std::string& text, const std::string& file, Problems& problems);
};

void read_controller_text(const std::string& text, const std::string& file, Problems& problems) {
  read_controller(*config::parse(text, file), controller_kinds(), problems);
}

const std::vector<FileType>& file_types() {
  static const std::vector<FileType> kTypes = {
      {"controller", Json::parse(controller_schema(controller_kinds())), read_controller_text},
      {"experiment", Json::parse(experiment_schema()),
       [](const std::string& text, const std::string& file, Problems& problems) {
         parse_experiment(text, file, problems);
       }},
      {"robot", Json::parse(robot_schema()),
       [](const std::string& text, const std::string& file, Problems& problems) {
         sim::parse_robot(text, file, sim_kinds(), problems);
       }},
      {"plant", Json::parse(plant_schema()),
       [](const std::string& text, const std::string& file, Problems& problems) {
         const auto root = config::parse(text, file);
         if (!root) return problems.add(root.error());
         read_application({.file = *root}, problems);
       }},
      {"world", Json::parse(sim::world_schema()),
       [](const std::string& text, const std::string& file, Problems& problems) {
         sim::parse_plan(text, file, problems);
       }}};
  return kTypes;
}

const FileType& type_of(const std::string& name) {
  for (const FileType& type : file_types()) {
    if (type.name == name) return type;
  }
  ADD_FAILURE() << name;
  return file_types().front();
}

/// The reader and the schema agree that `text` is good, or that it is not.
void expect_verdict(const std::string& type_name, const std::string& text, bool good) {
  const FileType& type = type_of(type_name);
  Problems problems;
  type.read(text, (kExperiments / "nimrod" / "sample.toml").string(), problems);
  EXPECT_EQ(problems.empty(), good) << text << problems.text();
  EXPECT_EQ(config::schema_accepts(type.schema, text), good) << text;
}

void expect_slips(const std::string& type, const std::string& start, const std::vector<std::string>& slips) {
  expect_verdict(type, start, true);
  for (const std::string& slip : slips) expect_verdict(type, start + slip + "\n", false);
}

TEST(Schemas, AcceptEveryFileWeShip) {
  std::map<std::string, int> seen;
  for (const auto& entry : fs::recursive_directory_iterator(kExperiments)) {
    if (entry.path().extension() != ".toml") continue;
    Problems problems;
    const std::string type = check_file(entry.path(), problems);
    ++seen[type];
    const auto text = read_file(entry.path());
    ASSERT_TRUE(text);
    EXPECT_TRUE(config::schema_accepts(type_of(type).schema, *text)) << entry.path();
  }
  EXPECT_EQ(seen.size(), file_types().size()) << "some type of file has no example";
}

TEST(Schemas, RefuseSlipsInExperiments) {
  expect_slips("experiment", "format = 1\ncontroller = \"controller.toml\"\n",
               {"nam = \"x\"", "name = 3", "success = [1]", "[run]\nduration_s = 0", "[run]\nduration_s = \"60\"",
                "[run]\nseed = 1.5", "[run]\nseed = -1", "[run]\nfree_ground = 1", "[application]\nrobots = 0",
                "[application]\nrobot = 1", "[application.spawn]\nclearance_m = -1",
                "[application.spawn]\npose = [1, 2]", "[[fault]]\nkind = \"dead\"", "[[fault]]\ntarget = \"a\"",
                "[[fault]]\ntarget = \"a\"\nkind = \"ded\"", "[[fault]]\ntarget = \"a\"\nkind = \"dead\"\nfrom_s = [1]",
                "[[fault]]\ntarget = \"a\"\nkind = \"dead\"\nfrom_s = -1", "[application.spawn]\nyaw = 1", "[stop]"});
  expect_verdict("experiment", "format = 1\n", false);
  expect_verdict("experiment", "controller = \"controller.toml\"\n", false);
  expect_verdict("experiment",
                 "format = 1\ncontroller = \"controller.toml\"\nsuccess = \"contacts <= 3\"\n[application.spawn]\n"
                 "pose = [1, 2, 90]\nyaw_deg = 400\n[run]\nstop = [\"contacts > 3\"]\n"
                 "[[fault]]\ntarget = \"a\"\nkind = \"dead\"\nfrom_s = [1, 2]\nto_s = 3\n",
                 true);
}

TEST(Schemas, RefuseSlipsInRobots) {
  const std::string start = "format = 1\nname = \"r\"\n[body]\nlength_m = 0.2\nwidth_m = 0.2\n";
  const std::string drive = "[drive]\nkind = \"Tracked\"\n";
  expect_slips(
      "robot", start + drive,
      {"track = 1", "full_scale_mps = 0", "full_scale_mps = \"1\"", "[energy]\nidle_W = -1", "[battery]\ncharge = -1",
       "[battery]\nfull = 1", "[energy]\nidle = 1", "[[sensor]]\nid = \"s\"", "[[sensor]]\nkind = \"Sonar\"",
       "[[sensor]]\nid = \"s\"\nkind = \"Sonr\"", "[[sensor]]\nid = \"s\"\nkind = \"Sonar\"\nx = 1",
       "[[sensor]]\nid = \"s\"\nkind = \"Sonar\"\nfault = \"gone\"",
       "[[sensor]]\nid = \"s\"\nkind = \"Sonar\"\nyaw_deg = 400", "[[command]]\nname = \"drive\""});
  expect_slips("robot", start + "[[sensation]]\nname = \"a\"\n[[command]]\nname = \"b\"\n",
               {"min = -1", "elements = 1", "safe = [0, \"x\"]", "[[sensation]]\nname = \"c\"\ntype = \"angle\"",
                "[[sensation]]\nunit = \"m\"", "[drive]\nkind = \"Tracked\""});
  expect_verdict("robot", start, false);
  expect_verdict("robot", "format = 1\nname = \"r\"\n" + drive, false);
  expect_verdict("robot", "format = 1\nname = \"r\"\n[body]\nlength_m = 0.2\nwidth_m = 0\n" + drive, false);
  expect_verdict("robot", start + drive + "[battery]\ncapacity_J = 400\ncharge = 0.5\n", true);
  expect_slips("robot", start + drive + "[battery]\n", {"capacity_J = 0", "charge = 2", "volts = 3"});
  expect_verdict("robot", start + "[[command]]\nname = \"b\"\nelements = [\"x\", \"y\", \"z\"]\nmin = [-1, -2, -3]\n",
                 true);
  expect_verdict("robot", start + drive + "[battery]\nfull_V = 8\n", true);
}

TEST(Schemas, RefuseSlipsInWorlds) {
  expect_slips("world", "format = 1\n",
               {"area = [0, 0, 1]", "nam = \"x\"", "[[wall]]\npoints = [[0, 0]]", "[[wall]]\npoints = [[0, 0], [1]]",
                "[[wall]]", "[[wall]]\npoints = [[0, 0], [1, 20_000]]", "[[disc]]\nx_m = 0\ny_m = 0",
                "[[disc]]\nx_m = 0\ny_m = 0\nradius_m = 0", "[[disc]]\nx_m = 0\ny_m = 0\nradius_m = 1\nwidth_m = 1",
                "[[box]]\nx_m = 0\ny_m = 0\nlength_m = 1\nwidth_m = 1\nmaterial = \"wood\"",
                "[[polygon]]\npoints = [[0, 0], [1, 0]]", "[[spawn]]\nx_m = 0\ny_m = 0"});
  expect_slips("world", "format = 1\n[[mover]]\nid = \"a\"\nradius_m = 0.2\npath = [[0, 0], [1, 0]]\nspeed_mps = 1\n",
               {"length_m = 1", "places = [[0, 0]]", "change_after_s = [1, 2]", "loop = 1",
                "[[mover]]\nid = \"b\"\nradius_m = 0.2", "[[mover]]\nid = \"b\"\nplaces = [[0, 0]]",
                "[[mover]]\nid = \"b\"\nradius_m = 0.2\npath = [[0, 0], [1, 0]]",
                "[[mover]]\nid = \"b\"\nradius_m = 0.2\npath = [[0, 0], [1, 0]]\nspeed_mps = 0"});
  expect_verdict("world", "format = 1\n[[mover]]\nid = \"a\"\nlength_m = 1\nwidth_m = 1\nplaces = [[0, 0]]\n", true);
}

/// Tables of every form, to take lines out of and to put lines into.
const char* const kForms = R"(format = 1
[[wall]]
points = [[0, 0], [1, 0], [1, 1]]
closed = true
[[disc]]
x_m = 0
y_m = 0
radius_m = 1
structural = true
[[floor]]
points = [[0, 0], [1, 0], [0, 1]]
colour = "#102030"
slip = 0.1
[[floor]]
x_m = 0
y_m = 0
radius_m = 1
[[floor]]
x_m = 0
y_m = 0
length_m = 1
width_m = 1
yaw_deg = 10
[[beacon]]
id = "lamp"
x_m = 0
y_m = 0
light_range_m = 3
[[beacon]]
id = "bird"
x_m = 0
y_m = 0
word = [1, 2]
start_s = 1
[[mover]]
id = "a"
radius_m = 0.2
path = [[0, 0], [1, 0]]
speed_mps = 1
loop = true
[[mover]]
id = "b"
length_m = 1
width_m = 1
places = [[0, 0]]
[[mover]]
id = "c"
radius_m = 0.2
places = [[0, 0], [1, 0]]
change_after_s = [1, 2]
[[mover]]
id = "d"
length_m = 1
width_m = 1
area = [0, 0, 3, 3]
x_m = 1
y_m = 1
speed_mps = 1
avoids = "robots"
)";

/// Where the reader finds no fault the schema must find none.
void expect_no_false_alarm(const FileType& type, const std::vector<std::string>& lines, int& good) {
  const std::string text = join(lines, "\n");
  Problems problems;
  type.read(text, (kExperiments / "nimrod" / "sample.toml").string(), problems);
  if (!problems.empty()) return;
  ++good;
  EXPECT_TRUE(config::schema_accepts(type.schema, text)) << text;
}

TEST(Schemas, RaiseNoFalseAlarmWhenLinesComeAndGo) {
  const std::vector<std::string> lines = split(kForms, '\n');
  int good = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<std::string> shorter = lines;
    shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(i));
    expect_no_false_alarm(type_of("world"), shorter, good);
    for (std::size_t n = 0; n < lines.size(); ++n) {
      if (!lines[n].starts_with("[[")) continue;
      std::vector<std::string> longer = lines;
      longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(n) + 1, lines[i]);
      if (config::parse(join(longer, "\n"), "x")) expect_no_false_alarm(type_of("world"), longer, good);
    }
  }
  EXPECT_GT(good, 20);
}

TEST(Schemas, RefuseSlipsInControllers) {
  expect_slips("controller",
               "format = 1\n[[acting]]\nid = \"e\"\nkind = \"Escape\"\nin.left = \"a\"\nin.right = \"b\"\n",
               {"triger_range_m = 1", "trigger_range_m = -1", "trigger_range_m = \"1\"", "in.up = \"c\"",
                "[[acting]]\nid = \"f\"\nkind = \"Escap\"", "[[sensation]]\nid = \"a\""});
}

TEST(Schemas, HaveTheKeysThatTheReadersAsk) {
  EXPECT_EQ(config::asked_keys(experiment_outlines()), config::schema_keys(type_of("experiment").schema));
  EXPECT_EQ(config::asked_keys(sim::robot_outlines(sim_kinds())), config::schema_keys(type_of("robot").schema));
  EXPECT_EQ(config::asked_keys(sim::world_outlines()), config::schema_keys(type_of("world").schema));
}

TEST(Schemas, AreMadeFromSamplesThatBringTheReadersToAskEverything) {
  EXPECT_EQ(config::unasked_keys(experiment_outlines()), config::KeyNames{});
  EXPECT_EQ(config::unasked_keys(sim::robot_outlines(sim_kinds())), config::KeyNames{});
  EXPECT_EQ(config::unasked_keys(plant_outlines()), config::KeyNames{});
  EXPECT_EQ(config::unasked_keys(sim::world_outlines()), config::KeyNames{});
}

TEST(Schemas, OfControllersHaveTheKeysThatTheReaderAsks) {
  std::string text = "format = 1\n[[sensation]]\nid = \"s\"\nchannel = \"s\"\n";
  for (const ComponentClass component_class :
       {ComponentClass::Sensing, ComponentClass::Goal, ComponentClass::Acting, ComponentClass::Coordinator}) {
    for (const Descriptor* kind : descriptors_of(controller_kinds(), component_class)) {
      text += fmt::format("[[{}]]\nid = \"{}\"\nkind = \"{}\"\n", name_of(component_class), kind->name, kind->name);
    }
  }
  std::list<config::Outline> samples(1);
  Problems problems;
  read_controller(*config::parse(text, "sample"), controller_kinds(), problems, nullptr, &samples.front());
  // Wires are named by the ports; `layout` is the drawing's, the reader lets it stand.
  const auto other = [](const std::string& name) {
    return name.ends_with(".in") || name.find(".in.") != std::string::npos || name == "layout";
  };
  config::KeyNames asked = config::asked_keys(samples), known = config::schema_keys(type_of("controller").schema);
  std::erase_if(asked, other);
  std::erase_if(known, other);
  EXPECT_EQ(asked, known);
}

}  // namespace
}  // namespace ganglion
