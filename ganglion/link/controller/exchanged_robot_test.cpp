#include <gtest/gtest.h>

#include "ganglion/link/controller/controller_end.h"

// What a board on a serial line may do: print text, be started again, be another one after a new plug.
namespace ganglion::link {
namespace {

/// A cart whose two wheels are named in that order.
wire::Describe cart(const char* first = "left", const char* second = "right", double most = 1) {
  wire::Describe describe;
  describe.set_name("Cart");
  describe.set_tick_s(0.1);
  describe.set_lock_step(true);
  describe.set_free_running(true);
  auto* drive = describe.add_commands();
  drive->set_name("drive");
  for (const char* name : {first, second}) {
    auto* wheel = drive->add_elements();
    wheel->set_name(name);
    wheel->set_min(-1);
    wheel->set_max(most);
  }
  return describe;
}

/// The controller's end of a serial line.
class Board {
 public:
  explicit Board(wire::Pace pace = wire::LOCK_STEP) : end(config_of(pace)) {
    end.greet(0);
    end.connected(0);
  }

  template <class Message>
  void says(const Message& message) {
    std::string bytes;
    ASSERT_TRUE(FrameWriter(Carrier::Packets, Encoding::Binary).append(message, bytes));
    prints(bytes);
  }
  void prints(std::string_view bytes) { end.receive(bytes, now_s); }
  void hello(bool resumed = false) {
    wire::Hello hello;
    hello.set_major(1);
    hello.set_token("t");
    hello.set_floats(true);
    hello.set_resumed(resumed);
    says(hello);
  }
  void sense(std::uint32_t tick) {
    wire::Sense sense;
    sense.set_tick(tick);
    says(sense);
  }
  void greets(const wire::Describe& describe, std::uint32_t tick, bool resumed = false) {
    hello(resumed);
    says(describe);
    sense(tick);
  }
  void act() {
    ActFrame act;
    act.values = {0.5, -0.25};
    act.ttl_s = {0.3};
    act.origins = {CommandOrigin::Commanded};
    act.reasons = {0};
    end.act({&act, 1}, 0.1, now_s);
  }
  /// Says nothing until the end goes back to Hello.
  void falls_silent() {
    now_s += 3.5;
    end.poll(now_s);
  }
  /// The kinds of what the end has sent since.
  std::string heard() {
    FrameReader reader(Carrier::Packets);
    reader.feed(end.outgoing());
    end.outgoing().clear();
    std::string kinds;
    for (auto payload = reader.next(); payload && *payload; payload = reader.next()) {
      const auto kind = decode(**payload, *reader.encoding(), last);
      kinds.append(kinds.empty() ? "" : " ").append(kind ? name_of(*kind) : "?");
    }
    return kinds;
  }
  std::string failure() const { return end.failure() ? end.failure()->what.en : ""; }

  double now_s = 0;
  ControllerEnd end;
  Messages last;

