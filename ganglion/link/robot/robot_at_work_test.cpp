#include <gtest/gtest.h>

#include "ganglion/link/robot/robot_end.h"
#include "ganglion/link/testing/bench.h"

// Whatever one frame asks for and however much is sent, everybody else is looked at in between.
namespace ganglion::link {
namespace {

/// A robot's end that counts its looks at the clock.
class RobotAtWork : public ::testing::Test {
 protected:
  RobotAtWork() : end_(robot_, config()) { EXPECT_TRUE(robot_.reset(1, 0)); }
  RobotEndConfig config() {
    RobotEndConfig config = robot_config();
    config.longest_step_s = 10;
    config.clock = [this] {
      ++looks_;
      return now_s_;
    };
    return config;
  }
  std::string hear(RobotEnd::PeerId peer) {
    std::string heard(end_.outgoing(peer));
    end_.sent(peer, heard.size(), now_s_);
    return heard;
  }
  std::string say(RobotEnd::PeerId peer, const std::string& bytes) {
    end_.receive(peer, bytes, now_s_);
    return hear(peer);
  }
  RobotEnd::PeerId open(const char* hello) {
    const auto peer = end_.open(Carrier::Stream, "somebody", now_s_);
    EXPECT_NE(say(peer, hello).find("\"sense\""), std::string::npos);
    return peer;
  }

  const char* kCommands = "{\"hello\":{\"major\":1}}\n";
  const char* kRunsFree = "{\"hello\":{\"major\":1,\"pace\":\"FREE_RUNNING\"}}\n";
  const char* kWatches = "{\"hello\":{\"major\":1,\"role\":\"WATCH\"}}\n";
  double now_s_ = 0;
  int looks_ = 0;
  NotebookRobot robot_;
  RobotEnd end_;
};

TEST_F(RobotAtWork, CarriesALongStepOutInSlicesAndHearsOthersBetween) {
  const auto peer = open(kCommands), watcher = open(kWatches);
  EXPECT_EQ(say(peer, "{\"step\":{\"ticks\":10,\"step_s\":4}}\n{\"beat\":{\"number\":5}}\n"), "");
  EXPECT_EQ(robot_.done().size(), 2u) << "8 s of the 10 that a slice has";
  EXPECT_TRUE(end_.waits(peer));
  EXPECT_LE(end_.due_s(), now_s_);
  EXPECT_NE(say(watcher, "{\"beat\":{\"number\":7}}\n").find("\"number\":7"), std::string::npos);
  for (const std::size_t done : {4u, 6u, 8u, 10u}) {
    EXPECT_TRUE(end_.waits(peer));
    end_.poll(now_s_);
    EXPECT_EQ(robot_.done().size(), done);
  }
  EXPECT_FALSE(end_.waits(peer));
  const std::string answer = hear(peer);
  EXPECT_NE(answer.find("{\"sense\":{\"tick\":10,"), std::string::npos) << answer;
  EXPECT_NE(answer.find("\"earlier\":[{\"tick\":1,"), std::string::npos) << answer;
  EXPECT_LT(answer.find("\"sense\""), answer.find("\"beat\"")) << "what came after it is answered after it";
  EXPECT_EQ(hear(watcher).find("earlier"), std::string::npos) << "a watcher saw them all";
}

TEST_F(RobotAtWork, TakesNoStepThatIsLongerThanASlice) {
  EXPECT_NE(say(open(kCommands), "{\"act\":{\"step_s\":10.5,\"values\":[1,1]}}\n").find("at most 10\""),
            std::string::npos);
  EXPECT_TRUE(robot_.done().empty());
}

TEST_F(RobotAtWork, DropsALongStepWithTheConnectionThatAskedForIt) {
  const auto peer = open(kCommands);
  say(peer, "{\"step\":{\"ticks\":100,\"step_s\":10}}\n");
  end_.lost(peer, now_s_);
  end_.poll(now_s_);
  EXPECT_EQ(robot_.done().size(), 1u);
  now_s_ = 1;
  const auto next = open(kCommands);
  EXPECT_FALSE(end_.waits(next));
  end_.poll(now_s_);
  EXPECT_EQ(robot_.done().size(), 1u);
}

TEST_F(RobotAtWork, LooksAtWhatIsDueWithinWhateverIsSent) {
  const auto commander = open(kRunsFree);
  say(commander, "{\"act\":{\"tick\":1,\"ttl_ms\":250,\"values\":[1,1]}}\n");
  const auto watcher = open(kWatches);
  looks_ = 0;
  std::string flood;
  for (int n = 0; n < 6400; ++n) flood += "{}\n";
  now_s_ = 0.95;  // while it is read, nine ticks become due
  say(watcher, flood);
  EXPECT_GE(looks_, 99) << "6,400 frames, 64 between two looks";
  ASSERT_EQ(robot_.done().size(), 9u);
  EXPECT_EQ(robot_.done().back().origin, CommandOrigin::Safe);
  say(watcher, "{\"x\":\"" + std::string(4000, 'x') + "\"}\n");
  say(commander, "{\"x\":\"" + std::string(500'000, 'x') + "\"}\n");
  EXPECT_EQ(end_.most_taken().frames, RobotEnd::kMostFrames);
  EXPECT_EQ(end_.most_taken().bytes, RobotEnd::kMostBytes);
}

}  // namespace
}  // namespace ganglion::link
