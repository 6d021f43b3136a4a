#include "ganglion/application/fault/faulty_application.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion {
namespace {

/// Counts up: at tick t sonar a reads t / 100, sonar b t / 100 + 1 and the heading 3 rad; keeps what it is told.
class Counter final : public Application {
 public:
  Counter() {
    description_.sensations = {{.name = "a.range", .unit = "m", .elements = {}, .min = 0, .max = 3},
                               {.name = "b.range", .unit = "m", .elements = {}, .min = 0, .max = 3},
                               {.name = "compass.heading", .unit = "rad", .type = ValueType::Circular, .elements = {}}};
    description_.sensations[0].dead = -7;
    description_.commands = {{"drive", {{.name = "left"}, {.name = "right", .unit = "", .safe = 0.25}}}};
  }
  const Description& description() const noexcept override { return description_; }
  int robots() const noexcept override { return 1; }
  Result<void> reset(std::uint64_t, std::uint32_t) override {
    tick_ = 0;
    return {};
  }
  void sense(std::span<SenseFrame> frames) noexcept override {
    frames[0].tick = tick_;
    frames[0].time_s = 0.1 * tick_;
    frames[0].values = {tick_ / 100.0, tick_ / 100.0 + 1, 3};
    frames[0].ages_s = {0, 0, 0};
  }
  void step(std::span<const ActFrame> frames, double) noexcept override {
    told = frames[0];
    ++tick_;
  }
  ActFrame told;

