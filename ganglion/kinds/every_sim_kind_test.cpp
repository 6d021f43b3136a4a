#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ganglion/kinds/kinds.h"
#include "ganglion/module/testing/allocations.h"
#include "ganglion/sim/simulation/testing/trial.h"

// What holds for every kind of sensor and drive there is: a new one is covered at birth.
namespace ganglion {
namespace {

constexpr std::string_view kWorld =
    "format = 1\nname = \"w\"\n[[wall]]\npoints = [[0, 0], [6, 0], [6, 6], [0, 6]]\nclosed = true\n"
    "[[mover]]\nid = \"m\"\nlength_m = 0.4\nwidth_m = 0.4\nplaces = [[1, 1], [5, 5], [1, 5]]\nchange_after_s = [0.2, "
    "1]\n";

/// A round robot of 0.1 m with that drive and those sensors, all as they are by themselves.
std::shared_ptr<const sim::RobotModel> robot_with(const Descriptor& drive, std::span<const Descriptor* const> sensors) {
  std::string text = fmt::format(
      "format = 1\nname = \"r\"\n[body]\nlength_m = 0.2\nwidth_m = 0.2\nradius_m = 0.1\n[drive]\nkind = \"{}\"\n",
      drive.name);
  for (const Descriptor* one : sensors) text += fmt::format("[[sensor]]\nid = \"s_{0}\"\nkind = \"{0}\"\n", one->name);
  Problems problems;
  auto model = sim::parse_robot(text, "robot.toml", sim_kinds(), problems);
  EXPECT_TRUE(model) << problems.text();
  return model;
}

std::vector<const Descriptor*> sensors() {
  std::vector<const Descriptor*> all;
  for (const sim::SensorKind* kind : sim_kinds().sensors) all.push_back(&kind->descriptor);
  return all;
}

std::vector<const Descriptor*> drives_and_sensors() {
  std::vector<const Descriptor*> all = sensors();
  for (const sim::DriveKind* kind : sim_kinds().drives) all.push_back(&kind->descriptor);
  return all;
}

/// A test for each kind there is, named after it: whoever adds one sees it walked. A drive carries all sensors, which
/// share what they look at; a sensor rides on the first drive.
class OfRobots : public ::testing::TestWithParam<const Descriptor*> {
 protected:
  OfRobots() {
    const bool drives = GetParam()->component_class == ComponentClass::Drive;
    const Descriptor& drive = drives ? *GetParam() : sim_kinds().drives.front()->descriptor;
    const std::vector<const Descriptor*> carried = drives ? sensors() : std::vector{GetParam()};
    trial_ = std::make_unique<sim::testing::Trial>(sim::testing::ground_of(kWorld), robot_with(drive, carried),
                                                   sim::SpawnRandom{}, 8);
  }
  void step(double value) {
    for (ActFrame& act : trial_->acts) std::fill(act.values.begin(), act.values.end(), value);
    trial_->simulation->step(trial_->acts, 0.1);
    trial_->simulation->sense(trial_->senses);
  }
  std::unique_ptr<sim::testing::Trial> trial_;
};

TEST_P(OfRobots, StepsWithoutTakingMemoryWhateverIsCommanded) {
  const std::uint64_t before = testing::allocations();
  for (int n = 0; n < 100; ++n) {
    step(n % 20 < 15 ? 1 - n % 3 * 0.25 : -0.5);
    ASSERT_EQ(testing::allocations(), before) << "allocates in step " << n;
  }
}

TEST_P(OfRobots, StaysInThisWorldWhateverIsCommanded) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  constexpr std::array kCommands = {std::nan(""), 1.0, kInf, -1.0, -kInf, 1e300, 0.3};
  for (int n = 0; n < 140; ++n) {
    step(kCommands[static_cast<std::size_t>(n / 5) % kCommands.size()]);
    for (int robot = 0; robot < 8; ++robot) {
      const sim::Truth& truth = trial_->truth(robot);
      ASSERT_LE(std::hypot(truth.pose.position.x, truth.pose.position.y), 10) << "robot " << robot << ", step " << n;
      ASSERT_TRUE(std::isfinite(truth.pose.yaw.rad()) && std::isfinite(truth.energy_J)) << "step " << n;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, OfRobots, ::testing::ValuesIn(drives_and_sensors()),
                         [](const auto& one) { return std::string(one.param->name); });

TEST(EveryKind, OfRobotsHasPortsThatFitItsClass) {
  for (const sim::DriveKind* kind : sim_kinds().drives) {
    EXPECT_EQ(kind->descriptor.component_class, ComponentClass::Drive) << kind->descriptor.name;
    ASSERT_EQ(kind->descriptor.ports.size(), 1u) << kind->descriptor.name;
    EXPECT_EQ(kind->descriptor.ports[0].role, PortRole::Command) << kind->descriptor.name;
  }
  for (const sim::SensorKind* kind : sim_kinds().sensors) {
    EXPECT_EQ(kind->descriptor.component_class, ComponentClass::Sensor) << kind->descriptor.name;
    for (const PortDescriptor& port : kind->descriptor.ports) EXPECT_EQ(port.role, PortRole::Output) << port.name;
  }
}

/// What a sensor reads standing somewhere, after it has been led about or not.
std::vector<double> reading_of(const sim::SensorKind& kind, bool led_about) {
  const auto sensor = sim::testing::made(kind);
  sim::testing::Stage stage(sim::testing::kRoom);
  std::size_t size = 0;
  for (const PortDescriptor& port : kind.descriptor.ports) size += static_cast<std::size_t>(port.size);
  std::vector<double> values(size);
  EXPECT_TRUE(sensor->reset(stage.at({{1, 1}, {}}), Draws(StreamId{}, 0)));
  for (std::uint32_t tick = 1; led_about && tick < 5; ++tick) {
    stage.robot.left_m = stage.robot.right_m = 0.3 * tick;
    const sim::Scene scene = stage.at({{2.0 + tick, 3}, Angle::from_deg(50.0 * tick)}, tick);
    Draws draws(StreamId{}, tick);
    sensor->follow(scene, 0.5);
    sensor->measure(scene, draws, values);
  }
  stage.robot.left_m = stage.robot.right_m = 2;
  Draws draws(StreamId{}, 9);
  sensor->measure(stage.at({{4, 6}, Angle::from_deg(20)}, 9), draws, values);
  return values;
}

class OfSensors : public ::testing::TestWithParam<const sim::SensorKind*> {};

TEST_P(OfSensors, ReadsWithinItsLimits) {
  const auto sensor = sim::testing::made(*GetParam());
  const std::vector<double> values = reading_of(*GetParam(), true);
  std::size_t channel = 0, value = 0;
  for (const PortDescriptor& port : GetParam()->descriptor.ports) {
    const sim::Limits limits = sensor->limits(channel++);
    for (int i = 0; i < port.size; ++i) {
      const double reading = values[value++];
      if (!std::isfinite(reading)) continue;
      EXPECT_GE(reading, limits.min) << port.name;
      EXPECT_LE(reading, limits.max) << port.name;
    }
  }
}

TEST_P(OfSensors, ThatRemembersNothingReadsTheSameWhateverCameBefore) {
  if (sim::testing::made(*GetParam())->remembers()) return;
  EXPECT_EQ(reading_of(*GetParam(), true), reading_of(*GetParam(), false));
}

INSTANTIATE_TEST_SUITE_P(EveryKind, OfSensors, ::testing::ValuesIn(sim_kinds().sensors),
                         [](const auto& one) { return std::string(one.param->descriptor.name); });

}  // namespace
}  // namespace ganglion
