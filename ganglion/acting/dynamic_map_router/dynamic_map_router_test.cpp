// What AmDmr does step by step, in numbers worked by hand; and on every kind of bad input.
#include <gtest/gtest.h>

#include <limits>

#include "ganglion/acting/dynamic_map_router/testing/grid_bot.h"
#include "ganglion/module/testing/allocations.h"

namespace ganglion {
namespace {

using grid::Label;
using grid::Nature;
using testing::Drive;
using testing::GridBot;
using testing::open_ground;
using testing::RequestBench;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

TEST(DynamicMapRouter, CommandsMotionAndDirectionOfTravel) {
  GridBot bot = open_ground();
  Drive drive(bot);
  drive.bench().ask({8, 5});
  const Command ahead = drive.tick();
  ASSERT_EQ(ahead.kind, CommandKind::Act);
  ASSERT_EQ(ahead.size, 2);
  EXPECT_EQ(ahead.values[0], 1);
  EXPECT_EQ(ahead.values[1], 0);
  drive.bench().ask({5, 5});  // now one cell behind: backing is shorter than turning
  const Command behind = drive.tick();
  EXPECT_EQ(behind.values[0], -1);
  EXPECT_NEAR(behind.values[1], kPi, 1e-12);
}

TEST(DynamicMapRouter, ShowsItsWholePlanAndSendsTheFirstOfIt) {
  GridBot bot = open_ground();
  Drive drive(bot);
  drive.bench().ask({9, 5});
  const Command first = drive.tick();
  ASSERT_EQ(drive.module().plan().size(), 4u);
  EXPECT_EQ(drive.module().plan()[0].values, first.values);
  EXPECT_EQ(drive.output("route_length"), 4 * 0.5);
  drive.tick();
  EXPECT_EQ(drive.module().plan().size(), 3u);
}

TEST(DynamicMapRouter, MarksWhatItBumpsIntoAndKeepsAwayWhileInhibited) {
  GridBot bot = open_ground();
  bot.blocks.insert({6, 5});
  Drive drive(bot);
  drive.bench().ask({8, 5});
  drive.tick();
  drive.tick();  // cycle 2 learns of the failure: closed for 2 + floor(18 * 0.2) = 5 cycles, 2 to 6
  EXPECT_EQ(drive.cell(6, 5).label, Label::Occupied);
  EXPECT_EQ(drive.cell(6, 5).nature, Nature::Static);
  EXPECT_EQ(drive.cell(6, 5).risk, 0.2);
  EXPECT_EQ(drive.cell(6, 5).inhibited_until, 7u);
  EXPECT_EQ(drive.output("occupied"), 1);
  EXPECT_EQ(drive.output("failures"), 1);
}

TEST(DynamicMapRouter, CallsACellDynamicThatItCrossedBefore) {
  GridBot bot = open_ground();
  Drive drive(bot);
  ASSERT_EQ(drive.go(8, 5), RequestStatus::Satisfied);
  EXPECT_EQ(drive.cell(7, 5).label, Label::Empty);
  EXPECT_EQ(drive.cell(7, 5).risk, 0);
  bot.column = 5;
  drive.tick();
  bot.blocks.insert({7, 5});
  ASSERT_EQ(drive.go(8, 5), RequestStatus::Satisfied);
  EXPECT_EQ(drive.cell(7, 5).label, Label::Occupied);
  EXPECT_EQ(drive.cell(7, 5).nature, Nature::Dynamic);
  EXPECT_EQ(drive.cell(7, 5).risk, 0.2);
}

TEST(DynamicMapRouter, TriesABlockedCellAgainOnceItsInhibitionLapses) {
  // The only way leads through one cell, shut at first: static 0.2, crossed later, 0.2 * 0.3 = 0.06.
  GridBot bot({"#########", "#.......#", "#########"});
  bot.column = 1, bot.row = 1;
  bot.blocks.insert({4, 1});
  Drive drive(bot);
  drive.before_tick = [&] {
    if (drive.output("failures") >= 1) bot.blocks.clear();
  };
  ASSERT_EQ(drive.go(7, 1), RequestStatus::Satisfied);
  EXPECT_EQ(drive.cell(4, 1).label, Label::Empty);
  EXPECT_EQ(drive.cell(4, 1).nature, Nature::Dynamic);
  EXPECT_NEAR(drive.cell(4, 1).risk, 0.06, 1e-12);
}

TEST(DynamicMapRouter, FailsAStepThatDidNotArriveEvenWithoutContact) {
  GridBot bot = open_ground();
  Drive drive(bot);
  drive.bench().ask({8, 5});
  drive.tick();
  bot.column = 5;  // the wheels slipped
  bot.contact = false;
  drive.tick();
  EXPECT_EQ(drive.cell(6, 5).label, Label::Occupied);
}

TEST(DynamicMapRouter, BooksCostsOnTheCellsThatWereCrossed) {
  GridBot bot = open_ground();
  bot.dearness = [](int column, int) { return column == 7 ? 3.0 : 1.0; };
  Drive drive(bot);
  ASSERT_EQ(drive.go(8, 5), RequestStatus::Satisfied);
  EXPECT_EQ(drive.cell(6, 5).cost_j, 2);
  EXPECT_EQ(drive.cell(7, 5).cost_j, 6);
  EXPECT_EQ(drive.cell(8, 5).cost_j, 2);  // the last step counts as well
}

TEST(DynamicMapRouter, AvoidsGroundThatProvedDear) {
  GridBot bot({"#########", "#.......#", "#.......#", "#.......#", "#########"});
  bot.dearness = [](int column, int row) { return row == 2 && column >= 3 && column <= 5 ? 20.0 : 1.0; };
  bot.column = 1, bot.row = 2;
  Drive drive(bot);
  const auto trip = [&] {
    bot.column = 1, bot.heading = 0;
    bot.row = 2;
    drive.tick();
    EXPECT_EQ(drive.go(7, 2), RequestStatus::Satisfied);
  };
  double dear = 0;
  for (int i = 0; i < 6; ++i) trip();
  drive.before_tick = [&] { dear += bot.row == 2 && bot.column >= 3 && bot.column <= 5; };
  trip();
  EXPECT_EQ(dear, 0);
}

TEST(DynamicMapRouter, MapsAlsoWithARobotThatReportsNoCost) {
  GridBot bot({"#######", "#..#..#", "#.....#", "#######"});
  bot.column = 1, bot.row = 2;
  auto module = std::make_unique<DynamicMapRouter>(Drive::small());
  RequestBench bench(*module, dynamic_map_router_kind.descriptor, {"cell", "heading"});
  bench.ask({3, 2});
  for (int i = 0; i < 10; ++i) {
    bench.ports().set("cell", {static_cast<double>(bot.column), static_cast<double>(bot.row)});
    bench.ports().set("heading", {wrap_rad(bot.heading * kPi / 4)});
    bot.act(bench.tick(std::nullopt));
  }
  EXPECT_EQ(module->map().find({3, 2})->label, Label::Occupied);
}

TEST(DynamicMapRouter, WithdrawsFromASealedGoalAfterThreeRounds) {
  GridBot bot({"#######", "#...#.#", "#...###", "#.....#", "#######"});
  bot.column = 1, bot.row = 1;
  Drive drive(bot);
  ASSERT_EQ(drive.go(5, 3), RequestStatus::Withdrawn);
  EXPECT_EQ(drive.reason(), ReasonCode::Unreachable);
  EXPECT_EQ(drive.bench().request().reason.first, drive.output("failures"));
  EXPECT_EQ(drive.bench().request().reason.second, 3);
  EXPECT_EQ(drive.tick().kind, CommandKind::Withdraw);  // waits for help
  EXPECT_EQ(drive.output("phase"), 0);
  ASSERT_EQ(drive.go(3, 1), RequestStatus::Satisfied);  // a new request wakes it
}

TEST(DynamicMapRouter, StartsItsRoundsAnewOnceItHasGotFurther) {
  // Two gates in a passage, each opened only in the last round of trying it.
  GridBot bot({"###########", "#.........#", "###########"});
  bot.column = 1, bot.row = 1;
  bot.blocks = {{4, 1}, {7, 1}};
  Drive drive(bot);
  drive.before_tick = [&] {
    if (drive.output("rounds") == 2) bot.blocks.erase({bot.column < 4 ? 4 : 7, 1});
  };
  EXPECT_EQ(drive.go(9, 1), RequestStatus::Satisfied);
}

TEST(DynamicMapRouter, SaysThatItIsTrappedWhenEveryStepIsBlocked) {
  GridBot bot({"###", "#.#", "###"});
  bot.column = 1, bot.row = 1;
  Drive drive(bot);
  ASSERT_EQ(drive.go(9, 9), RequestStatus::Withdrawn);
  EXPECT_EQ(drive.reason(), ReasonCode::Trapped);
  EXPECT_EQ(drive.bench().request().reason.first, 1);
  EXPECT_EQ(drive.bench().request().reason.second, 1);
}

TEST(DynamicMapRouter, RefusesRequestsThatAreNoCells) {
  for (const double value : {kNan, kInf, 2.5, 1e300}) {
    GridBot bot = open_ground();
    Drive drive(bot);
    drive.bench().ask({value, 3});
    EXPECT_EQ(drive.tick().kind, CommandKind::Withdraw);
    EXPECT_EQ(drive.reason(), ReasonCode::BadRequest);
    EXPECT_EQ(drive.bench().request().reason.second, 3);
  }
}

TEST(DynamicMapRouter, SaysThatAGoalLiesOutsideItsMap) {
  GridBot bot = open_ground();
  Drive drive(bot);
  ASSERT_EQ(drive.go(1000, 5), RequestStatus::Withdrawn);
  EXPECT_EQ(drive.reason(), ReasonCode::OutsideMap);
  EXPECT_EQ(drive.bench().request().reason.first, 1000);
}

TEST(DynamicMapRouter, StaysInsideAFullMap) {
  GridBot bot = open_ground(60, 5, 80);
  DynamicMapRouterConfig config = Drive::small();
  config.max_tiles = 1;
  Drive drive(bot, config);
  ASSERT_EQ(drive.go(63, 5), RequestStatus::Satisfied);
  ASSERT_EQ(drive.go(64, 5), RequestStatus::Withdrawn);
  EXPECT_EQ(drive.reason(), ReasonCode::OutsideMap);
}

/// A frame in which cell and heading are as given.
const Command& frame(RequestBench& bench, double column, double row, double heading_rad) {
  bench.ports().set("cell", {column, row});
  bench.ports().set("heading", {heading_rad});
  return bench.tick(1.0);
}

TEST(DynamicMapRouter, HoldsWhileTheCellIsUnknownAndGivesUpAfterItsPatience) {
  for (const double lost : {kNan, kInf, -kInf}) {
    auto module = std::make_unique<DynamicMapRouter>(Drive::small());
    RequestBench bench(*module, dynamic_map_router_kind.descriptor, {"cell", "heading"}, 1.0);
    bench.ask({8, 5});
    EXPECT_EQ(frame(bench, 5, 5, 0).kind, CommandKind::Act);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(frame(bench, lost, 5, 0).kind, CommandKind::Inactive) << i;
    EXPECT_EQ(frame(bench, lost, 5, 0).kind, CommandKind::Withdraw);
    EXPECT_EQ(bench.request().reason.code, ReasonCode::NoReading);
    EXPECT_EQ(bench.request().reason.first, DynamicMapRouter::kCell);
    EXPECT_EQ(bench.request().reason.second, 5);
  }
}

TEST(DynamicMapRouter, JudgesAStepOnceReadingsReturn) {
  auto module = std::make_unique<DynamicMapRouter>(Drive::small());
  RequestBench bench(*module, dynamic_map_router_kind.descriptor, {"cell", "heading"});
  bench.ask({8, 5});
  frame(bench, 5, 5, 0);
  frame(bench, kNan, kNan, kNan);
  EXPECT_EQ(frame(bench, 6, 5, kNan).kind, CommandKind::Act);  // the lost heading is that of the step
  EXPECT_EQ(module->map().find({6, 5})->label, Label::Empty);
  EXPECT_EQ(module->map().occupied(), 0);
}

TEST(DynamicMapRouter, ComesToTermsWithBeingCarriedElsewhere) {
  GridBot bot = open_ground(2, 2, 40);
  Drive drive(bot);
  drive.bench().ask({20, 2});
  drive.tick();
  bot.column = 30, bot.row = 30;
  drive.tick();
  EXPECT_EQ(drive.module().map().occupied(), 0);  // no obstacle did that
  ASSERT_EQ(drive.go(20, 2), RequestStatus::Satisfied);
}

TEST(DynamicMapRouter, LearnsNothingFromAStepThatAnotherModuleOverruled) {
  GridBot bot = open_ground();
  Drive drive(bot);
  drive.bench().ask({8, 5});
  drive.tick();
  bot.column = 5;
  drive.module().carried_out(0);
  drive.tick();
  EXPECT_EQ(drive.module().map().occupied(), 0);
}

/// The module above a slot that a test answers.
class Above {
 public:
  Above()
      : module(std::make_unique<DynamicMapRouter>(Drive::small())), bench(*module, dynamic_map_router_kind.descriptor) {
    bench.join_below(below);
    bench.ports().set("cell", {5, 5});
    bench.ports().set("heading", {0});
    bench.ask({8, 5});
    bench.tick(std::nullopt);
  }
  std::unique_ptr<DynamicMapRouter> module;
  RequestSlot below;
  RequestBench bench;
};

TEST(DynamicMapRouter, MarksTheCellWhenTheModuleBelowCannotDriveThere) {
  Above above;
  EXPECT_EQ(above.below.values[0], 1);
  above.below.withdraw({ReasonCode::AttemptsExhausted, 6, 3});
  above.bench.tick(1);
  EXPECT_EQ(above.module->map().find({6, 5})->label, Label::Occupied);
  EXPECT_EQ(above.below.status, RequestStatus::Pending);  // another step is under way
}

TEST(DynamicMapRouter, BlamesNoCellWhenTheModuleBelowIsBlindOrPreempted) {
  Above blind;
  blind.below.withdraw({ReasonCode::NoReading, 2, 5});
  blind.bench.tick(1);
  EXPECT_EQ(blind.module->map().occupied(), 0);
  EXPECT_EQ(blind.bench.request().reason.code, ReasonCode::NoReading);
  Above preempted;
  preempted.below.withdraw({ReasonCode::Preempted, 0, 1});
  preempted.bench.tick(1);
  EXPECT_EQ(preempted.module->map().occupied(), 0);
  EXPECT_EQ(preempted.bench.request().status, RequestStatus::Pending);
}

TEST(DynamicMapRouter, ExpectsTheCellOfItsStep) {
  GridBot bot = open_ground();
  Drive drive(bot);
  drive.bench().ask({8, 5});
  drive.tick();
  EXPECT_EQ(drive.bench().ports().appraisal()[0], 6);
  EXPECT_EQ(drive.bench().ports().appraisal()[1], 5);
}

TEST(DynamicMapRouter, AllocatesNothingInATick) {
  GridBot bot({"....#.....", "....#.....", "....#.....", "..........", "....#.....", "....#....."});
  Drive drive(bot);
  ASSERT_EQ(drive.go(0, 1), RequestStatus::Satisfied);  // tiles are taken between ticks
  const std::uint64_t before = testing::allocations();
  drive.bench().ask({9, 5});
  for (int i = 0; i < 200 && drive.bench().request().status == RequestStatus::Pending; ++i) drive.tick();
  EXPECT_EQ(testing::allocations(), before);
  EXPECT_EQ(drive.bench().request().status, RequestStatus::Satisfied);
  EXPECT_GT(bot.bumps, 0);
}

TEST(DynamicMapRouter, IsMadeFromItsParametersAndTurnsByEighthsOfATurn) {
  const Descriptor& descriptor = dynamic_map_router_kind.descriptor;
  EXPECT_TRUE(dynamic_map_router_kind.make(Parameters(descriptor.parameters)));
  const auto turns = descriptor.parameter("max_turn_deg")->allowed;
  EXPECT_EQ(std::vector<double>(turns.begin(), turns.end()), (std::vector<double>{45, 90, 180}));
  for (const double turn_deg : turns) {
    Parameters parameters(descriptor.parameters);
    parameters.set("max_turn_deg", turn_deg);
    auto config = parameters.filled<DynamicMapRouterConfig>();
    EXPECT_TRUE(DynamicMapRouter::judge(config));
    EXPECT_EQ(config.router.max_turn, turn_deg / 45);
  }
}

TEST(DynamicMapRouter, WeighsCostInSecureRoutesUnlessToldToGoByLength) {
  for (const auto secure_by : {SecureBy::Cost, SecureBy::Length}) {
    Parameters parameters(dynamic_map_router_kind.descriptor.parameters);
    parameters.set("secure_by", static_cast<double>(secure_by));
    auto config = parameters.filled<DynamicMapRouterConfig>();
    EXPECT_TRUE(DynamicMapRouter::judge(config));
    EXPECT_EQ(config.price.secure_weighs_cost, secure_by == SecureBy::Cost);
  }
}

TEST(DynamicMapRouter, DescribesItselfInBothLanguages) {
  for (const PortDescriptor& port : dynamic_map_router_kind.descriptor.ports) {
    EXPECT_FALSE(port.help.empty()) << port.name;
  }
  for (const ParameterDescriptor& parameter : dynamic_map_router_kind.descriptor.parameters) {
    EXPECT_FALSE(parameter.help.empty()) << parameter.name;
  }
}

}  // namespace
}  // namespace ganglion
