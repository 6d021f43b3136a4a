#include "ganglion/graph/order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ganglion/graph/testing/rig.h"

namespace ganglion {
namespace {

using testing::gain, testing::seeker, testing::sensations;

/// The ids in the order of a schedule's list.
std::vector<std::string> names(const ControllerModel& model, const std::vector<int>& order) {
  std::vector<std::string> result;
  for (const int index : order) result.push_back(model.components[static_cast<std::size_t>(index)].id);
  return result;
}

ControllerModel model_of(const std::string& text) {
  Problems problems;
  const auto value = config::parse("format = 1\n" + text, "controller.toml");
  ControllerModel model = read_controller(*value, testing::kinds(), problems);
  resolve(model, testing::test_robot(), problems);
  EXPECT_TRUE(problems.empty()) << problems.text();
  return model;
}

const std::string kWish = testing::wish("wish", "values = [1]");

TEST(Order, RunsUpperModulesFirstDownwardsAndLowerOnesFirstUpwards) {
  const ControllerModel model = model_of(sensations({"place"}) + seeker("low", "middle", "command = \"move\"") +
                                         seeker("middle", "high") + seeker("high", "wish") + kWish);
  Problems problems;
  const Schedule schedule = order(model, problems);
  EXPECT_EQ(names(model, schedule.acting), (std::vector<std::string>{"high", "middle", "low"}));
  EXPECT_EQ(names(model, schedule.upward), (std::vector<std::string>{"low", "middle", "high"}));
  EXPECT_EQ(names(model, schedule.goals), (std::vector<std::string>{"wish"}));
}

TEST(Order, RunsCandidatesBeforeTheirCoordinatorAndThatBeforeTheModuleItAsks) {
  const ControllerModel model = model_of(sensations({"place"}) + seeker("low", "arbiter", "command = \"move\"") +
                                         "[[coordinator]]\nid = \"arbiter\"\nkind = \"First\"\nin.commands = "
                                         "[\"high\"]\n" +
                                         seeker("high", "wish") + kWish);
  Problems problems;
  const Schedule schedule = order(model, problems);
  EXPECT_EQ(names(model, schedule.acting), (std::vector<std::string>{"high", "arbiter", "low"}));
  EXPECT_EQ(names(model, schedule.upward), (std::vector<std::string>{"low", "high"}));
}

TEST(Order, KeepsTheOrderOfTheFileAmongEquals) {
  const ControllerModel model =
      model_of(sensations({"a"}) + gain("d", "a") + gain("b", "c") + gain("c", "a") + gain("a2", "a"));
  Problems problems;
  EXPECT_EQ(names(model, order(model, problems).sensing), (std::vector<std::string>{"d", "c", "b", "a2"}));
}

TEST(Order, NamesThePathOfEveryCircle) {
  const ControllerModel model = model_of(sensations({"a"}) + gain("victim", "x") + gain("x", "z") + gain("y", "x") +
                                         gain("z", "y") + gain("self", "self"));
  Problems problems;
  order(model, problems);
  EXPECT_EQ(problems.text(),
            "controller.toml:16:9: x: these wires run in a circle within one tick: x -> y -> z -> x; write "
            "\"x@previous\" to break it\n"
            "controller.toml:24:9: self: these wires run in a circle within one tick: self -> self; write "
            "\"self@previous\" to break it\n");
}

TEST(Order, OpensACircleByAWireMarkedPrevious) {
  const ControllerModel model = model_of(gain("x", "y@previous") + gain("y", "x"));
  Problems problems;
  EXPECT_EQ(names(model, order(model, problems).sensing), (std::vector<std::string>{"x", "y"}));
  EXPECT_TRUE(problems.empty());
}

TEST(Order, RefusesModulesThatAskEachOther) {
  const ControllerModel model = model_of(sensations({"place"}) + seeker("one", "two") + seeker("two", "one"));
  Problems problems;
  order(model, problems);
  EXPECT_NE(problems.text().find("one -> two -> one; commands cannot; take one of these wires out"), std::string::npos)
      << problems.text();
}

/// Each takes the next one's value, against the order of the file.
std::string backward_chain(int count) {
  std::string text = sensations({"a"});
  for (int i = 1; i < count; ++i) text += gain(fmt::format("n{}", i), fmt::format("n{}", i + 1));
  return text + gain(fmt::format("n{}", count), "a");
}

TEST(Order, MastersTheLongestChainAgainstTheFile) {
  const int count = static_cast<int>(kMaxComponents) - 1;
  const ControllerModel model = model_of(backward_chain(count));
  Problems problems;
  const Schedule schedule = order(model, problems);
  ASSERT_EQ(schedule.sensing.size(), static_cast<std::size_t>(count));
  EXPECT_EQ(model.components[static_cast<std::size_t>(schedule.sensing.front())].id, fmt::format("n{}", count));
  EXPECT_EQ(model.components[static_cast<std::size_t>(schedule.sensing.back())].id, "n1");
}

}  // namespace
}  // namespace ganglion
