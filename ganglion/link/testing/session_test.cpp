#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <tuple>

#include "ganglion/link/testing/bench.h"
#include "ganglion/module/testing/allocations.h"

// Both ends of the link against each other, in memory and in a time of their own.
namespace ganglion::link {
namespace {

constexpr int kTicks = 200;
using Way = MemoryLine::Way;
using CutBy = MemoryLine::CutBy;

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

RemoteConfig configured(Encoding encoding) {
  RemoteConfig config;
  config.end.encoding = encoding;
  return config;
}

TEST(LinkSession, GivesTheBitsOfARunWithoutALink) {
  for (const int robots : {1, 3}) {
    NotebookRobot alone(robots);
    const std::vector<double> expected = drive(alone, kTicks);
    for (const Carrier carrier : {Carrier::Stream, Carrier::Packets}) {
      for (const Encoding encoding : {Encoding::Binary, Encoding::Json}) {
        Bench bench(carrier, robots);
        const auto remote = bench.connect(configured(encoding));
        ASSERT_NE(remote, nullptr) << bench.error;
        EXPECT_TRUE(same_bits(drive(*remote, kTicks), expected));
        EXPECT_EQ(bench.robot.done(), alone.done());
      }
    }
  }
}

/// One session with one cut: the robot did every tick once, as without the cut.
void check_cut(MemoryLine::Cut cut, const std::vector<double>& expected, const std::vector<NotebookRobot::Done>& done) {
  Bench bench;
  bench.line->cut(cut);
  const auto remote = bench.connect();
  ASSERT_NE(remote, nullptr) << bench.error;
  const std::vector<double> sensed = drive(*remote, kTicks);
  ASSERT_EQ(remote->failure(), nullptr) << remote->failure()->what.en;
  ASSERT_TRUE(same_bits(sensed, expected));
  ASSERT_EQ(bench.robot.done(), done);
  ASSERT_GE(bench.line->connections(), 2);  // more while the place is held for the first one
}

TEST(LinkSession, TakesNoMemoryOnceWarm) {
  NotebookRobot robot(10);
  RobotEnd end(robot, robot_config());
  ControllerEnd controller({});
  const auto peer = end.open(Carrier::Stream, "", 0);
  std::string answer;
  const auto exchange = [&] {
    end.receive(peer, controller.outgoing(), 0);
    controller.outgoing().clear();
    end.take_stirred();
    answer.assign(end.outgoing(peer));
    end.sent(peer, answer.size(), 0);
    controller.receive(answer, 0);
  };
  controller.greet(0);
  controller.connected(0);
  exchange();
  ASSERT_TRUE(controller.done());
  std::vector<SenseFrame> sense(10, make_sense_frame(robot.description()));
  std::vector<ActFrame> act(10, make_act_frame(robot.description()));
  std::uint64_t before = 0;
  for (int tick = 0; tick < 110; ++tick) {
    if (tick == 70) before = ganglion::testing::allocations();  // the robot's notebook has room for 128
    ASSERT_TRUE(read_senses(controller.sense(), sense));
    for (ActFrame& frame : act) std::fill(frame.values.begin(), frame.values.end(), 0.01 * tick);
    controller.act(act, 0.1, 0);
    exchange();
    ASSERT_TRUE(controller.done());
  }
  EXPECT_EQ(ganglion::testing::allocations(), before);
  EXPECT_EQ(robot.done().size(), 110u);
}

class CutLink : public ::testing::TestWithParam<std::tuple<Way, CutBy>> {};

TEST_P(CutLink, LosesAndRepeatsNoTickWhateverByteOfTwoHundredTicksIsTheLast) {
  const auto [way, by] = GetParam();
  NotebookRobot alone;
  const std::vector<double> expected = drive(alone, kTicks);
  Bench whole;
  const auto remote = whole.connect();
  drive(*remote, kTicks);
  for (std::size_t at = 0; at < whole.line->carried(way); ++at) {
    check_cut({way, at, by}, expected, alone.done());
    if (HasFatalFailure()) FAIL() << "cut at byte " << at;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryWay, CutLink,
                         ::testing::Combine(::testing::Values(Way::ToRobot, Way::ToController),
                                            ::testing::Values(CutBy::Fin, CutBy::Rst, CutBy::Silence)));

TEST(LinkSession, LivesOnALineThatSpoilsBytes) {
  NotebookRobot alone;
  const std::vector<double> expected = drive(alone, kTicks);
  Bench bench(Carrier::Packets);
  bench.line->spoil_every(977);
  const auto remote = bench.connect();
  ASSERT_NE(remote, nullptr) << bench.error;
  EXPECT_TRUE(same_bits(drive(*remote, kTicks), expected));
  EXPECT_EQ(bench.robot.done(), alone.done());
  EXPECT_GT(remote->statistics().repeated, 10u);
  EXPECT_GT(remote->statistics().lost, 5u);
}

TEST(LinkSession, GivesUpInWordsWhenTheRobotIsUnplugged) {
  Bench bench;
  const auto remote = bench.connect();
  ASSERT_NE(remote, nullptr);
  drive(*remote, 10);
  bench.line->unplug();
  bench.line->cut({Way::ToRobot, bench.line->carried(Way::ToRobot), CutBy::Rst});
  std::vector<SenseFrame> sense = {make_sense_frame(remote->description())};
  const std::vector<ActFrame> act = {make_act_frame(remote->description())};
  const double before_s = bench.line->now_s();
  remote->step(act, 0.1);
  ASSERT_NE(remote->failure(), nullptr);
  EXPECT_EQ(remote->failure()->code, ErrorCode::LinkLost);
  EXPECT_NE(remote->failure()->what.en.find("no answer for 15 s"), std::string::npos) << remote->failure()->what.en;
  EXPECT_NEAR(bench.line->now_s() - before_s, 15, 1);
  remote->sense(sense);  // goes on giving what came last
  EXPECT_EQ(sense[0].tick, 10u);
}

TEST(LinkSession, KeepsAsManyRobotsAsTheExperimentHas) {
  Bench bench(Carrier::Stream, 2);
  const auto remote = RemoteApplication::connect(std::move(bench.own), bench.robot.description(), 3, {});
  ASSERT_FALSE(remote);
  EXPECT_NE(remote.error().what.en.find("there are 2 robots, the experiment has 3"), std::string::npos)
      << remote.error().what.en;
}

TEST(LinkSession, SaysWhereTheRobotIsNotTheOneOfTheFile) {
  Bench bench;
  Description file = bench.robot.description();
  file.sensations[1].unit = "cm";
  file.commands[0].name = "drive_";
  const auto remote = RemoteApplication::connect(std::move(bench.own), file, 1, {});
  ASSERT_FALSE(remote);
  const std::string& message = remote.error().what.en;
  EXPECT_NE(message.find("sonar.range: unit: the robot has \"m\", the file \"cm\""), std::string::npos) << message;
  EXPECT_NE(message.find("drive_: the robot has no such command; did you mean \"drive\"?"), std::string::npos)
      << message;
}

TEST(LinkSession, MapsChannelsByName) {
  Bench bench;
  Description file = bench.robot.description();
  std::swap(file.sensations[0], file.sensations[1]);
  const auto remote = RemoteApplication::connect(std::move(bench.own), file, 1, {});
  ASSERT_TRUE(remote) << remote.error().what.en;
  ASSERT_TRUE((*remote)->reset(1, 0));
  std::vector<SenseFrame> sense = {make_sense_frame(file)};
  std::vector<ActFrame> act = {make_act_frame(file)};
  act[0].values = {0.5, -0.5};
  (*remote)->step(act, 0.1);
  (*remote)->sense(sense);
  EXPECT_EQ(sense[0].values, (std::vector<double>{INFINITY, 0.05, -0.05}));  // sonar first, at tick 1
  EXPECT_EQ(sense[0].ages_s, (std::vector<double>{0.1, 0}));
}

RemoteConfig free_running() {
  RemoteConfig config;
  config.end.pace = wire::FREE_RUNNING;
  return config;
}

/// Whether nothing was done under commands older than half a second.
void watch_for_stale_commands(Bench& bench, bool& stale) {
  bench.robot.stepping = [&bench, &stale](const ActFrame& act) {
    const bool safe = act.values == std::vector<double>{0, 0};
    if (!safe && bench.line->now_s() - bench.line->delivered_s() > 0.5) stale = true;
  };
}

TEST(LinkSession, FreeRunningFollowsTheClockOfTheRobot) {
  Bench bench;
  const auto remote = bench.connect(free_running());
  ASSERT_NE(remote, nullptr) << bench.error;
  drive(*remote, 50);
  EXPECT_EQ(remote->failure(), nullptr);
  EXPECT_NEAR(bench.line->now_s(), 5, 0.11);
  EXPECT_EQ(remote->statistics().lost, 0u);
  std::size_t commanded = 0;
  for (const auto& done : bench.robot.done()) commanded += done.origin == CommandOrigin::Commanded;
  EXPECT_GE(commanded, 48u);
}

class CutFreeLink : public ::testing::TestWithParam<std::tuple<Way, CutBy>> {};

TEST_P(CutFreeLink, LeavesTheRobotSafeWithinHalfASecond) {
  const auto [way, by] = GetParam();
  Bench whole;
  const auto remote = whole.connect(free_running());
  drive(*remote, 20);
  for (std::size_t at = 0; at < whole.line->carried(way); ++at) {
    Bench bench;
    bool stale = false;
    watch_for_stale_commands(bench, stale);
    bench.line->cut({way, at, by});
    const auto cut = bench.connect(free_running());
    ASSERT_NE(cut, nullptr) << bench.error;
    drive(*cut, 60);
    ASSERT_EQ(cut->failure(), nullptr) << cut->failure()->what.en << " at byte " << at;
    ASSERT_FALSE(stale) << "at byte " << at;
    ASSERT_GE(bench.line->connections(), 2);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryWay, CutFreeLink,
                         ::testing::Combine(::testing::Values(Way::ToRobot, Way::ToController),
                                            ::testing::Values(CutBy::Fin, CutBy::Rst, CutBy::Silence)));

TEST(LinkSession, FreeRunningRobotStopsByItselfWhenItHearsNothing) {
  Bench bench;
  const auto remote = bench.connect(free_running());
  drive(*remote, 20);
  const std::size_t before = bench.robot.done().size();
  bench.line->wait_until(bench.line->now_s() + 2);
  ASSERT_GT(bench.robot.done().size(), before + 10);
  for (std::size_t n = before + 4; n < bench.robot.done().size(); ++n) {  // 0.3 s to live
    EXPECT_EQ(bench.robot.done()[n].left, 0) << n;
    EXPECT_EQ(bench.robot.done()[n].origin, CommandOrigin::Safe) << n;
  }
}

/// Whether somebody else may not command that robot now.
bool busy(Bench& bench) {
  const auto peer = bench.end.open(Carrier::Stream, "somebody", bench.line->now_s());
  bench.end.receive(peer, "{\"hello\":{\"major\":1,\"pace\":\"FREE_RUNNING\"}}\n", bench.line->now_s());
  const std::string answer(bench.end.outgoing(peer));
  bench.end.lost(peer, bench.line->now_s());
  return answer.find("\"code\":\"BUSY\"") != std::string::npos;
}

TEST(LinkSession, KeepsItsPlaceWhileItsRunIsHeldBack) {
  for (const RemoteConfig& config : {RemoteConfig{}, free_running()}) {
    Bench bench;
    const auto remote = bench.connect(config);
    drive(*remote, 20);
    for (int n = 0; n < 120; ++n) {
      bench.line->wait_until(bench.line->now_s() + 0.5);
      remote->stay_in_touch();
    }
    EXPECT_TRUE(busy(bench)) << "after a minute in touch";
    EXPECT_FALSE(drive(*remote, 20).empty());
    EXPECT_EQ(remote->failure(), nullptr);
    EXPECT_EQ(bench.line->connections(), 1);
    bench.line->wait_until(bench.line->now_s() + 10.5);
    EXPECT_FALSE(busy(bench)) << "after ten seconds of silence";
  }
}

}  // namespace
}  // namespace ganglion::link
