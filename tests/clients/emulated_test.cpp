#include <gtest/gtest.h>

#include "ganglion/base/testing/folder.h"
#include "ganglion/link/controller/remote_application.h"
#include "ganglion/link/net/lines.h"
#include "ganglion/link/net/program.h"
#include "ganglion/run/run.h"

// The example of clients/c, as it would run on a board, emulated: its serial line is a socket.
namespace ganglion {
namespace {

constexpr double kReach_s = 20;  // for the emulator to begin
enum Value : std::size_t { kX = 3, kContacts = 5, kStoppedAfter = 6 };

/// The way to the board, which can be cut.
class CutLine final : public link::Line {
 public:
  CutLine(std::unique_ptr<Line> line, const bool& cut, int& connections)
      : line_(std::move(line)), cut_(cut), connections_(connections) {}
  link::Carrier carrier() const noexcept override { return line_->carrier(); }
  const std::string& address() const noexcept override { return line_->address(); }
  double now_s() noexcept override { return line_->now_s(); }
  Result<void> connect(double until_s) override {
    auto connected = line_->connect(until_s);
    if (connected) ++connections_;
    done_ = cut_;
    return connected;
  }
  void close() noexcept override { line_->close(); }
  Result<void> send(std::string_view bytes, double until_s) override {
    if (auto gone = cut(); !gone) return gone;
    return line_->send(bytes, until_s);
  }
  Result<std::size_t> receive(std::span<char> room, double until_s) override {
    if (auto gone = cut(); !gone) return tl::unexpected<Error>(gone.error());
    return line_->receive(room, until_s);
  }
  void wait_until(double until_s) override { line_->wait_until(until_s); }

 private:
  /// Closes the socket, once.
  Result<void> cut() {
    if (!cut_ || done_) return {};
    line_->close();
    return fail(ErrorCode::LinkLost, {"cut", "cortada"});
  }
  std::unique_ptr<Line> line_;
  const bool& cut_;
  int& connections_;
  bool done_ = false;
};

class EmulatedRobot : public FolderTest {
 protected:
  void SetUp() override {
    if (std::string(GANGLION_QEMU).empty() || std::string(GANGLION_NIMROD_ELF).empty()) {
      GTEST_SKIP() << "NOT TESTED: the robot in C was not driven. Needed: gcc-arm-none-eabi, qemu-system-arm and "
                      "python3; ./dev test clients installs them";
    }
    const auto port = link::free_port();
    ASSERT_TRUE(port);
    // The board's clock goes by its instructions: what it measures does not depend on how busy this machine is.
    auto board = link::Program::start(
        {GANGLION_QEMU, "-M", "microbit", "-display", "none", "-monitor", "none", "-icount", "shift=6", "-serial",
         "tcp:127.0.0.1:{port},server=on,wait=off,nodelay=on", "-kernel", GANGLION_NIMROD_ELF},
        folder_, *port, folder_ / "qemu.log");
    ASSERT_TRUE(board) << board.error().what.en;
    board_ = std::make_unique<link::Program>(std::move(*board));
    address_ = fmt::format("serial+tcp://127.0.0.1:{}", *port);
    Problems problems;
    prepared_ = prepare(GANGLION_SOURCE_DIR "/clients/c/example", {{"application.address", address_}}, problems);
    ASSERT_TRUE(prepared_) << problems.text();
  }

  std::unique_ptr<link::RemoteApplication> connect(link::wire::Pace pace) {
    link::RemoteConfig config;
    config.end.pace = pace;
    config.reach_s = kReach_s;
    auto line = std::make_unique<CutLine>(link::make_line(*link::parse_address(address_)), cut_, connections_);
    line_ = line.get();
    auto made = link::RemoteApplication::connect(std::move(line), prepared_->application->description(), 1, config);
    EXPECT_TRUE(made) << made.error().what.en << board_->last_words().en;
    return made ? std::move(*made) : nullptr;
  }
  static std::vector<double> sense(link::RemoteApplication& robot) {
    std::vector<SenseFrame> frames = {make_sense_frame(robot.description())};
    robot.sense(frames);
    EXPECT_EQ(robot.failure(), nullptr) << robot.failure()->what.en;
    return frames.front().values;
  }

