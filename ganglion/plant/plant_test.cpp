#include <gtest/gtest.h>

#include <cmath>

#include "ganglion/module/testing/allocations.h"
#include "ganglion/plant/plant_application.h"

namespace ganglion {

extern const PlantKind process_kind;
extern const TaskKind hold_kind;

namespace {

constexpr std::array kPlants = {&process_kind};
constexpr std::array kTasks = {&hold_kind};

std::shared_ptr<const ApplicationModel> model_of(const std::string& more, Problems& problems, int robots = 1) {
  const auto file = config::parse("format = 1\nname = \"oven\"\nkind = \"Process\"\n" + more, "oven.toml");
  EXPECT_TRUE(file) << file.error().text();
  return PlantModel::read({.file = *file, .robots = robots}, kPlants, kTasks, problems);
}

/// A plant with its frames.
struct Oven {
  explicit Oven(const std::string& more, int robots = 1) {
    Problems problems;
    model = model_of(more, problems, robots);
    EXPECT_TRUE(model) << problems.text();
    auto made = model->make();
    EXPECT_TRUE(made) << made.error().what.en;
    application = std::move(*made);
    EXPECT_TRUE(application->reset(1, 0));
    senses.assign(static_cast<std::size_t>(robots), make_sense_frame(application->description()));
    acts.assign(static_cast<std::size_t>(robots), make_act_frame(application->description()));
    for (ActFrame& act : acts) act.ttl_s.assign(1, 1e9);
    application->sense(senses);
  }
  void go(double command, double step_s) {
    for (ActFrame& act : acts) act.values = {command};
    application->step(acts, step_s);
    application->sense(senses);
  }
  std::shared_ptr<const ApplicationModel> model;
  std::unique_ptr<Application> application;
  std::vector<SenseFrame> senses;
  std::vector<ActFrame> acts;
};

TEST(Plant, IsDescribedByItsPortsAndItsTasks) {
  Problems problems;
  const auto model =
      model_of("min = 0\nmax = 2\n[[task]]\nid = \"wanted\"\nkind = \"Hold\"\nvalues = [3, 1]\n", problems);
  ASSERT_TRUE(model) << problems.text();
  const Description& description = model->description();
  EXPECT_FALSE(description.body);
  std::vector<std::string> names;
  for (const SensationChannel& channel : description.sensations) names.push_back(channel.name);
  EXPECT_EQ(names, (std::vector<std::string>{"value", "trial", "wanted.setpoint", "wanted.left_s"}));
  EXPECT_EQ(description.sensations[2].max, 3);
  ASSERT_EQ(description.commands.size(), 1u);
  EXPECT_EQ(description.commands[0].name, "command");
  EXPECT_EQ(description.commands[0].elements[0].max, 2);
  EXPECT_EQ(description.commands[0].elements[0].safe, 0);
  ASSERT_EQ(model->truth().size(), 3u);
  EXPECT_TRUE(model->truth()[0].digested);
  EXPECT_EQ(model->ledgers()[0].task, "wanted");
  EXPECT_EQ(model->terrain(), nullptr);
  EXPECT_EQ(model->scene(1, 0), "");
}

TEST(Plant, SaysWhatIsWrongWithItsFileAndWhere) {
  Problems problems;
  EXPECT_FALSE(model_of("lag_s = -1\ngian = 2\n[[task]]\nid = \"value\"\nkind = \"Hold\"\n", problems));
  const std::string text = problems.text();
  EXPECT_NE(text.find("oven.toml:4:9: lag_s is -1"), std::string::npos) << text;
  EXPECT_NE(text.find("gian"), std::string::npos) << text;
  EXPECT_NE(text.find("id \"value\" is given twice"), std::string::npos) << text;
}

TEST(Plant, GoesByStepsAndCosts) {
  Oven oven("lag_s = 1\n");
  EXPECT_FALSE(oven.senses[0].cost) << "the first frame of an episode";
  oven.go(0.5, 1);
  EXPECT_NEAR(oven.senses[0].values[0], 0.5 * (1 - std::exp(-1.0)), 1e-12);
  EXPECT_DOUBLE_EQ(*oven.senses[0].cost, 0.5);
  EXPECT_EQ(oven.senses[0].tick, 1u);
  EXPECT_EQ(oven.senses[0].time_s, 1);
  EXPECT_DOUBLE_EQ(oven.application->witness()->truth_of(0)[0], oven.senses[0].values[0]);
}

TEST(Plant, TakesItsSafeValueOnceACommandHasLapsed) {
  Oven oven("lag_s = 1\n");
  oven.acts[0].ttl_s = {0.25};
  oven.go(1, 1);
  EXPECT_NEAR(oven.senses[0].values[0], (1 - std::exp(-0.25)) * std::exp(-0.75), 1e-12);
  EXPECT_DOUBLE_EQ(*oven.senses[0].cost, 0.25);
}

TEST(Plant, PutsItselfBackWhereItFailedAndCountsTheTrials) {
  Oven oven("gain = 10\nlag_s = 1\ntrip = 5\n");
  oven.go(1, 0.5);
  EXPECT_EQ(oven.senses[0].values[1], 0);
  oven.go(1, 0.5);
  EXPECT_EQ(oven.senses[0].values[0], 0) << "it begins anew";
  EXPECT_EQ(oven.senses[0].values[1], 1);
  EXPECT_FALSE(oven.senses[0].cost) << "what the failure cost is nobody's";
  oven.go(1, 0.5);
  EXPECT_NEAR(oven.senses[0].values[0], 10 * (1 - std::exp(-0.5)), 1e-12);
  EXPECT_TRUE(oven.senses[0].cost);
}

TEST(Plant, IsOneOfSeveralEachByItself) {
  Oven oven("lag_s = 1\nnoise = 0.1\n", 2);
  oven.go(1, 1);
  EXPECT_NE(oven.senses[0].values[0], oven.senses[1].values[0]) << "their noise is their own";
  EXPECT_EQ(oven.application->witness()->truth_of(0)[0], oven.application->witness()->truth_of(1)[0]);
}

TEST(Plant, IsAskedForSetPointsByATask) {
  Oven oven("[[task]]\nid = \"wanted\"\nkind = \"Hold\"\nvalues = [3, 1]\neach_s = 2\n");
  EXPECT_EQ(oven.senses[0].values[2], 3);
  EXPECT_EQ(oven.senses[0].values[3], 2);
  oven.go(0, 1);
  EXPECT_EQ(oven.senses[0].values[2], 3);
  oven.go(0, 1);
  EXPECT_EQ(oven.senses[0].values[2], 1);
  EXPECT_TRUE(std::isinf(oven.senses[0].values[3]));
  const Ledger* ledger = oven.application->witness()->ledger(0, "wanted");
  ASSERT_NE(ledger, nullptr);
  ASSERT_EQ(ledger->rows(), 2u);
  EXPECT_EQ(ledger->at(1, 0), 2) << "set at 2 s";
  EXPECT_EQ(ledger->at(1, 1), 1);
  EXPECT_TRUE(ledger->done());
}

TEST(Plant, TakesNoMemoryInSteps) {
  Oven oven(
      "dead_time_s = 1\nsecond_lag_s = 2\nnoise = 1\n[[task]]\nid = \"w\"\nkind = \"Hold\"\nvalues = [1, 2]\neach_s = "
      "0.3\nagain = true\n",
      3);
  const std::uint64_t before = testing::allocations();
  for (int n = 0; n < 200; ++n) {
    oven.application->step(oven.acts, 0.05);
    oven.application->sense(oven.senses);
  }
  EXPECT_EQ(testing::allocations() - before, 0u);
}

TEST(Plant, TakesNoIntervention) {
  Oven oven("");
  const auto done = oven.application->intervene({"obstacle", 0, "crate", {{"x_m", 1}, {"y_m", 1}}});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().what.en, "\"obstacle\" cannot be done to oven");
}

}  // namespace
}  // namespace ganglion
