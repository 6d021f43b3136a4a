// Sensors on robots in a world: when they fire, what faults make of them, and that a run is a function of its seed.
#include <cmath>
#include <cstring>

#include "ganglion/base/hash.h"
#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

using testing::at;
using testing::kFast;
using testing::kRoom;
using testing::Trial;

const std::string kSensors =
    "[[sensor]]\nid = \"sonar\"\nkind = \"Sonar\"\nx_m = 0.1\nyaw_deg = 5\n"
    "[[sensor]]\nid = \"compass\"\nkind = \"Compass\"\nnoise_deg = 1\nlag_s = 0.3\n"
    "[[sensor]]\nid = \"place\"\nkind = \"Position\"\nnoise_m = 0.01\n"
    "[[sensor]]\nid = \"skin\"\nkind = \"Bumper\"\n";

TEST(Simulation, DescribesItsSensationsAndCommands) {
  Trial trial(kRoom, kFast + kSensors, at(5, 5));
  const Description& description = trial.simulation->description();
  ASSERT_EQ(description.sensations.size(), 5u);
  EXPECT_EQ(description.sensations[0].name, "sonar.range");
  EXPECT_EQ(description.sensations[0].min, 0.02);
  EXPECT_EQ(description.sensations[0].max, 3);
  EXPECT_EQ(description.mount("sonar.range")->pose.position, (Vector2{0.1, 0}));
  EXPECT_EQ(description.sensations[1].name, "sonar.echo_time");
  EXPECT_EQ(description.sensations[2].type, ValueType::Circular);
  EXPECT_EQ(description.sensations[3].elements, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(description.sensation_values(), 6);
  ASSERT_EQ(description.commands.size(), 1u);
  EXPECT_EQ(description.commands[0].name, "drive");
  EXPECT_EQ(description.commands[0].elements[1].name, "right");
}

TEST(Simulation, HasReadingsButNoCostInTheFirstFrame) {
  Trial trial(kRoom, kFast + "[[sensor]]\nid = \"place\"\nkind = \"Position\"\nx_m = 0.1\n", at(5, 5, 90));
  EXPECT_FALSE(trial.senses[0].cost);
  EXPECT_EQ(trial.senses[0].tick, 0u);
  EXPECT_NEAR(trial.senses[0].values[0], 5, 1e-12);
  EXPECT_NEAR(trial.senses[0].values[1], 5.1, 1e-12);
  trial.go({0, 0}, 0.1);
  EXPECT_TRUE(trial.senses[0].cost);
}

TEST(Simulation, FiresSensorsAtTheirPeriodsAndTellsTheirAges) {
  Trial trial(kRoom,
              kFast +
                  "[[sensor]]\nid = \"slow\"\nkind = \"Position\"\nperiod_s = 0.25\nphase_s = 0.1\n"
                  "[[sensor]]\nid = \"each\"\nkind = \"Position\"\n",
              at(5, 5));
  EXPECT_TRUE(std::isnan(trial.value("slow.position")));
  EXPECT_EQ(trial.age_s("slow.position"), std::numeric_limits<double>::infinity());
  // Fires at 0.1, 0.35, 0.6, 0.85 s; at 1 m/s it then stands at 5 + t.
  const std::array<double, 10> fired_s = {0.1, 0.1, 0.1, 0.35, 0.35, 0.6, 0.6, 0.6, 0.85, 0.85};
  for (std::size_t n = 0; n < fired_s.size(); ++n) {
    trial.go({1, 1}, 0.1);
    const double now_s = 0.1 * static_cast<double>(n + 1);
    EXPECT_NEAR(trial.value("slow.position"), 5 + fired_s[n], 1e-9) << n;
    EXPECT_NEAR(trial.age_s("slow.position"), now_s - fired_s[n], 1e-9) << n;
    EXPECT_NEAR(trial.value("each.position"), 5 + now_s, 1e-9);
    EXPECT_NEAR(trial.age_s("each.position"), 0, 1e-12);
  }
}

TEST(Simulation, ShowsOnlyTheLastFiringOfAStep) {
  Trial trial(kRoom, kFast + "[[sensor]]\nid = \"quick\"\nkind = \"Position\"\nperiod_s = 0.03\n", at(5, 5));
  trial.go({1, 1}, 0.1);
  EXPECT_NEAR(trial.value("quick.position"), 5.09, 1e-9);
  EXPECT_NEAR(trial.age_s("quick.position"), 0.01, 1e-9);
}

TEST(Simulation, SilencesDeadSensorsFromTheMomentStated) {
  Trial trial(kRoom,
              kFast +
                  "[[sensor]]\nid = \"sonar\"\nkind = \"Sonar\"\nfault = \"dead\"\nfault_from_s = 0.2\n"
                  "[[sensor]]\nid = \"place\"\nkind = \"Position\"\nfault = \"dead\"\nfault_from_s = 0.2\n",
              at(9, 5));
  trial.go({0, 0}, 0.1);
  EXPECT_NEAR(trial.value("sonar.range"), 1, 0.06);
  trial.go({0, 0}, 0.1);
  EXPECT_TRUE(std::isnan(trial.value("sonar.range")));
  EXPECT_EQ(trial.value("sonar.echo_time"), 0);  // the device gave no pulse
  EXPECT_TRUE(std::isnan(trial.value("place.position")));
}

TEST(Simulation, RepeatsTheLastReadingOfStuckSensorsAsFresh) {
  Trial trial(kRoom, kFast + "[[sensor]]\nid = \"place\"\nkind = \"Position\"\nfault = \"stuck\"\nfault_from_s = 0.2\n",
              at(5, 5));
  trial.go({1, 1}, 0.1, 5);
  EXPECT_NEAR(trial.value("place.position"), 5.1, 1e-9);
  EXPECT_EQ(trial.age_s("place.position"), 0);
}

TEST(Simulation, StartsADinsmoreCompassSettled) {
  Trial trial(kRoom, kFast + "[[sensor]]\nid = \"needle\"\nkind = \"DinsmoreCompass\"\nbits = 0\n", at(5, 5, 0));
  EXPECT_NEAR(trial.value("needle.va"), 2.5, 1e-9);
  EXPECT_NEAR(trial.value("needle.vb"), 3.094, 1e-9);  // x is east
}

/// Every bit that robot 0 reports in 100 steps of a lively drive.
std::uint64_t digest(Trial& trial, std::uint64_t seed, std::uint32_t episode) {
  trial.reset(seed, episode);
  std::uint64_t hash = 0;
  for (int n = 0; n < 100; ++n) {
    trial.go({1, 0.5 + 0.5 * ((n / 10) % 2)}, 0.1);
    for (const double value : trial.senses[0].values) hash = combine(hash, canonical_bits(value));
    for (const double age_s : trial.senses[0].ages_s) hash = combine(hash, canonical_bits(age_s));
    hash = combine(hash, canonical_bits(*trial.senses[0].cost));
    hash = combine(hash, canonical_bits(trial.truth().pose.yaw.rad()));
  }
  return hash;
}

constexpr std::string_view kHall =
    "format = 1\nname = \"hall\"\n[[wall]]\npoints = [[0, 0], [300, 0], [300, 10], [0, 10]]\nclosed = true\n"
    "[[box]]\nx_m = 4\ny_m = 6\nlength_m = 1\nwidth_m = 1\nmaterial = \"smooth\"\n";

TEST(Simulation, GivesTheSameBitsAloneAndAmongAHundredFarAwayRobots) {
  Trial alone(kHall, kFast + kSensors, at(2, 2));
  SpawnPoses many{{{{2, 2}, {}}}};
  for (int n = 0; n < 100; ++n) many.poses.push_back({{100.0 + n, 5}, Angle::from_deg(3.6 * n)});
  Trial among(kHall, kFast + kSensors, many, 101);
  EXPECT_EQ(digest(alone, 5, 0), digest(among, 5, 0));
  EXPECT_GT(among.truth(50).travelled_m, 1);
}

TEST(Simulation, GivesTheSameBitsAfterAResetAsFresh) {
  Trial fresh(kHall, kFast + kSensors, SpawnRandom{}), used(kHall, kFast + kSensors, SpawnRandom{});
  const std::uint64_t other = digest(used, 5, 1);
  const std::uint64_t expected = digest(fresh, 5, 0);
  EXPECT_EQ(digest(used, 5, 0), expected);
  EXPECT_NE(other, expected);
  EXPECT_NE(digest(used, 6, 0), expected);
}

TEST(Simulation, SeesTheOtherRobotsThatItStandsAmong) {
  Trial trial(kRoom, kFast + "[[sensor]]\nid = \"eye\"\nkind = \"Range\"\nx_m = 0.1\n",
              SpawnPoses{{{{2, 5}, {}}, {{4, 5}, Angle::from_deg(180)}}}, 2);
  EXPECT_NEAR(trial.value("eye.range", 0), 1.8, 1e-9);
  EXPECT_NEAR(trial.value("eye.range", 1), 1.8, 1e-9);
}

TEST(Simulation, LetsSonarsHearEachOtherWithinASlotOnly) {
  // One sonar 0.08 m behind the centre, one 0.08 m ahead; the wall is 2 m from the centre. The rear one takes the
  // other's ping, 1.92 m there and 2.08 m back, for an echo of 2 m.
  const auto robot = [](double phase_s, bool crosstalk) {
    return kFast + fmt::format(
                       "[[sensor]]\nid = \"rear\"\nkind = \"Sonar\"\nx_m = -0.08\nrays = 1\nnoise_m = 0\n"
                       "resolution_m = 0\nperiod_s = 0.2\ncrosstalk = {}\n"
                       "[[sensor]]\nid = \"front\"\nkind = \"Sonar\"\nx_m = 0.08\nrays = 1\nnoise_m = 0\n"
                       "period_s = 0.2\nphase_s = {}\n",
                       crosstalk, phase_s);
  };
  for (const int steps : {0, 4}) {
    Trial together(kRoom, robot(0, true), at(8, 5)), in_turn(kRoom, robot(0.1, true), at(8, 5)),
        without(kRoom, robot(0, false), at(8, 5));
    for (Trial* trial : {&together, &in_turn, &without}) trial->go({0, 0}, 0.1, steps);
    EXPECT_NEAR(together.value("rear.range"), 2, 1e-5) << steps;
    EXPECT_NEAR(in_turn.value("rear.range"), 2.08, 1e-9) << steps;
    EXPECT_NEAR(without.value("rear.range"), 2.08, 1e-9) << steps;
  }
}

}  // namespace
}  // namespace ganglion::sim
