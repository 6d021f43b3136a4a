#include <gtest/gtest.h>

#include <random>

#include "tests/clients/frames_for_robot.h"

// clients/c and bytes that follow no rule.
namespace ganglion::link {
namespace {

std::string bytes_of(const auto& message) {
#ifdef GANGLION_ROBOT_STREAM
  FrameWriter writer(Carrier::Stream, Encoding::Binary);
#else
  FrameWriter writer(Carrier::Packets, Encoding::Binary);
#endif
  std::string bytes;
  EXPECT_TRUE(writer.append(message, bytes));
  return bytes;
}

#ifndef GANGLION_ROBOT_STREAM
TEST(CRobot, IgnoresPacketsThatAreDamagedAndTakesTheNext) {
  const std::string whole = bytes_of(act(0, {1, 0, 1}));
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    CRobot robot;
    robot.greet(wire::FREE_RUNNING);
    robot.receive(damaged);
    EXPECT_EQ(robot.done, kSafe) << bit;
    robot.receive(std::string_view("\0", 1));  // a line is made quiet by what was the end
    robot.receive(whole);
    EXPECT_EQ(robot.done, (Floats{1, 0, 1})) << bit;
  }
}

TEST(CRobot, IgnoresPacketsThatAreTooLongForItAndTakesTheNext) {
  CRobot robot;
  robot.greet(wire::FREE_RUNNING);
  wire::Hello hello;
  hello.set_major(1);
  hello.set_name(std::string(1000, 'x'));
  robot.say(hello);
  EXPECT_EQ(robot.next(), FrameKind::Unknown);
  robot.say(act(0, {1, 0, 1}));
  EXPECT_EQ(robot.done, (Floats{1, 0, 1}));
}

TEST(CRobot, LosesNoPacketToTextThatIsPrintedBeforeIt) {
  CRobot robot;
  wire::Hello hello;
  hello.set_major(1);
  robot.say(hello);
  std::size_t doubled = 0;  // the end of a packet, and what goes ahead of the next
  for (std::size_t n = 1; n < robot.out.size(); ++n) doubled += robot.out[n - 1] == 0 && robot.out[n] == 0;
  EXPECT_EQ(robot.out.front(), 0) << "ahead of Hello";
  EXPECT_EQ(doubled, 2u) << "ahead of Describe, ahead of Sense";
  robot.out.clear();
  std::string line;
  wire::Beat beat;
  for (std::uint32_t number = 1; number <= 10; ++number) {
    beat.set_number(number);
    robot.say(beat);
    line += "dist=7 cm, v=0.2\r\n" + robot.out;
    robot.out.clear();
  }
  FrameReader reader(Carrier::Packets);
  reader.feed(line);
  for (std::uint32_t number = 1; number <= 10; ++number) {
    const auto payload = reader.next();
    ASSERT_TRUE(payload && *payload) << number;
    ASSERT_EQ(*decode(**payload, Encoding::Binary, robot.in), FrameKind::Beat);
    EXPECT_EQ(robot.in.beat.number(), number);
  }
  EXPECT_EQ(reader.take_damaged(), 10u) << "the texts";
}

TEST(CRobot, TakesPacketsWithZerosAhead) {
  CRobot robot;
  robot.greet(wire::FREE_RUNNING);
  robot.receive(std::string(3, '\0') + bytes_of(act(0, {1, 0, 1})));
  EXPECT_EQ(robot.done, (Floats{1, 0, 1}));
}

TEST(CRobot, LeavesJsonAndMessagesOfLaterVersionsAlone) {
  CRobot robot;
  robot.greet(wire::FREE_RUNNING);
  for (const std::string_view payload : {"{\"act\":{}}", "\x52\x01\x01", "\x7a"}) {
    std::string packet;
    append_frame(payload, Carrier::Packets, Encoding::Binary, packet);
    robot.receive(packet);
  }
  EXPECT_EQ(robot.next(), FrameKind::Unknown);
}
#else
TEST(CRobot, ClosesAConnectionWhoseFramesAreTooLong) {
  CRobot robot;
  robot.greet(wire::FREE_RUNNING);
  robot.receive(std::string_view("\xFF\xFF\xFF\xFF", 4));
  EXPECT_EQ(robot.next(), FrameKind::Bye);
  EXPECT_FALSE(robot.connected());
}
#endif

/// Whatever came, what it does is within its limits.
void expect_sane(const CRobot& robot) {
  ASSERT_EQ(robot.done.size(), 3u);
  ASSERT_TRUE(robot.done[0] >= -1 && robot.done[0] <= 1);
  ASSERT_TRUE(robot.done[1] >= 0 && robot.done[1] <= 0.5F);
  ASSERT_TRUE(robot.done[2] >= 0 && robot.done[2] <= 1);
}

TEST(CRobot, SurvivesFramesWithAnyBytesInThem) {
  std::mt19937 random(1);
  wire::Act full = step(0, 0.1);
  full.add_ttl_s(0.1);
  full.add_origins(1);
  std::string seeds[] = {full.SerializeAsString(), step(0, 0.1).SerializeAsString()};
  int carried_out = 0;
  for (int n = 0; n < 100'000; ++n) {
    CRobot robot;
    robot.greet(n % 2 == 0 ? wire::LOCK_STEP : wire::FREE_RUNNING);
    const int before = robot.acts;
    std::string inner = seeds[n % 3 % 2];
    for (unsigned changes = random() % 4; changes > 0; --changes)
      inner[random() % inner.size()] = static_cast<char>(random());
    if (random() % 4 == 0) inner.resize(random() % inner.size());
    std::string payload{static_cast<char>(random() % 8 == 0 ? random() : 0x22), static_cast<char>(inner.size())};
    payload += inner;
    std::string bytes;
#ifdef GANGLION_ROBOT_STREAM
    append_frame(payload, Carrier::Stream, Encoding::Binary, bytes);
#else
    append_frame(payload, Carrier::Packets, Encoding::Binary, bytes);
#endif
    robot.receive(bytes);
    robot.now_ms += 1000;
    robot.poll();
    expect_sane(robot);
    robot.last();
    carried_out += robot.acts > before + 1;
    if (HasFatalFailure()) FAIL() << n;
  }
  EXPECT_GT(carried_out, 10'000) << "most must get past the first check";
}

TEST(CRobot, SurvivesAnyBytesOnTheLine) {
  std::mt19937 random(2);
  CRobot robot;
  robot.greet(wire::FREE_RUNNING);
  for (int n = 0; n < 1'000'000; ++n) {
    robot.receive(std::string(1, static_cast<char>(random() % 3 == 0 ? random() % 8 : random())));
    if (n % 1000 == 0) robot.out.clear();
  }
  expect_sane(robot);
#ifndef GANGLION_ROBOT_STREAM
  robot.receive(std::string_view("\0", 1));
  robot.out.clear();
  robot.greet(wire::FREE_RUNNING);
#endif
}

}  // namespace
}  // namespace ganglion::link