 private:
  static ControllerEndConfig config_of(wire::Pace pace) {
    ControllerEndConfig config;
    config.carrier = Carrier::Packets;
    config.pace = pace;
    return config;
  }
};

TEST(SerialRobot, IsNotGreetedWithoutItsHello) {
  Board board;
  EXPECT_EQ(board.heard(), "Hello");
  board.says(cart());  // its Hello fell into the text it printed
  board.sense(0);
  EXPECT_FALSE(board.end.done());
  board.now_s = 0.3;
  board.end.poll(board.now_s);
  EXPECT_EQ(board.heard(), "Hello");
  board.greets(cart(), 0);
  ASSERT_TRUE(board.end.done());
  board.act();
  EXPECT_EQ(board.heard(), "Act");
  EXPECT_EQ(board.last.act.values32_size(), 2) << "it takes no doubles";
}

TEST(SerialRobot, IsHeardThoughItPrintsTextBeforeEveryPacket) {
  Board board;
  board.prints("boot: v1.2\r\n");
  board.greets(cart(), 0);
  EXPECT_TRUE(board.end.done());
}

TEST(SerialRobot, ThatIsAnotherOneGetsNoCommandAfterAnyReconnection) {
  for (const int reconnections : {1, 2, 200}) {
    for (const wire::Describe& other : {cart("right", "left"), cart("left", "right", 0.5), wire::Describe()}) {
      Board board;
      board.greets(cart(), 0);
      for (int n = 1; n <= reconnections; ++n) {
        board.act();
        board.falls_silent();
        board.heard();
        if (n < reconnections) {
          board.greets(cart(), static_cast<std::uint32_t>(n), true);
          ASSERT_TRUE(board.end.done()) << board.failure();
        }
      }
      board.greets(other, static_cast<std::uint32_t>(reconnections), true);
      EXPECT_EQ(board.heard(), "");
      EXPECT_NE(board.failure().find("another robot than before"), std::string::npos) << board.failure();
    }
  }
}

TEST(SerialRobot, ThatBeganAnewIsNoticedInLockStep) {
  Board board;
  board.greets(cart(), 7);
  board.act();
  board.sense(7);
  board.sense(7);
  board.sense(7);
  EXPECT_EQ(board.failure(), "") << "repeated answers to repeated Acts";
  board.sense(0);
  board.sense(0);
  EXPECT_EQ(board.failure(), "");
  board.sense(0);
  EXPECT_EQ(board.failure(), "the robot's time went back: was it started again?");
}

TEST(SerialRobot, ThatBeganAnewIsNoticedWhileItRunsFreely) {
  for (const bool awaited : {true, false}) {
    Board board(wire::FREE_RUNNING);
    board.greets(cart(), 7);
    board.end.take_sense();
    if (awaited) board.end.await_sense(0);
    board.sense(0);
    board.sense(1);
    EXPECT_EQ(board.failure(), "");
    board.sense(2);
    EXPECT_EQ(board.failure(), "the robot's time went back: was it started again?");
  }
}

TEST(SerialRobot, MayRepeatAnOldSenseNowAndThen) {
  Board board(wire::FREE_RUNNING);
  board.greets(cart(), 7);
  for (std::uint32_t tick = 8; tick < 20; ++tick) {
    board.end.take_sense();
    board.sense(tick - 2);
    board.sense(tick);
  }
  EXPECT_EQ(board.failure(), "");
  EXPECT_EQ(board.end.sense().tick(), 19u);
}

TEST(SerialRobot, ThatKnowsNothingOfTheSessionWasStartedAgain) {
  Board board;
  board.greets(cart(), 0);
  wire::Bye bye;
  bye.set_code(wire::NO_SESSION);
  bye.set_reason("unknown token");
  board.says(bye);
  EXPECT_NE(board.failure().find("was it started again?"), std::string::npos);
}

TEST(SerialRobot, ThatOnlyPrintsTextIsQuoted) {
  Board board;
  for (board.now_s = 0.1; board.failure().empty() && board.now_s < 20; board.now_s += 0.1) {
    board.prints(std::string("range 12 cm\r\n") + '\0');
    board.end.poll(board.now_s);
  }
  EXPECT_NE(board.failure().find("bytes come, but no whole packet, the last one \"range 12 cm"), std::string::npos)
      << board.failure();
}

TEST(SerialRobot, IsNotLostForAPacketThatCannotBeRead) {
  Board board;
  board.greets(cart(), 0);
  board.act();
  std::string packet;
  append_frame("no message", Carrier::Packets, Encoding::Binary, packet);
  board.prints(packet);
  EXPECT_EQ(board.failure(), "");
  board.sense(1);
  EXPECT_TRUE(board.end.done());
  board.act();
  for (board.now_s = 0.1; board.failure().empty() && board.now_s < 20; board.now_s += 0.1) {
    board.prints(packet);
    board.end.poll(board.now_s);
  }
  EXPECT_NE(board.failure().find("what came cannot be read"), std::string::npos) << board.failure();
}

}  // namespace
}  // namespace ganglion::link