  std::unique_ptr<link::Program> board_;
  std::string address_;
  std::optional<Prepared> prepared_;
  link::Line* line_ = nullptr;  // of the robot that was connected last
  bool cut_ = false;
  int connections_ = 0;
};

TEST_F(EmulatedRobot, CrossesItsCorridorUnderNimrodsController) {
  ASSERT_NE(connect(link::wire::LOCK_STEP), nullptr);  // the board has begun
  const auto result = run(*prepared_, {.seed = 1});
  ASSERT_TRUE(result) << result.error().what.en;
  EXPECT_EQ(result->verdict, Verdict::NotJudged) << "its experiment names no criterion";
  EXPECT_EQ(result->reason.en, "duration over");
  const auto watcher = connect(link::wire::LOCK_STEP);
  ASSERT_NE(watcher, nullptr);
  const std::vector<double> values = sense(*watcher);
  EXPECT_GE(values[kX], 4.0) << "the far side";
  EXPECT_EQ(values[kContacts], 0);
}

TEST_F(EmulatedRobot, HitsAWallWhenItIsOnlyDrivenStraightOn) {
  const auto robot = connect(link::wire::LOCK_STEP);
  ASSERT_NE(robot, nullptr);
  std::vector<ActFrame> act = {make_act_frame(robot->description())};
  act.front().values = {0.475, 0.5};  // its right track is the weaker one
  for (int tick = 0; tick < 200 && robot->failure() == nullptr; ++tick) robot->step(act, 0.1);
  EXPECT_GE(sense(*robot)[kContacts], 1);
}

TEST_F(EmulatedRobot, StopsByItselfOnceItsLineIsCut) {
  const auto robot = connect(link::wire::FREE_RUNNING);
  ASSERT_NE(robot, nullptr);
  std::vector<ActFrame> act = {make_act_frame(robot->description())};
  act.front().values = {0.5, 0.5};
  constexpr double kTtl_s = 0.25;
  act.front().ttl_s = {kTtl_s};
  for (int tick = 0; tick < 1000 && sense(*robot)[kX] < 0.05; ++tick) robot->step(act, 0.1);
  std::vector<double> values = sense(*robot);
  ASSERT_GE(values[kX], 0.05) << "it drives";
  ASSERT_EQ(values[kStoppedAfter], 0) << "without a stop until now";
  robot->step(act, 0.1);
  cut_ = true;
  for (int tick = 0; tick < 100 && values[kStoppedAfter] == 0; ++tick) values = sense(*robot);
  EXPECT_EQ(connections_, 2) << "its session went on over a new connection";
  // The board counts whole milliseconds, from just after the command's arrival; an emulator that has to wait for its
  // processor lets the board's clock run on meanwhile.
  EXPECT_GE(values[kStoppedAfter], kTtl_s - 0.002);
  EXPECT_LE(values[kStoppedAfter], 2 * kTtl_s) << "by the board's own clock";
  RecordProperty("stopped_after_s", fmt::format("{}", values[kStoppedAfter]));
  fmt::print("stopped {:.3f} s after its last command, which held for {} s\n", values[kStoppedAfter], kTtl_s);
  const double stands_m = sense(*robot)[kX];
  sense(*robot);
  EXPECT_EQ(sense(*robot)[kX], stands_m);
}

/// Bytes that follow no rule, without a pause: the board takes at least 100 instructions, 6.4 us, for each.
std::string noise() {
  std::string bytes(std::size_t{128} << 10, '\0');
  for (std::size_t n = 0; n < bytes.size(); ++n) bytes[n] = static_cast<char>(n % 251 * n % 17);
  return bytes;
}

TEST_F(EmulatedRobot, StopsInTimeWhileItsLineCarriesBytesWithoutPause) {
  const auto robot = connect(link::wire::FREE_RUNNING);
  ASSERT_NE(robot, nullptr);
  std::vector<ActFrame> act = {make_act_frame(robot->description())};
  act.front().values = {0.5, 0.5};
  constexpr double kTtl_s = 0.25, kLate_s = 0.05;
  act.front().ttl_s = {kTtl_s};
  for (int tick = 0; tick < 1000 && sense(*robot)[kX] < 0.05; ++tick) robot->step(act, 0.1);
  std::vector<double> values = sense(*robot);
  ASSERT_EQ(values[kStoppedAfter], 0) << "without a stop until now";
  robot->step(act, 0.1);
  const std::string bytes = noise();
  ASSERT_TRUE(line_->send(bytes, line_->now_s() + 60));
  for (int tick = 0; tick < 100 && values[kStoppedAfter] == 0; ++tick) values = sense(*robot);
  EXPECT_GE(values[kStoppedAfter], kTtl_s - 0.002);
  EXPECT_LE(values[kStoppedAfter], kTtl_s + kLate_s) << "by the board's own clock";
  fmt::print("stopped {:.3f} s after its last command, which held for {} s\n", values[kStoppedAfter], kTtl_s);
}

}  // namespace
}  // namespace ganglion
