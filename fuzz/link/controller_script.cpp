// The controller's end, as an application: whatever says it is a robot.
#include <algorithm>
#include <cmath>

#include "fuzz/link/ends.h"
#include "fuzz/target.h"
#include "ganglion/link/testing/bench.h"

namespace ganglion::fuzz {
namespace {

constexpr int kTicks = 40;
constexpr double kLongestCall_s = 15 + 3 + 1;  // patience, and one more connection

/// A line whose other side says what is written, whatever is said to it.
class ScriptLine final : public link::Line {
 public:
  ScriptLine(const Script& script, const Dialect& dialect) : script_(script), dialect_(dialect) {}

  link::Carrier carrier() const noexcept override { return dialect_.carrier; }
  const std::string& address() const noexcept override { return address_; }
  double now_s() noexcept override { return now_s_; }
  Result<void> connect(double) override {
    if (next_ >= script_.pieces.size()) return fail(ErrorCode::LinkLost, {"nothing answers", "nada responde"});
    said_ = link::FrameReader(dialect_.carrier);
    open_ = true;
    return {};
  }
  void close() noexcept override { open_ = false; }
  Result<void> send(std::string_view bytes, double) override {
    if (!open_) return fail(ErrorCode::LinkLost, {"broken", "roto"});
    said_.feed(bytes);
    for (;;) {
      const auto payload = said_.next();
      must(payload.has_value(), "what a controller says is framed");
      if (!*payload) return {};
      const auto kind = link::decode(**payload, *said_.encoding(), messages_);
      must(kind.has_value(), "what a controller says can be read");
      if (*kind == link::FrameKind::Act) check_act();
    }
  }
  Result<std::size_t> receive(std::span<char> room, double until_s) override {
    if (!open_) return fail(ErrorCode::LinkLost, {"broken", "roto"});
    now_s_ += 1e-6;
    if (next_ >= script_.pieces.size()) return silence(until_s);
    const Script::Piece& piece = script_.pieces[next_];
    const double at_s = said_s_ + kWait_s * piece.wait;
    if (at_s > std::max(now_s_, until_s)) return silence(until_s);
    now_s_ = std::max(now_s_, at_s);
    if (piece.bytes.empty()) {
      advance();
      open_ = false;
      return fail(ErrorCode::LinkLost, {"hung up", "colgó"});
    }
    const std::size_t count = std::min(room.size(), piece.bytes.size() - begin_);
    std::copy_n(piece.bytes.begin() + static_cast<std::ptrdiff_t>(begin_), count, room.begin());
    begin_ += count;
    if (begin_ == piece.bytes.size()) advance();
    return count;
  }
  void wait_until(double until_s) override { now_s_ = std::max(now_s_, until_s); }

 private:
  Result<std::size_t> silence(double until_s) {
    now_s_ = std::max(now_s_, until_s);
    return std::size_t{0};
  }
  void advance() {
    ++next_;
    begin_ = 0;
    said_s_ = now_s_;
  }
  /// The commands are decide()'s, within its limits; channels the robot has besides take their safe values.
  void check_act() {
    for (const double value : messages_.act.values()) must(std::isfinite(value), "commands are finite");
    must(messages_.act.ttl_ms() >= 1 && messages_.act.ttl_ms() <= 300, "commands live as long as they were told to");
  }

  const Script& script_;
  const Dialect& dialect_;
  std::string address_ = "script";
  link::FrameReader said_{link::Carrier::Stream};
  link::Messages messages_;
  std::size_t next_ = 0, begin_ = 0;
  double now_s_ = 0, said_s_ = 0;
  bool open_ = false;
};

/// How long a call may last, and that it did not last longer.
class Watch {
 public:
  explicit Watch(link::Line& line) : line_(line), begun_s_(line.now_s()) {}
  ~Watch() { must(line_.now_s() - begun_s_ <= kLongestCall_s, "a call does not last longer than its patience"); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

 private:
  link::Line& line_;
  double begun_s_;
};

void check_sense(const SenseFrame& sense, const std::optional<std::uint32_t>& before, bool lock_step) {
  for (const double value : sense.values) {
    must(value != 0 || !std::signbit(value), "what is sensed is canonical");
  }
  if (!before) return;
  must(lock_step ? sense.tick == *before + 1 : sense.tick > *before, "no tick is sensed twice",
       std::to_string(*before) + " then " + std::to_string(sense.tick));
}

void drive(link::RemoteApplication& remote, link::Line& line, bool lock_step) {
  {
    const Watch watch(line);
    if (!remote.reset(7, 0)) return;
  }
  std::vector<SenseFrame> sense(2, make_sense_frame(remote.description()));
  std::vector<ActFrame> act(2, make_act_frame(remote.description()));
  std::optional<std::uint32_t> before;
  for (int tick = 0; tick < kTicks; ++tick) {
    const Watch watch(line);
    remote.sense(sense);
    if (remote.failure() != nullptr) return;
    for (std::size_t n = 0; n < sense.size(); ++n) {
      check_sense(sense[n], before, lock_step);
      for (double& value : sense[n].values) value = std::isfinite(value) ? std::clamp(value, -1.0, 1.0) : 0;
      link::decide(sense[n], act[n]);
    }
    before = sense[0].tick;
    remote.step(act, 0.1);
    if (remote.failure() != nullptr) return;
  }
}

}  // namespace

void talk_to_controller(const Script& script, const Dialect& dialect) {
  auto made = std::make_unique<ScriptLine>(script, dialect);
  link::Line& line = *made;
  const link::NotebookRobot robot(2);
  link::RemoteConfig config;
  config.end.encoding = dialect.encoding;
  config.end.pace = script.free_running ? link::wire::FREE_RUNNING : link::wire::LOCK_STEP;
  auto remote = link::RemoteApplication::connect(std::move(made), robot.description(), 2, config);
  if (!remote) {
    must(!remote.error().what.empty(), "a link that cannot be has a reason");
    return;
  }
  drive(**remote, line, !script.free_running);
  static_cast<void>((*remote)->take_events());
}

}  // namespace ganglion::fuzz
