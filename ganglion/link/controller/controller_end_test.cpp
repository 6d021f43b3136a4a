#include "ganglion/link/controller/controller_end.h"

#include <gtest/gtest.h>

namespace ganglion::link {
namespace {

/// What the end says, taken from it: the kinds of its frames.
std::string said(ControllerEnd& end) {
  FrameReader reader(Carrier::Stream);
  reader.feed(end.outgoing());
  end.outgoing().clear();
  Messages messages;
  std::string kinds;
  while (true) {
    const auto payload = reader.next();
    if (!payload || !*payload) return kinds;
    const auto kind = decode(**payload, Encoding::Binary, messages);
    kinds.append(kinds.empty() ? "" : " ").append(kind ? name_of(*kind) : "?");
  }
}

template <class Message>
void hear(ControllerEnd& end, const Message& message, double now_s) {
  std::string bytes;
  ASSERT_TRUE(FrameWriter(Carrier::Stream, Encoding::Binary).append(message, bytes));
  end.receive(bytes, now_s);
}

wire::Sense sense_of(std::uint32_t tick) {
  wire::Sense sense;
  sense.set_tick(tick);
  return sense;
}

/// The robot's greeting over a connection just made.
void greet(ControllerEnd& end, bool resumed, double now_s) {
  wire::Hello hello;
  hello.set_major(1);
  hello.set_token("t");
  hello.set_resumed(resumed);
  hear(end, hello, now_s);
  hear(end, wire::Describe(), now_s);
  hear(end, sense_of(0), now_s);
}

void poll_until(ControllerEnd& end, double until_s) {
  while (end.due_s() <= until_s && !end.wants_connection()) end.poll(end.due_s());
}

ControllerEndConfig paced(wire::Pace pace) {
  ControllerEndConfig config;
  config.pace = pace;
  return config;
}

TEST(ControllerEnd, GivesAConnectionUpThatAnswersHeartbeatsButNotTheRequest) {
  ControllerEnd end(paced(wire::LOCK_STEP));
  end.greet(0);
  end.connected(0);
  EXPECT_EQ(said(end), "Hello");
  greet(end, false, 0);
  ASSERT_TRUE(end.done());
  const std::vector<ActFrame> act(1);  // of a robot without commands
  end.poll(1);
  end.act(act, 0.1, 1);
  EXPECT_EQ(said(end), "Beat Act");
  for (std::uint32_t number = 2; number <= 3; ++number) {
    poll_until(end, number);
    EXPECT_EQ(said(end), "Beat");
    wire::Beat answer;
    answer.set_number(number);
    answer.set_answer(true);
    hear(end, answer, number);
  }
  EXPECT_FALSE(end.wants_connection());
  poll_until(end, 4);  // 3 s after the Act
  EXPECT_TRUE(end.wants_connection());
  end.connected(4);
  EXPECT_TRUE(said(end).ends_with("Hello"));
  greet(end, true, 4);
  EXPECT_EQ(said(end), "Act");  // the robot's Sense shows that it never got it
}

TEST(ControllerEnd, GivesAConnectionUpWhoseGreetingWasLostWhileTheRobotTicks) {
  ControllerEnd end(paced(wire::FREE_RUNNING));
  end.greet(0);
  end.connected(0);
  for (std::uint32_t tick = 0; tick < 30; ++tick) {
    hear(end, sense_of(tick), 0.1 * tick);
    poll_until(end, 0.1 * tick);
    EXPECT_FALSE(end.wants_connection());
  }
  poll_until(end, 3);
  EXPECT_TRUE(end.wants_connection());
}

TEST(ControllerEnd, SaysHelloOnceInAConnection) {
  ControllerEnd end(paced(wire::FREE_RUNNING));
  end.greet(0);
  end.connected(0);
  greet(end, false, 0);
  end.take_sense();
  hear(end, sense_of(1), 0.1);  // there already when it is asked for
  end.disconnected(0.1);
  end.await_sense(0.1);
  ASSERT_TRUE(end.done());
  end.connected(0.2);
  EXPECT_EQ(said(end), "Hello");
  end.take_sense();
  end.await_sense(0.3);
  EXPECT_EQ(said(end), "");
}

TEST(ControllerEnd, TakesNoSenseForNewerThanTheLastTickThereIs) {
  ControllerEnd end(paced(wire::FREE_RUNNING));
  end.greet(0);
  end.connected(0);
  greet(end, false, 0);
  hear(end, sense_of(0xFFFFFFFF), 0.1);
  EXPECT_EQ(end.sense().tick(), 0xFFFFFFFF);
  end.take_sense();
  end.await_sense(0.1);
  hear(end, sense_of(3), 0.2);
  EXPECT_FALSE(end.done());
}

}  // namespace
}  // namespace ganglion::link
