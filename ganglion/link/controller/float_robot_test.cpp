#include <gtest/gtest.h>

#include "ganglion/link/controller/controller_end.h"

namespace ganglion::link {
namespace {

/// The last Act that a controller sends to a robot that greeted it like that.
wire::Act act_after(bool floats) {
  ControllerEnd end({});
  end.greet(0);
  end.connected(0);
  FrameWriter robot(Carrier::Stream, Encoding::Binary);
  std::string bytes;
  wire::Hello hello;
  hello.set_major(1);
  hello.set_floats(floats);
  wire::Sense sense;
  EXPECT_TRUE(robot.append(hello, bytes) && robot.append(wire::Describe(), bytes) && robot.append(sense, bytes));
  end.receive(bytes, 0);
  EXPECT_TRUE(end.done());
  end.outgoing().clear();
  ActFrame act;
  act.values = {0.5, -0.25};
  act.ttl_s = {0.3};
  act.origins = {CommandOrigin::Commanded};
  act.reasons = {0};
  end.act({&act, 1}, 0.1, 0);
  FrameReader reader(Carrier::Stream);
  reader.feed(end.outgoing());
  Messages in;
  const auto payload = reader.next();
  EXPECT_EQ(decode(**payload, Encoding::Binary, in).value_or(FrameKind::Unknown), FrameKind::Act);
  return in.act;
}

TEST(ControllerEnd, SendsFloatsToARobotThatTakesNoDoubles) {
  const wire::Act narrow = act_after(true);
  EXPECT_EQ(narrow.values_size(), 0);
  ASSERT_EQ(narrow.values32_size(), 2);
  EXPECT_EQ(narrow.values32(0), 0.5F);
  EXPECT_EQ(narrow.values32(1), -0.25F);
  EXPECT_EQ(act_after(false).values_size(), 2);
}

}  // namespace
}  // namespace ganglion::link