 private:
  Description description_;
  std::uint32_t tick_ = 0;
};

Fault fault(std::string target, FaultKind kind, double amount = 0) {
  Fault made;
  made.target = std::move(target);
  made.kind = kind;
  made.amount = amount;
  return made;
}

/// The frames of the ticks 0..count-1 as the controller sees them, and the commands {0.8, -0.8} as the robot does.
struct Seen {
  std::vector<SenseFrame> sensed;
  std::vector<ActFrame> told;
};

Seen drive(const std::vector<Fault>& faults, int count, std::uint64_t seed = 1) {
  Counter counter;
  auto faulty = FaultyApplication::make(counter, faults, 0.1);
  EXPECT_TRUE(faulty) << faulty.error().text();
  EXPECT_TRUE((*faulty)->reset(seed, 0));
  Seen seen;
  std::vector<SenseFrame> frames = {make_sense_frame(counter.description())};
  std::vector<ActFrame> commands = {make_act_frame(counter.description())};
  for (int n = 0; n < count; ++n) {
    (*faulty)->sense(frames);
    seen.sensed.push_back(frames[0]);
    commands[0].values = {0.8, -0.8 + n / 100.0};
    (*faulty)->step(commands, 0.1);
    seen.told.push_back(counter.told);
  }
  return seen;
}

TEST(FaultyApplication, IsTheApplicationItselfWithoutFaults) {
  const Seen seen = drive({}, 3);
  EXPECT_EQ(seen.sensed[2].values, (std::vector<double>{0.02, 1.02, 3}));
  EXPECT_EQ(seen.told[2].values, (std::vector<double>{0.8, -0.78}));
}

TEST(FaultyApplication, KillsADeviceFromItsTimeToItsEnd) {
  Fault dead = fault("a", FaultKind::Dead);
  dead.from_s = 0.2;
  dead.to_s = 0.4;
  const Seen seen = drive({dead, fault("b.range", FaultKind::Dead)}, 5);
  EXPECT_EQ(seen.sensed[1].values[0], 0.01);
  EXPECT_EQ(seen.sensed[2].values[0], -7);  // what the description says of the broken device
  EXPECT_EQ(seen.sensed[3].values[0], -7);
  EXPECT_EQ(seen.sensed[4].values[0], 0.04);
  EXPECT_TRUE(std::isnan(seen.sensed[4].values[1]));
}

TEST(FaultyApplication, SticksAtTheValueTheFaultBeganWith) {
  Fault stuck = fault("a", FaultKind::Stuck);
  stuck.from_s = 0.2;
  const Seen seen = drive({stuck}, 6);
  EXPECT_EQ(seen.sensed[1].values[0], 0.01);
  EXPECT_EQ(seen.sensed[5].values[0], 0.02);
  EXPECT_EQ(seen.sensed[5].values[1], 1.05);
}

TEST(FaultyApplication, AddsABiasWithinTheLimitsAndRoundTheCircle) {
  const Seen seen = drive({fault("b", FaultKind::Biased, 5), fault("compass", FaultKind::Biased, 1)}, 2);
  EXPECT_EQ(seen.sensed[1].values[1], 3);  // the most it can read
  EXPECT_NEAR(seen.sensed[1].values[2], 4 - 2 * kPi, 1e-12);
}

/// A reading of a robot's only channel after a fault.
double spoilt(const SensationChannel& channel, const Fault& what, double value, std::uint32_t tick = 0) {
  Description robot;
  robot.sensations = {channel};
  const auto plans = plan_faults({what}, robot, 1, 0.1);
  EXPECT_TRUE(plans) << plans.error().text();
  FaultAtWork work(plans->front());
  work.reset(1, 0, 0);
  std::vector<double> values = {value}, ages_s = {0};
  work.spoil(values, ages_s, tick, 0.1 * tick);
  return values[0];
}

const SensationChannel kBearing = {
    .name = "c.bearing", .type = ValueType::Discrete, .elements = {}, .min = 0, .max = 3599, .turn = 3600};

TEST(FaultyApplication, GoesRoundByWhatAFullTurnCounts) {
  const auto biased = [](double amount) { return fault("c.bearing", FaultKind::Biased, amount); };
  EXPECT_EQ(spoilt(kBearing, biased(300), 3590), 290);
  EXPECT_EQ(spoilt(kBearing, biased(-300), 10), 3310);
  EXPECT_EQ(spoilt(kBearing, biased(10), 3590), 0);
  EXPECT_EQ(spoilt(kBearing, biased(7211), 3590), 1);
  const SensationChannel longitude = {
      .name = "c.bearing", .unit = "deg", .elements = {}, .min = -180, .max = 180, .turn = 360};
  EXPECT_NEAR(spoilt(longitude, biased(0.5), 179.75), -179.75, 1e-9);
  EXPECT_NEAR(spoilt(longitude, biased(-0.5), -179.75), 179.75, 1e-9);
  SensationChannel heading = longitude;
  heading.type = ValueType::Circular;
  heading.min = -INFINITY;
  heading.max = INFINITY;
  EXPECT_NEAR(spoilt(heading, biased(30), 350), 20, 1e-9) << "degrees of a robot elsewhere, not radians";
}

TEST(FaultyApplication, AddsNoiseAcrossNorth) {
  const Fault noisy = fault("c.bearing", FaultKind::Noisy, 50);
  int east = 0, west = 0;
  for (std::uint32_t tick = 0; tick < 1000; ++tick) {
    const double bearing = spoilt(kBearing, noisy, 0, tick);
    EXPECT_EQ(bearing, std::floor(bearing));
    EXPECT_TRUE(bearing >= 0 && bearing < 3600) << bearing;
    ++(bearing < 1800 ? east : west);
  }
  EXPECT_NEAR(east, 504, 80);  // half of them, and those that round to 0; a standard error is 16
  EXPECT_NEAR(west, 496, 80);
}

TEST(FaultyApplication, AddsNoiseOfTheStatedDeviation) {
  Fault noisy = fault("b.range", FaultKind::Noisy, 0.05);
  const int count = 100;  // b reads 1.00 to 1.99: no limit is near
  double sum = 0, squares = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Seen seen = drive({noisy}, count, seed);
    for (int n = 0; n < count; ++n) {
      const double error = seen.sensed[static_cast<std::size_t>(n)].values[1] - (1 + n / 100.0);
      sum += error;
      squares += error * error;
    }
  }
  const double all = 40.0 * count;  // standard errors: 0.05 / sqrt(4000) = 0.0008 and 0.05 / sqrt(8000) = 0.00056
  EXPECT_NEAR(sum / all, 0, 4 * 0.0008);
  EXPECT_NEAR(std::sqrt(squares / all), 0.05, 4 * 0.00056);
}

TEST(FaultyApplication, DeliversLate) {
  const Seen seen = drive({fault("a", FaultKind::Late, 0.2), fault("commands", FaultKind::Late, 0.1)}, 4);
  EXPECT_TRUE(std::isnan(seen.sensed[1].values[0]));  // nothing has arrived yet
  EXPECT_EQ(seen.sensed[1].ages_s[0], INFINITY);
  EXPECT_EQ(seen.sensed[3].values[0], 0.01);
  EXPECT_NEAR(seen.sensed[3].ages_s[0], 0.2, 1e-12);
  EXPECT_EQ(seen.told[0].values, (std::vector<double>{0, 0.25}));  // safe
  EXPECT_EQ(seen.told[3].values, (std::vector<double>{0.8, -0.78}));
}

TEST(FaultyApplication, SwapsTwoSensors) {
  Fault swapped = fault("a", FaultKind::Swapped);
  swapped.with = "b";
  const Seen seen = drive({swapped}, 2);
  EXPECT_EQ(seen.sensed[1].values, (std::vector<double>{1.01, 0.01, 3}));
}

TEST(FaultyApplication, WeakensAMotor) {
  const Seen seen = drive({fault("drive.left", FaultKind::Weak, 0.25)}, 1);
  EXPECT_NEAR(seen.told[0].values[0], 0.6, 1e-15);
  EXPECT_EQ(seen.told[0].values[1], -0.8);
}

