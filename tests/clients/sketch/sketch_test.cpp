#include <gtest/gtest.h>

#include "ganglion/link/wire/codec.h"
#include "tests/clients/sketch/Arduino.h"

// As the Arduino IDE compiles it, the header first.
#include "clients/c/arduino/cart/cart.ino"

namespace ganglion::link {
namespace {

/// The sketch that people begin from, on a board in memory.
class Sketch : public ::testing::Test {
 protected:
  Sketch() {
    board = {};
    setup();
  }
  template <class Message>
  void say(const Message& message) {
    EXPECT_TRUE(FrameWriter(Carrier::Packets, Encoding::Binary).append(message, board.received));
    while (Serial.available() > 0) loop();
  }
  FrameKind next() {
    reader_.feed(board.sent);
    board.sent.clear();
    const auto payload = reader_.next();
    return payload && *payload ? *decode(**payload, Encoding::Binary, in_) : FrameKind::Unknown;
  }
  void greet() {
    wire::Hello hello;
    hello.set_major(1);
    hello.set_pace(wire::FREE_RUNNING);
    say(hello);
    EXPECT_EQ(next(), FrameKind::Hello);
    EXPECT_EQ(next(), FrameKind::Describe);
    EXPECT_EQ(next(), FrameKind::Sense);
  }

  FrameReader reader_{Carrier::Packets};
  Messages in_;
};

TEST_F(Sketch, TellsItsRangesAndWhatIsOutOfThem) {
  board.analog[A0] = 205;  // 1.002 V
  board.analog[A1] = 40;   // 0.196 V: 1.3 m
  greet();
  EXPECT_EQ(in_.describe.name(), "Cart on an Arduino");
  ASSERT_EQ(in_.sense.values32_size(), 2);
  EXPECT_NEAR(in_.sense.values32(0), 0.2595, 1e-4);
  EXPECT_EQ(in_.sense.values32(1), HUGE_VALF);
}

TEST_F(Sketch, DrivesAndStopsByItself) {
  greet();
  wire::Act act;
  act.set_tick(1);
  act.set_ttl_ms(200);
  act.add_values32(1);
  act.add_values32(-0.5F);
  say(act);
  EXPECT_EQ(board.analog[5], 255);
  EXPECT_EQ(board.digital[4], HIGH);
  EXPECT_EQ(board.analog[6], 127);
  EXPECT_EQ(board.digital[7], LOW);
  board.ms = 199;
  loop();
  EXPECT_EQ(board.analog[5], 255);
  board.ms = 200;
  loop();
  EXPECT_EQ(board.analog[5], 0);
  EXPECT_EQ(board.analog[6], 0);
}

TEST_F(Sketch, StopsInTimeWhileItsLineCarriesBytesWithoutPause) {
  greet();
  wire::Act act;
  act.set_tick(1);
  act.set_ttl_ms(200);
  act.add_values32(1);
  act.add_values32(1);
  say(act);
  board.ms = 200;
  board.received = std::string(100'000, 'x');
  loop();
  EXPECT_EQ(board.analog[5], 0);
  EXPECT_EQ(Serial.available(), 100'000 - 64);
}

}  // namespace
}  // namespace ganglion::link
