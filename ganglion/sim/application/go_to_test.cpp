// The task at work: a stepping robot that the test itself steers.
#include <cmath>

#include "ganglion/sim/simulation/testing/trial.h"

namespace ganglion::sim {
namespace {

const GoalLedger& goals(const testing::Trial& trial) {
  return static_cast<const GoalLedger&>(*trial.application->witness()->ledger(0, "app"));
}

using testing::at;
using testing::Trial;

/// 8 x 4 cells of 0.5 m; a closed closet of the two cells {6, 0} and {7, 0}.
constexpr std::string_view kFlat =
    "format = 1\nname = \"flat\"\n[[wall]]\npoints = [[0, 0], [4, 0], [4, 2], [0, 2]]\nclosed = true\n"
    "[[wall]]\npoints = [[3, 0], [3, 0.5], [4, 0.5]]\n";

std::string stepper_with(const std::string& task) {
  return "[drive]\nkind = \"Stepper\"\nmax_turn_deg = 180\n[[task]]\nid = \"app\"\nkind = \"GoTo\"\n" + task;
}

void expect_cell(CellGrid::Cell cell, int column, int row) {
  EXPECT_EQ(cell.column, column);
  EXPECT_EQ(cell.row, row);
}

TEST(GoTo, SetsTheNextGoalOnceTheRobotStandsInTheLast) {
  Trial trial(kFlat, stepper_with("cells = [2, 0, 0, 1]\n"), at(0.25, 0.25));
  EXPECT_EQ(trial.value("app.goal"), 2);
  EXPECT_EQ(trial.value("app.direction"), 0);
  trial.go({1, 0}, 1);
  EXPECT_EQ(trial.value("app.goal"), 2);
  trial.go({1, 0}, 1);
  EXPECT_EQ(trial.value("app.goal"), 0);
  EXPECT_NEAR(trial.value("app.direction"), std::atan2(0.5, -1.0), 1e-9);  // from (1.25, 0.25) to (0.25, 0.75)
  EXPECT_FALSE(goals(trial).done());
  trial.go({1, Angle::from_deg(135).rad()}, 1);
  trial.go({1, kPi}, 1);
  EXPECT_TRUE(goals(trial).done());
  trial.go({0, 0}, 1, 3);
  EXPECT_EQ(trial.value("app.goal"), 0);  // keeps its value

  const auto records = goals(trial).records();
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].tick, 0u);
  expect_cell(records[0].start, 0, 0);
  expect_cell(records[0].goal, 2, 0);
  EXPECT_EQ(records[0].outcome, GoalOutcome::Reached);
  EXPECT_EQ(records[0].ticks, 2u);
  EXPECT_NEAR(records[0].shortest_m, 1, 1e-9);
  EXPECT_NEAR(records[0].travelled_m, 1, 1e-9);
  EXPECT_EQ(records[1].tick, 2u);
  EXPECT_EQ(records[1].ticks, 2u);
  EXPECT_NEAR(records[1].static_shortest_m, 0.5 * (1 + std::sqrt(2.0)), 1e-9);
  EXPECT_NEAR(records[1].travelled_m, 0.5 * (1 + std::sqrt(2.0)), 1e-9);
}

TEST(GoTo, GoesOnWhenTheControllerWithdraws) {
  Trial trial(kFlat, stepper_with("cells = [6, 0, 1, 0]\n"), at(0.25, 0.25));
  trial.go({0, 0}, 1, 2);
  trial.acts[0].origins[0] = CommandOrigin::Withdrawn;
  trial.acts[0].reasons[0] = static_cast<std::uint16_t>(ReasonCode::Unreachable);
  trial.go({0, 0}, 1);
  EXPECT_EQ(trial.value("app.goal"), 1);
  trial.acts[0].origins[0] = CommandOrigin::Commanded;
  trial.acts[0].reasons[0] = 0;
  trial.go({0, 0}, 1);
  const auto records = goals(trial).records();
  ASSERT_EQ(records.size(), 2u);
  EXPECT_FALSE(records[0].reachable);
  EXPECT_EQ(records[0].shortest_m, std::numeric_limits<double>::infinity());
  EXPECT_EQ(records[0].outcome, GoalOutcome::Withdrawn);
  EXPECT_EQ(records[0].reason, ReasonCode::Unreachable);
  EXPECT_EQ(records[0].ticks, 3u);
  EXPECT_TRUE(records[1].reachable);
  EXPECT_EQ(records[1].outcome, GoalOutcome::Open);
}

TEST(GoTo, LosesItsPatience) {
  Trial trial(kFlat, stepper_with("cells = [5, 0, 1, 0]\npatience_s = 4\n"), at(0.25, 0.25));
  trial.go({0, 0}, 1, 3);
  EXPECT_EQ(trial.value("app.goal"), 5);
  trial.go({0, 0}, 1);
  EXPECT_EQ(trial.value("app.goal"), 1);
  EXPECT_EQ(goals(trial).records()[0].outcome, GoalOutcome::TimedOut);
}

