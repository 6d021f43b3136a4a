#include "ganglion/link/robot/robot_end.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ganglion/link/testing/bench.h"

namespace ganglion::link {
namespace {

/// A robot's end and people who type JSON at it.
class RobotEndTest : public ::testing::Test {
 protected:
  RobotEndTest() : end_(robot_, robot_config()) { EXPECT_TRUE(robot_.reset(1, 0)); }

  RobotEnd::PeerId open() { return end_.open(Carrier::Stream, "somebody", now_s_); }
  /// What comes back.
  std::string say(RobotEnd::PeerId peer, const std::string& bytes) {
    end_.receive(peer, bytes, now_s_);
    return hear(peer);
  }
  std::string hear(RobotEnd::PeerId peer) {
    std::string heard(end_.outgoing(peer));
    end_.sent(peer, heard.size(), now_s_);
    return heard;
  }
  RobotEnd::PeerId commander() {
    const auto peer = open();
    EXPECT_NE(say(peer, kHello).find("token"), std::string::npos);
    return peer;
  }
  void expect_refused(const std::string& bytes, const std::string& words, bool after_hello = true) {
    const auto peer = after_hello ? commander() : open();
    const std::string answer = say(peer, bytes);
    EXPECT_NE(answer.find(words), std::string::npos) << answer;
    EXPECT_TRUE(end_.closing(peer));
    end_.lost(peer, now_s_);
    now_s_ += 10;
  }

