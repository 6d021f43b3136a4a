// Somebody reaches into a running simulation: sets goals, puts obstacles elsewhere.
#include <cmath>

#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

const GoalLedger& goals(const testing::Trial& trial) {
  return static_cast<const GoalLedger&>(*trial.application->witness()->ledger(0, "app"));
}

using testing::at;
using testing::Trial;

/// 8 x 4 cells of 0.5 m; a closed closet of the two cells {6, 0} and {7, 0}; a crate.
constexpr std::string_view kFlat =
    "format = 1\nname = \"flat\"\n[[wall]]\npoints = [[0, 0], [4, 0], [4, 2], [0, 2]]\nclosed = true\n"
    "[[wall]]\npoints = [[3, 0], [3, 0.5], [4, 0.5]]\n"
    "[[mover]]\nid = \"crate\"\nlength_m = 0.4\nwidth_m = 0.4\nplaces = [[3.75, 1.75]]\n";

std::string stepper_with(const std::string& task) {
  return "[drive]\nkind = \"Stepper\"\nmax_turn_deg = 180\n[[task]]\nid = \"app\"\nkind = \"GoTo\"\n" + task;
}

Intervention set_goal(int robot, Vector2 point) { return {"goal", robot, "", {{"x_m", point.x}, {"y_m", point.y}}}; }
Intervention put_mover(const std::string& mover, Vector2 point) {
  return {"obstacle", 0, mover, {{"x_m", point.x}, {"y_m", point.y}}};
}

std::string refusal(Trial& trial, const Intervention& intervention) {
  const auto done = trial.application->intervene(intervention);
  return done ? "" : std::string(name_of(done.error().code)) + ": " + done.error().what.en;
}

void expect_in(const std::string& text, std::string_view part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(Intervention, SetsAGoalThatTheNextFrameTells) {
  Trial trial(kFlat, stepper_with("cells = [2, 0, 0, 1]\n"), at(0.25, 0.25));
  trial.go({1, 0}, 1);
  const auto set = trial.application->intervene(set_goal(0, {0.6, 1.9}));
  ASSERT_TRUE(set) << set.error().what.en;
  EXPECT_EQ(set->argument("x_m"), 0.75);
  EXPECT_EQ(set->argument("y_m"), 1.75);
  EXPECT_TRUE(set->reachable);
  trial.application->sense(trial.senses);
  EXPECT_EQ(trial.value("app.goal"), 1);
  EXPECT_NEAR(trial.value("app.direction"), kPi / 2, 1e-9);  // from (0.75, 0.25)
  trial.go({1, kPi / 2}, 1, 3);
  EXPECT_EQ(trial.value("app.goal"), 0) << "the task goes on with the goal that was left";
  const auto records = goals(trial).records();
  ASSERT_EQ(records.size(), 3u);
  EXPECT_EQ(records[0].outcome, GoalOutcome::Replaced);
  EXPECT_EQ(records[0].ticks, 1u);
  EXPECT_NEAR(records[0].travelled_m, 0.5, 1e-9);
  EXPECT_EQ(records[1].tick, 1u);
  EXPECT_EQ(records[1].goal, (CellGrid::Cell{1, 3}));
  EXPECT_EQ(records[1].outcome, GoalOutcome::Reached);
  EXPECT_EQ(records[1].ticks, 3u);
  EXPECT_NEAR(records[1].shortest_m, 1.5, 1e-9);
  EXPECT_EQ(records[2].goal, (CellGrid::Cell{0, 1}));
}

TEST(Intervention, SetsAGoalBeforeTheFirstTick) {
  Trial trial(kFlat, stepper_with("cells = [1, 0]\n"), at(0.25, 0.25));
  ASSERT_TRUE(trial.application->intervene(set_goal(0, {0.25, 0.75})));
  trial.application->sense(trial.senses);
  EXPECT_EQ(trial.value("app.goal"), 0);
  trial.go({1, kPi / 2}, 1);
  EXPECT_TRUE(goals(trial).done()) << "its own goal is replaced, not put off";
  const auto records = goals(trial).records();
  EXPECT_EQ(records[0].outcome, GoalOutcome::Replaced);
  EXPECT_EQ(records[0].ticks, 0u);
  EXPECT_EQ(records[1].outcome, GoalOutcome::Reached);
}

TEST(Intervention, OpensATaskThatWasDone) {
  Trial trial(kFlat, stepper_with("cells = [1, 0]\n"), at(0.25, 0.25));
  trial.go({1, 0}, 1);
  ASSERT_TRUE(goals(trial).done());
  ASSERT_TRUE(trial.application->intervene(set_goal(0, {1.25, 0.25})));
  EXPECT_FALSE(goals(trial).done());
  trial.go({1, 0}, 1);
  EXPECT_TRUE(goals(trial).done());
  EXPECT_EQ(goals(trial).records()[0].outcome, GoalOutcome::Reached);
}

TEST(Intervention, SaysOfASealedGoalThatNoWayLeadsThere) {
  Trial trial(kFlat, stepper_with("cells = [2, 0]\n"), at(0.25, 0.25));
  const auto set = trial.application->intervene(set_goal(0, {3.4, 0.2}));
  ASSERT_TRUE(set) << set.error().what.en;
  EXPECT_FALSE(set->reachable);
  EXPECT_TRUE(std::isinf(goals(trial).records()[1].shortest_m));
}

TEST(Intervention, SetsAGoalAfterAWithdrawalThatConcernsItNot) {
  Trial trial(kFlat, stepper_with("cells = [2, 0, 0, 1]\n"), at(0.25, 0.25));
  trial.acts[0].origins[0] = CommandOrigin::Withdrawn;
  trial.acts[0].reasons[0] = static_cast<std::uint16_t>(ReasonCode::Unreachable);
  trial.go({0, 0}, 1);
  ASSERT_TRUE(trial.application->intervene(set_goal(0, {0.75, 1.75})));
  const auto records = goals(trial).records();
  EXPECT_EQ(records[0].outcome, GoalOutcome::Withdrawn);
  EXPECT_EQ(records[0].reason, ReasonCode::Unreachable);
  EXPECT_EQ(records[1].outcome, GoalOutcome::Replaced) << "the next, which the task had set itself";
  trial.acts[0].origins[0] = CommandOrigin::Commanded;
  trial.go({0, 0}, 1, 15);
  EXPECT_EQ(goals(trial).records()[2].outcome, GoalOutcome::Open);
}

TEST(Intervention, RefusesGoalsThatCannotBe) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Trial trial(kFlat, stepper_with("cells = [2, 0]\n"), at(0.25, 0.25));
  expect_in(refusal(trial, set_goal(1, {1, 1})), "NotFound: there is no robot 1");
  expect_in(refusal(trial, set_goal(-1, {1, 1})), "NotFound: there is no robot -1");
  expect_in(refusal(trial, set_goal(0, {kNan, 1})), "a goal needs x_m, a finite number");
  expect_in(refusal(trial, set_goal(0, {1, -1e300})), "lies outside of the world, from (0, 0) to (4, 2)");
  expect_in(refusal(trial, set_goal(0, {4, 2})), "cell (8, 4) at (4.25, 2.25) cannot be a goal");
  expect_in(refusal(trial, set_goal(0, {1.2, 0.1})), "cell (2, 0) at (1.25, 0.25) is the goal already");
  EXPECT_EQ(goals(trial).records().size(), 1u) << "what is refused is not done";
  const std::string walled = std::string(kFlat) + "[[box]]\nx_m = 1.8\ny_m = 1.75\nlength_m = 0.2\nwidth_m = 0.2\n";
  Trial other(walled, stepper_with("cells = [2, 0]\n"), at(0.25, 0.25));
  expect_in(refusal(other, set_goal(0, {1.6, 1.6})), "no room for the robot");
  Trial without(testing::kRoom, testing::kFast, at(5, 5));
  expect_in(refusal(without, set_goal(0, {1, 1})), "Unsupported: \"goal\" cannot be done to r");
}

