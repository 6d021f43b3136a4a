#include "ganglion/application/application.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ganglion {
namespace {

Description robot() {
  Description robot;
  robot.sensations = {{"a.range", "m"}, {"b.position", "m", ValueType::Real, {"x", "y", "z"}}, {"c.range", "m"}};
  robot.commands = {{"drive", {{"left"}, {"right", "", -1, 1, 0.25}}}, {"grip", {{"force", "N", 0, 5, 2}}}};
  return robot;
}

TEST(Description, LaysValuesOneAfterTheOther) {
  EXPECT_EQ(robot().sensation_offset(0), 0);
  EXPECT_EQ(robot().sensation_offset(2), 4);
  EXPECT_EQ(robot().sensation_values(), 5);
  EXPECT_EQ(robot().command_offset(1), 2);
  EXPECT_EQ(robot().command_values(), 3);
}

TEST(Description, FindsChannelsByName) {
  const Description described = robot();
  EXPECT_EQ(described.sensation("c.range"), &described.sensations[2]);
  EXPECT_EQ(described.sensation("c"), nullptr);
  EXPECT_EQ(described.command("grip"), &described.commands[1]);
  EXPECT_EQ(described.command(""), nullptr);
}

TEST(SenseFrame, BeginsWithoutReadings) {
  const SenseFrame frame = make_sense_frame(robot());
  ASSERT_EQ(frame.values.size(), 5u);
  ASSERT_EQ(frame.ages_s.size(), 3u);
  for (const double value : frame.values) EXPECT_TRUE(std::isnan(value));
  for (const double age_s : frame.ages_s) EXPECT_EQ(age_s, INFINITY);
  EXPECT_FALSE(frame.cost);
}

TEST(ActFrame, BeginsSafe) {
  const ActFrame frame = make_act_frame(robot());
  EXPECT_EQ(frame.values, (std::vector<double>{0, 0.25, 2}));
  EXPECT_EQ(frame.origins, (std::vector<CommandOrigin>{CommandOrigin::Safe, CommandOrigin::Safe}));
  EXPECT_EQ(frame.ttl_s.size(), 2u);
  EXPECT_EQ(frame.reasons, (std::vector<std::uint16_t>{0, 0}));
}

}  // namespace
}  // namespace ganglion