TEST(GoTo, DrawsReachableAndSealedGoalsInTheSharesAskedFor) {
  Trial trial(kFlat, stepper_with("goals = 50\nsealed_share = 0.2\npatience_s = 1\n"), at(0.25, 0.25));
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    trial.reset(seed, 0);
    trial.go({0, 0}, 1, 60);
    ASSERT_TRUE(goals(trial).done());
    const auto records = goals(trial).records();
    ASSERT_EQ(records.size(), 50u);
    int sealed = 0;
    for (std::size_t n = 0; n < records.size(); ++n) {
      const bool closet = records[n].goal.column >= 6 && records[n].goal.row == 0;
      EXPECT_EQ(records[n].reachable, !closet);
      EXPECT_EQ(std::isinf(records[n].shortest_m), closet);
      sealed += closet ? 1 : 0;
      if (n > 0) {
        EXPECT_NE(records[n].goal, records[n - 1].goal);
      }
    }
    EXPECT_EQ(sealed, 10);
  }
}

TEST(GoTo, DrawsByTheSeed) {
  Trial one(kFlat, stepper_with(""), at(0.25, 0.25)), other(kFlat, stepper_with(""), at(0.25, 0.25));
  one.reset(3, 1);
  other.reset(3, 1);
  int different = 0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    one.reset(seed, 0);
    other.reset(seed, 0);
    EXPECT_EQ(one.value("app.goal"), other.value("app.goal"));
    other.reset(seed + 1, 0);
    different += one.senses[0].values == other.senses[0].values ? 0 : 1;
  }
  EXPECT_GT(different, 0);
}

TEST(GoTo, MeasuresTheShortestWayWithMoversAsTheyStand) {
  // The only door between two rooms is taken by a mover for the whole run.
  const std::string world =
      "format = 1\nname = \"w\"\n[[wall]]\npoints = [[0, 0], [3, 0], [3, 1], [0, 1]]\nclosed = true\n"
      "[[wall]]\npoints = [[1.5, 0.5], [1.5, 1]]\n"
      "[[mover]]\nid = \"door\"\nlength_m = 0.4\nwidth_m = 0.4\nplaces = [[1.75, 0.25]]\n";
  Trial trial(world, stepper_with("cells = [5, 0]\n"), at(0.25, 0.25));
  const GoalRecord record = goals(trial).records()[0];
  EXPECT_NEAR(record.static_shortest_m, 2.5, 1e-9);
  EXPECT_EQ(record.shortest_m, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(record.reachable);
}

TEST(GoTo, MeasuresTheShortestWayForARobotThatTurnsALittleAtATime) {
  // Heading east, the cell north takes a step north-east and one back west; heading north, the next is one step ahead.
  const std::string cells = "cells = [0, 2, 0, 3]\n";
  Trial trial(kFlat, stepper_with(cells + "max_turn_deg = 45\n"), at(0.25, 0.75));
  trial.go({1, kPi / 2}, 1);
  const auto records = goals(trial).records();
  ASSERT_EQ(records.size(), 2u);
  EXPECT_NEAR(records[0].static_shortest_m, 0.5, 1e-9);
  EXPECT_NEAR(records[0].steered_shortest_m, 0.5 * (1 + std::sqrt(2.0)), 1e-9);
  EXPECT_NEAR(records[1].static_shortest_m, 0.5, 1e-9);
  EXPECT_NEAR(records[1].steered_shortest_m, 0.5, 1e-9);
  Trial on_the_spot(kFlat, stepper_with(cells), at(0.25, 0.75));
  EXPECT_NEAR(goals(on_the_spot).records()[0].steered_shortest_m, 0.5, 1e-9);
}

TEST(GoTo, RefusesTurnsThatAreNoneOfItsThree) {
  Problems problems;
  const std::string robot = "format = 1\nname = \"r\"\n[body]\nlength_m = 0.2\nwidth_m = 0.2\nradius_m = 0.1\n";
  EXPECT_FALSE(parse_robot(robot + stepper_with("max_turn_deg = 60\n"), "robot.toml", testing::kKinds, problems));
  EXPECT_NE(problems.text().find("max_turn_deg is 60, must be one of 45, 90, 180"), std::string::npos)
      << problems.text();
}

TEST(GoTo, FailsWhereThereIsNothingToDraw) {
  Problems problems;
  const auto model = testing::robot_of(stepper_with("sealed_share = 0.5\n"));
  auto simulation = Simulation::make({testing::ground_of(testing::kRoom), model, 1, at(0.25, 0.25)});
  ASSERT_TRUE(simulation);
  const auto tasked = TaskedApplication::make(std::move(*simulation), model->tasked, model->tasks);
  ASSERT_TRUE(tasked);
  const auto ready = (*tasked)->reset(1, 0);
  ASSERT_FALSE(ready);
  EXPECT_NE(ready.error().what.en.find("free cells out of reach"), std::string::npos);
}

}  // namespace
}  // namespace ganglion::sim
