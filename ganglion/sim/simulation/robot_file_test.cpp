// Reading robot.toml, with the real kinds.
#include <filesystem>
#include <fstream>

#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

using testing::kKinds;

constexpr std::string_view kNimrod = R"(format = 1
name = "Nimrod"
tick_s = 0.1

[body]
length_m = 0.24
width_m = 0.20

[drive]
kind = "Tracked"
full_scale_mps = 0.20
track_m = 0.18
right_gain = 0.95

[[sensor]]
id = "sonar_left"
kind = "Sonar"
x_m = 0.12
y_m = 0.09
yaw_deg = 5

[[sensor]]
id = "compass"
kind = "Compass"
period_s = 0.2

[energy]
idle_W = 0.5
)";

std::string problems_of(std::string_view text) {
  Problems problems;
  const auto model = parse_robot(text, "robot.toml", kKinds, problems);
  EXPECT_EQ(model == nullptr, !problems.empty());
  return problems.text();
}

TEST(RobotModel, ReadsASimulatedRobot) {
  Problems problems;
  const auto model = parse_robot(kNimrod, "robot.toml", kKinds, problems);
  ASSERT_TRUE(model) << problems.text();
  EXPECT_TRUE(model->simulated());
  EXPECT_EQ(model->description.name, "Nimrod");
  EXPECT_NEAR(model->radius_m, 0.156205, 1e-6);  // half the diagonal: sqrt(0.12^2 + 0.10^2)
  EXPECT_EQ(model->substep_s, 0.01);
  EXPECT_EQ(model->energy.idle_W, 0.5);
  EXPECT_EQ(model->energy.drive_W, 1);
  EXPECT_EQ(model->drive, &tracked_kind);
  EXPECT_EQ(model->drive_parameters.real("right_gain"), 0.95);
  ASSERT_EQ(model->sensors.size(), 2u);
  EXPECT_NEAR(model->sensors[0].mount.yaw.deg(), 5, 1e-12);
  EXPECT_EQ(model->sensors[0].parameters.real("cone_deg"), 40);
  EXPECT_EQ(model->description.sensation("compass.heading")->period_s, 0.2);
  EXPECT_EQ(model->description.command("drive")->elements.size(), 2u);
}

TEST(RobotModel, ReadsABareDescription) {
  Problems problems;
  const auto model = parse_robot(R"(format = 1
name = "Arm"
[body]
length_m = 1
width_m = 0.5
[[sensation]]
name = "joints.angle"
unit = "rad"
type = "circular"
elements = ["base", "elbow"]
min = -3.2
max = 3.2
[[command]]
name = "motors"
elements = ["base", "elbow"]
units = ["rad/s", "rad/s"]
min = [-1, -2]
max = [1, 2]
[[command]]
name = "grip"
min = [0]
)",
                                 "robot.toml", kKinds, problems);
  ASSERT_TRUE(model) << problems.text();
  EXPECT_FALSE(model->simulated());
  const Description& description = model->description;
  EXPECT_EQ(description.sensations[0].type, ValueType::Circular);
  EXPECT_EQ(description.sensation_values(), 2);
  EXPECT_EQ(description.commands[0].elements[1].min, -2);
  EXPECT_EQ(description.commands[0].elements[1].unit, "rad/s");
  EXPECT_EQ(description.commands[1].elements[0].name, "grip");
  EXPECT_EQ(description.commands[1].elements[0].safe, 0);
  const auto refused = Simulation::make({testing::ground_of(testing::kRoom), model, 1, SpawnRandom{}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what.en, "the robot has no [drive]: it is described, not simulated");
  EXPECT_EQ(refused.error().what.es, "el robot no tiene [drive]: está descrito, no simulado");
}

/// Of a robot elsewhere with one sensation.
std::shared_ptr<const RobotModel> with_sensation(const std::string& keys, Problems& problems) {
  return parse_robot(
      "format = 1\nname = \"Far\"\n[body]\nlength_m = 1\nwidth_m = 1\n[[sensation]]\nname = \"bearing\"\n" + keys,
      "robot.toml", kKinds, problems);
}

TEST(RobotModel, ReadsWhatAFullTurnCounts) {
  Problems problems;
  const auto degrees =
      with_sensation("unit = \"deg\"\ntype = \"circular\"\nturn = 360\nmin = 0\nmax = 359.9\n", problems);
  ASSERT_TRUE(degrees) << problems.text();
  EXPECT_EQ(degrees->description.sensations[0].turn, 360);
  EXPECT_TRUE(problems.notes().empty());
  ASSERT_TRUE(with_sensation("unit = \"deg\"\ntype = \"circular\"\n", problems)) << problems.text();
  ASSERT_EQ(problems.notes().size(), 1u) << "it would be taken for radians";
  EXPECT_EQ(problems.notes()[0].place.line, 9);
  EXPECT_FALSE(with_sensation("turn = 360\nmin = 0\nmax = 3599\n", problems));
  EXPECT_EQ(problems.text(), "robot.toml:8:8: bearing: turn is 360, must be >= max - min = 3599\n");
}