TEST(FaultyApplication, LosesFramesAndLetsTimesToLiveRunOut) {
  Fault all_sensed = fault("frames", FaultKind::Lost, 1), all_told = fault("commands", FaultKind::Lost, 1);
  all_sensed.from_s = all_told.from_s = 0.2;
  const Seen seen = drive({all_sensed, all_told}, 7);
  EXPECT_EQ(seen.sensed[4].values[0], 0.01);
  EXPECT_NEAR(seen.sensed[4].ages_s[0], 0.3, 1e-12);  // measured at 0.1 s, now it is 0.4 s
  EXPECT_EQ(seen.told[4].values[1], -0.79);
  EXPECT_NEAR(seen.told[3].ttl_s[0], 0.1, 1e-12);  // of 0.3 s two steps have gone
  EXPECT_EQ(seen.told[6].ttl_s[0], 0);
}

TEST(FaultyApplication, LosesTheStatedShareByTheSeed) {
  int held = 0;
  const Seen seen = drive({fault("a", FaultKind::Lost, 0.3)}, 1000);
  for (std::size_t n = 1; n < 1000; ++n) held += seen.sensed[n].ages_s[0] > 0 ? 1 : 0;
  EXPECT_NEAR(held, 300, 4 * std::sqrt(1000 * 0.3 * 0.7));
  const Seen again = drive({fault("a", FaultKind::Lost, 0.3)}, 1000),
             other = drive({fault("a", FaultKind::Lost, 0.3)}, 1000, 2);
  int differ = 0;
  for (std::size_t n = 0; n < 1000; ++n) {
    EXPECT_EQ(seen.sensed[n].ages_s, again.sensed[n].ages_s);
    differ += seen.sensed[n].ages_s == other.sensed[n].ages_s ? 0 : 1;
  }
  EXPECT_GT(differ, 100);
}

TEST(FaultyApplication, BeginsAtADrawnTimeWithItsChance) {
  Fault dead = fault("a", FaultKind::Dead);
  dead.from_s = 1;
  dead.from_latest_s = 3;
  dead.chance = 0.5;
  int happened = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Seen seen = drive({dead}, 32, seed);
    EXPECT_NE(seen.sensed[9].values[0], -7);
    happened += seen.sensed[31].values[0] == -7 ? 1 : 0;
    if (seen.sensed[31].values[0] == -7) continue;
    EXPECT_EQ(seen.sensed[25].values[0], 0.25);
  }
  EXPECT_NEAR(happened, 100, 4 * std::sqrt(200 * 0.25));
}

TEST(FaultyApplication, RefusesDelaysThatTakeTooMuchMemory) {
  // Three values: 1 s in steps of 10 ns are 1e8 rows of 24 bytes, 2.2 GiB.
  Counter counter;
  Fault late = fault("frames", FaultKind::Late, 1);
  late.place = {"e.toml", 7, 10};
  const auto refused = FaultyApplication::make(counter, {late}, 1e-8);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::TooLarge);
  EXPECT_EQ(refused.error().place, late.place);
  EXPECT_EQ(refused.error().what.en,
            "up to this one the faults of 1 robot remember 2289 MiB; the limit is 256: take shorter delays, fewer "
            "faults or fewer robots");
  EXPECT_TRUE(FaultyApplication::make(counter, {late}, 1e-6));
}

TEST(FaultSite, SaysWhatIsWrongWithAFault) {
  const Counter counter;
  const auto complaint = [&](const Fault& wrong) {
    const auto site = site_of(wrong, counter.description());
    return site ? std::string("none") : site.error().text();
  };
  EXPECT_EQ(complaint(fault("compas", FaultKind::Dead)),
            "\"compas\" is no sensor, channel or command of the robot; did you mean \"compass\"?");
  EXPECT_EQ(complaint(fault("a", FaultKind::Weak, 0.5)), "only commands grow weak; \"a\" is a sensation");
  EXPECT_EQ(complaint(fault("a", FaultKind::Lost, 2)), "amount is a probability, must be > 0 and at most 1");
  Fault swapped = fault("a", FaultKind::Swapped);
  swapped.with = "frames";
  EXPECT_EQ(complaint(swapped), "\"a\" and \"frames\" cannot be swapped: they differ in shape");
  EXPECT_EQ(complaint(fault("frames", FaultKind::Dead)), "none");
  const auto unknown = site_of(fault("compas", FaultKind::Dead), counter.description());
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().what.es, "\"compas\" no es un sensor, canal ni mando del robot; ¿quiso decir \"compass\"?");
  EXPECT_EQ(unknown.error().subject.found, "compas");
  EXPECT_FALSE(unknown.error().subject.choices.empty());
}

}  // namespace
}  // namespace ganglion
