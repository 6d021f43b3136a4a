#include <gtest/gtest.h>

#include <cstring>
#include <tuple>

#include "ganglion/link/controller/remote_application.h"
#include "ganglion/link/testing/memory_line.h"
#include "ganglion/link/testing/notebook_robot.h"

// Both ends of the link against each other, in memory and in a time of their own.
namespace ganglion::link {
namespace {

constexpr int kTicks = 200;
using Way = MemoryLine::Way;
using CutBy = MemoryLine::CutBy;

RobotEndConfig robot_config() {
  RobotEndConfig config;
  config.token = [n = 0]() mutable { return fmt::format("token{}", n++); };
  return config;
}

/// A robot, its end, and a line to it.
struct Bench {
  explicit Bench(Carrier carrier = Carrier::Stream, int robots = 1)
      : robot(robots), end(robot, nullptr, robot_config()) {
    EXPECT_TRUE(robot.reset(1, 0));
    auto made = std::make_unique<MemoryLine>(end, carrier);
    line = made.get();
    own = std::move(made);
  }
  /// None, and the error kept, where it cannot be.
  std::unique_ptr<RemoteApplication> connect(const RemoteConfig& config = {}) {
    auto made = RemoteApplication::connect(std::move(own), robot.description(), robot.robots(), config);
    if (!made) error = made.error().message;
    return made ? std::move(*made) : nullptr;
  }
  NotebookRobot robot;
  RobotEnd end;
  std::unique_ptr<MemoryLine> own;
  MemoryLine* line = nullptr;
  std::string error;
};

/// Drives it for so many ticks. Returns what was sensed.
std::vector<double> drive(Application& application, int ticks) {
  EXPECT_TRUE(application.reset(7, 0));
  std::vector<SenseFrame> sense(static_cast<std::size_t>(application.robots()),
                                make_sense_frame(application.description()));
  std::vector<ActFrame> act(sense.size(), make_act_frame(application.description()));
  std::vector<double> sensed;
  for (int tick = 0; tick < ticks && application.failure() == nullptr; ++tick) {
    application.sense(sense);
    for (std::size_t n = 0; n < sense.size(); ++n) {
      make_canonical(sense[n]);
      decide(sense[n], act[n]);
      sensed.insert(sensed.end(), sense[n].values.begin(), sense[n].values.end());
      sensed.insert(sensed.end(), sense[n].ages_s.begin(), sense[n].ages_s.end());
      sensed.push_back(sense[n].cost.value_or(-1));
      sensed.push_back(sense[n].time_s);
    }
    application.step(act, 0.1);
  }
  return sensed;
}

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
  ASSERT_EQ(remote->failure(), nullptr) << remote->failure()->message;
  ASSERT_TRUE(same_bits(sensed, expected));
  ASSERT_EQ(bench.robot.done(), done);
  ASSERT_GE(bench.line->connections(), 2);  // more while the place is held for the first one
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

}  // namespace
}  // namespace ganglion::link
