#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ganglion/graph/controller.h"
#include "ganglion/kinds/kinds.h"

// Set-points, shares and commands by name, in controllers of kinds that are shipped.
namespace ganglion {
namespace {

Description plant() {
  Description plant;
  plant.name = "plant";
  plant.sensations = {{.name = "value"}, {.name = "other"}, {.name = "wish"}, {.name = "weight"}};
  plant.commands = {{"heat", {{"power", "", -10, 10}}},
                    {"fan", {{"power", "", -10, 10}}},
                    {"drive", {{"right", "", -1, 1}, {"left", "", -1, 1}}}};
  return plant;
}

constexpr std::string_view kSensations =
    "format = 1\n[[sensation]]\nid = \"value\"\nchannel = \"value\"\n[[sensation]]\nid = \"other\"\nchannel = "
    "\"other\"\n"
    "[[sensation]]\nid = \"wish\"\nchannel = \"wish\"\n[[sensation]]\nid = \"weight\"\nchannel = \"weight\"\n";

std::string goal(std::string_view id, double value, double intensity) {
  return fmt::format("[[goal]]\nid = \"{}\"\nkind = \"Constant\"\nvalue = {}\nintensity = {}\n", id, value, intensity);
}
const std::string kTrainer = "[[goal]]\nid = \"trainer\"\nkind = \"App\"\nin.request = \"wish\"\n";

std::string regulator(std::string_view id, std::string_view setpoint, std::string_view more) {
  return fmt::format(
      "[[acting]]\nid = \"{}\"\nkind = \"PidRegulator\"\nin.setpoint = {}\nin.value = \"value\"\nmin = -10\nmax = "
      "10\n{}\n",
      id, setpoint, more);
}

struct Read {
  ControllerModel model;
  Problems problems;
};
Read read(const std::string& components) {
  Read result;
  const auto root = config::parse(std::string(kSensations) + components, "c.toml");
  EXPECT_TRUE(root) << root.error().text();
  result.model = read_controller(*root, controller_kinds(), result.problems);
  resolve(result.model, plant(), result.problems);
  return result;
}

/// A controller of the plant, fed by hand.
class Plant {
 public:
  explicit Plant(const std::string& components)
      : sense(make_sense_frame(plant())), act(make_act_frame(plant())), controller_(made(components)) {
    std::fill(sense.values.begin(), sense.values.end(), 0.0);
    std::fill(sense.ages_s.begin(), sense.ages_s.end(), 0.0);
  }
  void tick(double value, double wish = 0) {
    sense.values[0] = value;
    sense.values[2] = wish;
    sense.cost = 1;
    controller_.tick(sense, 0.1, act);
    ++sense.tick;
    sense.time_s += 0.1;
  }
  double signal(std::string_view name) const {
    for (std::size_t i = 0; i < controller_.signals().size(); ++i) {
      if (controller_.signals()[i].name == name) return controller_.values()[i];
    }
    ADD_FAILURE() << name;
    return std::numeric_limits<double>::quiet_NaN();
  }
  double heat() const { return act.values[0]; }
  double fan() const { return act.values[1]; }

  SenseFrame sense;
  ActFrame act;