TEST(Intervention, SetsAThousandGoalsAndNoMore) {
  Trial trial(kFlat, stepper_with("cells = [2, 0]\n"), at(0.25, 0.25));
  for (int n = 0; n < 1000; ++n) {
    ASSERT_EQ(refusal(trial, set_goal(0, {n % 2 == 0 ? 0.75 : 1.25, 1.75})), "");
  }
  expect_in(refusal(trial, set_goal(0, {0.75, 1.75})), "TooLarge: 1000 goals");
  trial.reset(1, 0);
  EXPECT_EQ(refusal(trial, set_goal(0, {0.75, 1.75})), "");
}

TEST(Intervention, PutsAnObstacleInTheWay) {
  Trial trial(kFlat, stepper_with("cells = [7, 3]\n"), at(0.25, 0.25));
  ASSERT_EQ(refusal(trial, put_mover("crate", {1.25, 0.25})), "");
  trial.go({1, 0}, 1, 3);
  EXPECT_NEAR(trial.truth().pose.position.x, 0.75, 1e-9) << "it stands in front of the crate";
  expect_in(refusal(trial, put_mover("crate", {0.75, 0.3})), "robot 0 is there");
  expect_in(refusal(trial, put_mover("crat", {2, 1})),
            "NotFound: the world has no mover \"crat\"; did you mean \"crate\"?");
  expect_in(trial.application->intervene(put_mover("crat", {2, 1})).error().what.es,
            "el mundo no tiene el obstáculo móvil \"crat\"; ¿quiso decir \"crate\"?");
  expect_in(refusal(trial, put_mover("crate", {std::numeric_limits<double>::infinity(), 1})), "finite");
  expect_in(refusal(trial, put_mover("crate", {3, 0.2})), "a wall or something solid is there");
}

TEST(Intervention, LeavesTheBitsOfRunsWithoutOneAlone) {
  const auto drive = [](bool put) {
    Trial trial(kFlat, stepper_with("goals = 5\n"), at(0.25, 0.25));
    if (put) {
      EXPECT_TRUE(trial.application->intervene(put_mover("crate", {3.3, 1.7})));
    }
    trial.reset(7, 0);
    trial.go({1, 0.4}, 1, 20);
    return trial.senses[0].values;
  };
  EXPECT_EQ(drive(false), drive(true)) << "a reset forgets it";
}

}  // namespace
}  // namespace ganglion::sim