TEST(RobotModel, RemarksOnATickTooLongToDriveBy) {
  Problems problems;
  ASSERT_TRUE(parse_robot(
      "format = 1\nname = \"Far\"\ntick_s = 1\n[body]\nlength_m = 1\nwidth_m = 1\n[[command]]\nname = \"a\"\n",
      "robot.toml", kKinds, problems));
  EXPECT_TRUE(problems.notes().empty());
  ASSERT_TRUE(parse_robot(
      "format = 1\nname = \"Far\"\ntick_s = 1.5\n[body]\nlength_m = 1\nwidth_m = 1\n[[command]]\nname = \"a\"\n",
      "robot.toml", kKinds, problems));
  ASSERT_EQ(problems.notes().size(), 1u);
  EXPECT_EQ(problems.notes()[0].place.line, 3);
}

TEST(RobotModel, GathersEveryProblemWithItsPlace) {
  EXPECT_EQ(problems_of(R"(format = 1
name = "x"
[body]
length_m = 0.2
width_m = -1
[drive]
kind = "Diferential"
lag_s = 1
[[sensor]]
id = "a"
kind = "Sonar"
cone_deg = 200
rays = 2.5
[[sensor]]
id = "a"
kind = "Compass"
fault = "ded"
lag_ss = 1
[[sensor]]
id = "b c"
kind = "Sonar"
min_range_m = 4
[energy]
idle_W = -1
)"),
            "robot.toml:5:11: body: width_m is -1, must be in [0.001, 100]\n"
            "robot.toml:7:8: drive: there is no kind \"Diferential\"; did you mean \"Differential\"?\n"
            "robot.toml:12:12: a: cone_deg is 200, must be in [0, 180]\n"
            "robot.toml:13:8: a: rays is a number, must be a whole number\n"
            "robot.toml:15:6: a: id \"a\" is given twice\n"
            "robot.toml:17:9: a: fault is \"ded\"; did you mean \"dead\"?\n"
            "robot.toml:18:10: a: \"lag_ss\" is no key here; did you mean \"lag_s\"?\n"
            "robot.toml:20:6: b c: id is \"b c\", must be 1 to 64 letters, digits, _\n"
            "robot.toml:21:8: b c: min_range_m is 4, must be less than max_range_m = 3\n"
            "robot.toml:24:10: energy: idle_W is -1, must be in [0, 1000000]\n");
}

TEST(RobotModel, SaysWhatIsMissing) {
  EXPECT_EQ(
      problems_of("format = 1\nname = \"x\"\n"),
      "robot.toml:1:1: [body] is missing: length_m and width_m of the robot\n"
      "robot.toml:1:1: [drive] is missing: a robot with sensors must have one; a bare description has [[sensation]] "
      "and [[command]] instead\n");
}

TEST(RobotModel, KeepsMountsOnTheBody) {
  const std::string text = std::string(kNimrod) + "[[sensor]]\nid = \"far\"\nkind = \"Range\"\nx_m = 0.2\n";
  EXPECT_EQ(problems_of(text),
            "robot.toml:32:7: far: sits 0.2 m from the centre, must be on the body: within its radius of 0.156 m\n");
}

TEST(RobotModel, RefusesToMixItsTwoForms) {
  const std::string text =
      std::string(kNimrod) + "[[sensation]]\nname = \"a\"\n[[command]]\nname = \"a\"\nsafe = [3]\n";
  EXPECT_EQ(problems_of(text),
            "robot.toml:9:1: drive does not go with [[sensation]] and [[command]]: a robot is either simulated or "
            "described\n"
            "robot.toml:15:1: sensor does not go with [[sensation]] and [[command]]: a robot is either simulated or "
            "described\n"
            "robot.toml:27:1: energy does not go with [[sensation]] and [[command]]: a robot is either simulated or "
            "described\n"
            "robot.toml:33:8: a: a: safe is 3, must be in [-1, 1]\n");
}

TEST(RobotModel, TakesOverrides) {
  auto root = *config::parse(kNimrod, "robot.toml");
  ASSERT_TRUE(config::apply(root, *config::parse_override("drive.full_scale_mps=0.3")));
  ASSERT_TRUE(config::apply(root, *config::parse_override("sensor.sonar_left.fault=dead")));
  Problems problems;
  const auto model = read_robot(root, kKinds, problems);
  ASSERT_TRUE(model) << problems.text();
  EXPECT_EQ(model->drive_parameters.real("full_scale_mps"), 0.3);
  EXPECT_EQ(model->sensors[0].fault, Fault::Dead);
}

TEST(RobotModel, OutlivesMutatedFiles) {
  Draws draws(StreamId{11, 0, 0, 0}, 0);
  int read = 0;
  for (int n = 0; n < 500; ++n) {
    std::string text(kNimrod);
    for (std::uint32_t edits = 1 + draws.below(4); edits > 0; --edits) {
      const std::size_t place = draws.below(static_cast<std::uint32_t>(text.size()));
      switch (draws.below(3)) {
        case 0:
          text[place] = static_cast<char>(draws.below(256));
          break;
        case 1:
          text.erase(place, 1 + draws.below(20));
          break;
        default:
          text.insert(place, text.substr(draws.below(static_cast<std::uint32_t>(text.size())), draws.below(60)));
      }
    }
    Problems problems;
    const auto model = parse_robot(text, "robot.toml", kKinds, problems);
    EXPECT_EQ(model == nullptr, !problems.empty());
    read += model != nullptr ? 1 : 0;
  }
  EXPECT_GT(read, 0);
  EXPECT_LT(read, 500);
}

}  // namespace
}  // namespace ganglion::sim