 private:
  static Controller made(const std::string& components) {
    Read read = ganglion::read(components);
    EXPECT_EQ(read.problems.text(), "");
    return std::move(*Controller::compile(read.model, plant(), controller_kinds(), {}));
  }
  Controller controller_;
};

TEST(ASetPoint, IsFollowedAtTheVeryNextTickAndNeverSatisfied) {
  Plant plant(kTrainer + regulator("pid", "\"trainer\"", "command = \"heat\"\ntolerance = 0.1"));
  plant.tick(0, 2);
  EXPECT_EQ(plant.heat(), 2);
  EXPECT_EQ(plant.signal("pid.settled"), 0);
  plant.tick(0, 5);
  EXPECT_EQ(plant.heat(), 5) << "a latched request would still be 2";
  plant.tick(5, 5);
  EXPECT_EQ(plant.signal("pid.status"), 1) << "pending: it is held, not reached";
  EXPECT_EQ(plant.signal("pid.settled"), 1);
  plant.tick(5.2, 5);
  EXPECT_EQ(plant.signal("pid.settled"), 0);
}

TEST(ASetPoint, LapsesOnceNobodyWantsItAnyMore) {
  Plant plant(kTrainer + regulator("pid", "\"trainer\"", "command = \"heat\""));
  plant.tick(0, 2);
  plant.tick(0, std::nan(""));
  EXPECT_EQ(plant.heat(), 0);
  EXPECT_EQ(plant.act.origins[0], CommandOrigin::Safe);
  EXPECT_EQ(plant.signal("trainer.intensity"), 0);
  EXPECT_EQ(plant.signal("trainer.holds"), 0);
}

TEST(ASetPoint, GoesToTheStrongestGoalAtEveryTick) {
  Plant plant(goal("mild", 1, 0.5) + goal("strong", 3, 1) +
              regulator("pid", "[\"mild\", \"strong\"]", "command = \"heat\""));
  plant.tick(0);
  EXPECT_EQ(plant.heat(), 3);
  EXPECT_EQ(plant.signal("strong.holds"), 1);
  EXPECT_EQ(plant.signal("mild.holds"), 0);
  EXPECT_EQ(plant.signal("mild.intensity"), 0.5);
}

TEST(ASetPoint, MayBeAskedOfSeveralModulesByOneGoal) {
  Plant plant(kTrainer + regulator("one", "\"trainer\"", "command = \"heat\"") +
              regulator("two", "\"trainer\"", "kp = 2\ncommand = \"fan\""));
  plant.tick(1, 3);
  EXPECT_EQ(plant.heat(), 2);
  EXPECT_EQ(plant.fan(), 4);
}

TEST(AModuleAbove, DoesNotWaitForASetPoint) {
  Plant plant(kTrainer + regulator("upper", "\"trainer\"", "kp = 0.5") +
              regulator("lower", "\"upper\"", "command = \"heat\""));
  plant.tick(0, 4);
  EXPECT_EQ(plant.heat(), 2) << "upper asks lower for 0.5 * 4 in the same tick";
  plant.tick(1, 4);
  EXPECT_EQ(plant.heat(), 0.5) << "0.5 * 3 less 1: it asked anew";
}

const std::string kBlend = kTrainer + goal("still", 0, 1) + regulator("one", "\"trainer\"", "ki_per_s = 1") +
                           regulator("two", "\"still\"", "ki_per_s = 1");

TEST(Fusion, SharesByWeightAndLetsNobodyLearnFromABlend) {
  Plant plant(kBlend +
              "[[coordinator]]\nid = \"mix\"\nkind = \"WeightedSum\"\nin.commands = [\"one\", \"two\"]\n"
              "in.weights = [\"weight\", \"other\"]\ncommand = \"heat\"\n");
  plant.sense.values[3] = 3;
  plant.sense.values[1] = 1;
  plant.tick(1, 5);  // one: 4, two: -1
  EXPECT_EQ(plant.heat(), (3 * 4 + 1 * -1) / 4.0);
  EXPECT_EQ(plant.signal("mix.share.one"), 0.75);
  EXPECT_EQ(plant.signal("mix.active"), 0);
  EXPECT_EQ(plant.signal("mix.wanted.two"), 1);
  EXPECT_EQ(plant.signal("mix.suppressed.two"), 0);
  for (int i = 0; i < 3; ++i) plant.tick(1, 5);
  EXPECT_NEAR(plant.signal("one.integral"), 0.4, 1e-12) << "of the first tick alone, before it knew of the blend";
  plant.sense.values[1] = 0;
  plant.tick(1, 5);  // told of a blend still
  plant.tick(1, 5);
  plant.tick(1, 5);
  EXPECT_NEAR(plant.signal("one.integral"), 0.8, 1e-12) << "alone again, its sum goes on";
}

TEST(Fusion, WantsOneWeightForEachCandidate) {
  const Read read = ganglion::read(kBlend +
                                   "[[coordinator]]\nid = \"mix\"\nkind = \"WeightedSum\"\nin.commands = [\"one\", "
                                   "\"two\"]\nin.weights = [\"weight\"]\n"
                                   "command = \"heat\"\n");
  const std::string text = read.problems.text();
  EXPECT_NE(text.find("mix: input \"weights\" has 1 wires, must have one for each of the 2 candidates, in their order"),
            std::string::npos)
      << text;
}

TEST(ACommand, MeetsTheRobotsByNameNotByPlace) {
  Plant plant(kTrainer +
              regulator("pid", "\"trainer\"", "drives = \"tracks\"\nbase = 0.25\nkp = 0.125\ncommand = \"drive\""));
  plant.tick(0, 1);  // left 0.25 - 0.125, right 0.25 + 0.125; the robot has its right wheel first
  EXPECT_EQ(plant.act.values[2], 0.375);
  EXPECT_EQ(plant.act.values[3], 0.125);
  EXPECT_EQ(plant.signal("drive.left"), 0.125);
}

TEST(Check, RefusesWhatAKindWouldRefuseWithItsPlace) {
  const Read read = ganglion::read(kTrainer +
                                   "[[acting]]\nid = \"pid\"\nkind = \"PidRegulator\"\nin.setpoint = \"trainer\"\n"
                                   "in.value = \"value\"\nmin = 2\nmax = 1\ncommand = \"heat\"\n");
  EXPECT_EQ(read.problems.text(), "c.toml:19:6: pid: min is 2, must be less than max = 1\n");
}

}  // namespace
}  // namespace ganglion