  const std::string kHello = "{\"hello\":{\"major\":1}}\n";
  NotebookRobot robot_;
  RobotEnd end_;
  double now_s_ = 0;
};

TEST_F(RobotEndTest, AnswersAsThePageSays) {
  const auto peer = open();
  EXPECT_EQ(say(peer, kHello),
            "{\"hello\":{\"major\":1,\"minor\":1,\"token\":\"token0\",\"name\":\"ganglion\"}}\n"
            "{\"describe\":{\"name\":\"Notebook\",\"robots\":1,\"tick_s\":0.1,\"length_m\":0.2,\"width_m\":0.1,"
            "\"sensations\":[{\"name\":\"ways.length\",\"unit\":\"m\",\"elements\":[\"left\",\"right\"],\"min\":-100,"
            "\"max\":100},{\"name\":\"sonar.range\",\"unit\":\"m\",\"min\":0,\"max\":3,\"period_s\":0.2}],"
            "\"commands\":[{\"name\":\"drive\",\"elements\":[{\"name\":\"left\",\"unit\":\"m/s\",\"min\":-1,\"max\":1},"
            "{\"name\":\"right\",\"unit\":\"m/s\",\"min\":-1,\"max\":1}]}],\"lock_step\":true,\"free_running\":true}}\n"
            "{\"sense\":{\"values\":[0,0,\"NaN\"],\"ages_s\":[0,0]}}\n");
  EXPECT_EQ(say(peer, "{\"act\":{\"tick\":0,\"values\":[0.5,-0.5]}}\n"),
            "{\"sense\":{\"tick\":1,\"time_s\":0.1,\"values\":[0.05,-0.05,\"Infinity\"],"
            "\"ages_s\":[0,0.1],\"cost_J\":[0.25]}}\n");
  EXPECT_EQ(robot_.done().back(), (NotebookRobot::Done{0, 0.5, -0.5, 0.3, CommandOrigin::Commanded}));
  say(peer, "{\"bye\":{}}\n");
  EXPECT_TRUE(end_.closing(peer));
}

TEST_F(RobotEndTest, NeverCarriesOutATickTwice) {
  const auto peer = commander();
  const std::string act = "{\"act\":{\"values\":[0.5,0.5]}}\n";
  const std::string first = say(peer, act);
  EXPECT_EQ(say(peer, act), first);
  EXPECT_EQ(robot_.done().size(), 1u);
}

TEST_F(RobotEndTest, KeepsCommandsWithinTheirLimits) {
  const auto peer = commander();
  say(peer, "{\"act\":{\"values\":[7,\"NaN\"]}}\n");
  EXPECT_EQ(robot_.done().back(), (NotebookRobot::Done{0, 1, 0, 0.3, CommandOrigin::Refused}));
  say(peer, "{\"act\":{\"tick\":1,\"ttl_ms\":40,\"values32\":[-0.25,\"-Infinity\"]}}\n");
  EXPECT_EQ(robot_.done().back(), (NotebookRobot::Done{1, -0.25, 0, 0.04, CommandOrigin::Refused}));
}

TEST_F(RobotEndTest, GoesOnForSeveralTicksUnderCommandsThatLapse) {
  const auto peer = commander();
  say(peer, "{\"act\":{\"ttl_ms\":250,\"values\":[0.5,0.5]}}\n");
  const std::string answer = say(peer, "{\"step\":{\"tick\":1,\"ticks\":3}}\n");
  EXPECT_NE(answer.find("{\"sense\":{\"tick\":4,"), std::string::npos) << answer;
  EXPECT_NE(answer.find("\"earlier\":[{\"tick\":2,"), std::string::npos) << answer;
  ASSERT_EQ(robot_.done().size(), 4u);
  EXPECT_EQ(robot_.done()[1].left, 0.5);
  EXPECT_NEAR(robot_.done()[2].ttl_s, 0.05, 1e-12);
  EXPECT_EQ(robot_.done()[3], (NotebookRobot::Done{3, 0, 0, 0, CommandOrigin::Safe}));
}

TEST_F(RobotEndTest, RefusesInWords) {
  expect_refused("GET / HTTP/1.1\r\n", "this is a Ganglion robot link", false);
  expect_refused("{\"act\":{}}\n", "say Hello before Act", false);
  expect_refused("{}\n", "say Hello first", false);
  expect_refused("{\"telepathy\":{}}\n", "say Hello first", false);
  expect_refused("{\"hello\":{\"major\":2}}\n", "speaks protocol 1.0, not 2.0", false);
  expect_refused("{\"hello\":{\"major\":1,\"token\":\"guessed\"}}\n", "that session is over", false);
  expect_refused(kHello, "Hello is said once");
  expect_refused("{\"hello\n", "a JSON line cannot be read");
  expect_refused("{\"sense\":{}}\n", "Sense is for the robot to send");
  expect_refused("{\"act\":{}}\n", "must have 2 values");
  expect_refused("{\"act\":{\"values\":[1]}}\n", "must have 2 values");
  expect_refused("{\"act\":{\"tick\":5,\"values\":[1,1]}}\n", "for tick 5, but the robot is at 0");
  expect_refused("{\"act\":{\"step_s\":\"NaN\",\"values\":[1,1]}}\n", "step_s is nan");
  expect_refused("{\"act\":{\"step_s\":3601,\"values\":[1,1]}}\n", "step_s is 3601, must be ");
  expect_refused("{\"act\":{\"step_s\":3601,\"values\":[1,1]}}\n", "0 and at most 3600\"");
  expect_refused("{\"step\":{\"ticks\":100000}}\n", "must be 1 to 1000");
  expect_refused("{\"step\":{\"ticks\":1000,\"step_s\":3600}}\n",
                 "Step asks for 1000 ticks of 3600 s, must be at most 3600 s in all");
  expect_refused("{" + std::string(2 << 20, 'x'), "a line is longer than");
  EXPECT_EQ(robot_.done().size(), 0u);
}

TEST_F(RobotEndTest, RefusesAnAnnouncedGiantAtOnce) {
  const auto peer = open();
  EXPECT_NE(say(peer, std::string("\0\x10\0\x01", 4)).find("announces 1048577 bytes"), std::string::npos);
  EXPECT_TRUE(end_.closing(peer));
  const auto other = open();  // who has not said Hello may not even announce 5 kB
  EXPECT_NE(say(other, std::string("\0\0\x14\0", 4)).find("announces 5120 bytes; the limit is 4096"),
            std::string::npos);
}

TEST_F(RobotEndTest, LogsAStrangerWhoIsSentAwayOnceASecond) {
  int lines = 0;
  RobotEndConfig config = robot_config();
  config.log = [&lines](const Sentence&) { ++lines; };
  RobotEnd end(robot_, config);
  for (int n = 0; n < 1000; ++n) end.receive(end.open(Carrier::Stream, "somebody", 3), "{}\n", 3);
  EXPECT_EQ(lines, 1);
  end.receive(end.open(Carrier::Stream, "somebody", 4), "{}\n", 4);
  EXPECT_EQ(lines, 2);
}

TEST_F(RobotEndTest, LetsOneCommandAndOthersWatch) {
  const auto first = commander();
  const auto second = open();
  EXPECT_NE(say(second, kHello).find("\"code\":\"BUSY\""), std::string::npos);
  const auto watcher = open();
  EXPECT_NE(say(watcher, "{\"hello\":{\"major\":1,\"role\":\"WATCH\"}}\n").find("\"sense\""), std::string::npos);
  say(first, "{\"act\":{\"values\":[0.5,0.5]}}\n");
  EXPECT_NE(hear(watcher).find("{\"sense\":{\"tick\":1,"), std::string::npos);
  EXPECT_NE(say(watcher, "{\"act\":{\"tick\":1,\"values\":[1,1]}}\n").find("who watches sends no Act"),
            std::string::npos);
  EXPECT_EQ(robot_.done().size(), 1u);
}

TEST_F(RobotEndTest, GivesTheFreePlaceToTheNext) {
  const auto first = commander();
  say(first, "{\"act\":{\"values\":[0.5,0.5]}}\n");
  end_.lost(first, now_s_);
  now_s_ = 0.9;
  EXPECT_NE(say(open(), kHello).find("BUSY"), std::string::npos);
  now_s_ = 1.1;
  const auto next = commander();
  EXPECT_NE(say(open(), "{\"hello\":{\"major\":1,\"token\":\"token0\"}}\n").find("NO_SESSION"), std::string::npos);
  say(next, "{\"step\":{\"tick\":1,\"ticks\":1}}\n");
  EXPECT_EQ(robot_.done().back().left, 0);  // nothing is left of the other's commands
}

TEST_F(RobotEndTest, PutsAsideWhoStandsButIsSilent) {
  const auto first = commander();
  say(first, "{\"act\":{\"values\":[0.5,0.5]}}\n");
  now_s_ = 9.9;
  EXPECT_NE(say(open(), kHello).find("BUSY"), std::string::npos);
  now_s_ = 10;
  commander();
  EXPECT_NE(hear(first).find("REPLACED"), std::string::npos);
  EXPECT_TRUE(end_.closing(first));
}

TEST_F(RobotEndTest, ClosesWhoSaysNoHelloInTime) {
  const auto peer = open();
  say(peer, "{\"hel");
  now_s_ = 5;
  EXPECT_LE(end_.due_s(), now_s_);
  end_.poll(now_s_);
  EXPECT_NE(hear(peer).find("no Hello within 5 s"), std::string::npos);
  EXPECT_TRUE(end_.closing(peer));
}

TEST_F(RobotEndTest, DropsWhoDoesNotRead) {
  const auto watcher = open();
  say(watcher, "{\"hello\":{\"major\":1,\"role\":\"WATCH\"}}\n");
  const auto peer = commander();
  for (int tick = 0; tick < 10'000; ++tick) {
    say(peer, fmt::format("{{\"act\":{{\"tick\":{},\"values\":[0,0]}}}}\n", tick));
  }
  EXPECT_LT(end_.outgoing(watcher).size(), 70'000u);
  now_s_ = 11;
  end_.poll(now_s_);
  EXPECT_TRUE(end_.gone(watcher));
  EXPECT_FALSE(end_.gone(peer));
}

TEST_F(RobotEndTest, TakesAThousandConnectionsAndKeepsAFew) {
  const auto peer = commander();
  std::size_t refused = 0;
  for (int n = 0; n < 1000; ++n) refused += hear(open()).find("no more than 256 connections") != std::string::npos;
  EXPECT_EQ(refused, 1000u - 255u);
  EXPECT_NE(say(peer, "{\"act\":{\"values\":[0,0]}}\n").find("\"tick\":1"), std::string::npos);
}

TEST_F(RobotEndTest, EchoesAResetAndSaysWhyItCannot) {
  const auto peer = commander();
  EXPECT_EQ(say(peer, "{\"reset\":{\"seed\":\"18446744073709551615\",\"episode\":2}}\n"),
            "{\"reset\":{\"seed\":\"18446744073709551615\",\"episode\":2}}\n"
            "{\"sense\":{\"values\":[0,0,\"NaN\"],\"ages_s\":[0,0]}}\n");
  robot_.refuses_reset = true;
  const std::string answer = say(peer, "{\"reset\":{}}\n");
  EXPECT_NE(answer.find("\"reason\":\"the robot cannot be reset: no place to stand\""), std::string::npos) << answer;
  EXPECT_NE(answer.find("\"reason_es\":\"el robot no se puede reiniciar: no hay dónde estar\""), std::string::npos)
      << answer;
}

TEST_F(RobotEndTest, AnswersHeartbeatsWithItsOwnTime) {
  const auto peer = commander();
  now_s_ = 12.5;
  EXPECT_EQ(say(peer, "{\"beat\":{\"number\":3,\"time_s\":1}}\n"),
            "{\"beat\":{\"number\":3,\"answer\":true,\"time_s\":12.5}}\n");
}

TEST_F(RobotEndTest, IgnoresWhatALaterVersionAdds) {
  const auto peer = commander();
  EXPECT_EQ(say(peer, "{\"telepathy\":{\"strength\":1}}\n"), "");
  EXPECT_NE(say(peer, "{\"act\":{\"mood\":\"good\",\"values\":[0,0]}}\n").find("\"tick\":1"), std::string::npos);
  EXPECT_FALSE(end_.closing(peer));
}

TEST_F(RobotEndTest, LetsAControllerOnASerialLineStartAgain) {
  const auto line = end_.open(Carrier::Packets, "serial", now_s_);
  FrameWriter writer(Carrier::Packets, Encoding::Binary);
  wire::Hello hello;
  hello.set_major(1);
  std::string bytes;
  ASSERT_TRUE(writer.append(hello, bytes));
  wire::Act act;
  act.add_values(0.5);
  act.add_values(0.5);
  ASSERT_TRUE(writer.append(act, bytes));
  say(line, bytes);
  ASSERT_EQ(robot_.done().size(), 1u);
  bytes.clear();
  hello.set_role(wire::WATCH);  // somebody else was plugged in, who only looks
  ASSERT_TRUE(writer.append(hello, bytes));
  say(line, bytes);
  EXPECT_FALSE(end_.commands(line));
  bytes.clear();
  hello.set_role(wire::COMMAND);
  ASSERT_TRUE(writer.append(hello, bytes));
  now_s_ = 2;
  say(line, bytes);
  EXPECT_TRUE(end_.commands(line));
}

TEST_F(RobotEndTest, ForgetsWhatASerialLineDoesNotTake) {
  const auto line = end_.open(Carrier::Packets, "serial", now_s_);
  FrameWriter writer(Carrier::Packets, Encoding::Binary);
  wire::Hello hello;
  hello.set_major(1);
  hello.set_role(wire::WATCH);
  std::string bytes;
  ASSERT_TRUE(writer.append(hello, bytes));
  for (int n = 0; n < 20'000; ++n) {
    end_.receive(line, bytes, now_s_);
    ASSERT_LE(end_.outgoing(line).size(), std::size_t{4} << 20);
  }
  now_s_ = 100;
  end_.poll(now_s_);
  EXPECT_FALSE(end_.gone(line));
  EXPECT_GT(end_.due_s(), now_s_);
}

/// Sessions with a few bytes changed, left out or put in, fed in pieces.
TEST(RobotEnd, SurvivesSpoiltSessions) {
  std::mt19937 chance(5);
  const auto below = [&chance](std::size_t limit) { return chance() % limit; };
  for (const Carrier carrier : {Carrier::Stream, Carrier::Packets}) {
    for (const Encoding encoding : {Encoding::Binary, Encoding::Json}) {
      ControllerEnd controller({.carrier = carrier, .encoding = encoding});
      controller.greet(0);
      controller.connected(0);
      std::string session = controller.outgoing();
      FrameWriter writer(carrier, encoding);
      wire::Act act;
      act.add_values(0.5);
      act.add_values(-0.5);
      for (std::uint32_t tick = 0; tick < 5; ++tick) {
        act.set_tick(tick);
        ASSERT_TRUE(writer.append(act, session));
      }
      for (int round = 0; round < 2500; ++round) {
        std::string spoilt = session;
        for (std::size_t n = below(4) + 1; n > 0; --n) {
          const std::size_t at = below(spoilt.size());
          const auto byte = static_cast<char>(chance());
          if (below(3) == 0) {
            spoilt.erase(at, below(20) + 1);
            spoilt += byte;
          } else if (below(2) == 0) {
            spoilt.insert(at, 1, byte);
          } else {
            spoilt[at] = byte;
          }
        }
        NotebookRobot robot;
        robot.stepping = [](const ActFrame& frame) {
          for (const double value : frame.values) ASSERT_TRUE(std::fabs(value) <= 1);
        };
        ASSERT_TRUE(robot.reset(1, 0));
        RobotEnd end(robot, robot_config());
        const auto peer = end.open(carrier, "spoiler", 0);
        for (std::size_t at = 0; at < spoilt.size(); at += 37) end.receive(peer, spoilt.substr(at, 37), 0);
        ASSERT_LE(robot.done().size(), 1000u);
      }
    }
  }
}

}  // namespace
}  // namespace ganglion::link
