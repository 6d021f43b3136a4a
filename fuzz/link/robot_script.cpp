// The robot's end: whatever is said to it, its robot keeps the rules of time.
#include "fuzz/link/ends.h"

#include <algorithm>
#include <optional>

#include "fuzz/target.h"
#include "ganglion/link/fault/frame_cutter.h"
#include "ganglion/link/testing/bench.h"
#include "ganglion/link/testing/watched_robot.h"

namespace ganglion::fuzz {
namespace {

constexpr std::size_t kMostKept = std::size_t{5} << 20;
constexpr int kMostPolls = 100'000;
constexpr double kAfter_s = 3;

#ifdef GANGLION_PLANTED_BUG
/// "A command that is withdrawn for a reason nobody knows, from 16, has no end."
class Stubborn final : public Application {
 public:
  explicit Stubborn(Application& inner) : inner_(inner) {}
  const Description& description() const noexcept override { return inner_.description(); }
  int robots() const noexcept override { return inner_.robots(); }
  Result<void> reset(std::uint64_t seed, std::uint32_t episode) override {
    kept_.clear();
    return inner_.reset(seed, episode);
  }
  void sense(std::span<SenseFrame> frames) noexcept override { inner_.sense(frames); }
  void step(std::span<const ActFrame> frames, double step_s) noexcept override {
    const bool unknown = std::any_of(frames.begin(), frames.end(), [](const ActFrame& frame) {
      return frame.origins[0] == CommandOrigin::Withdrawn && frame.reasons[0] >= 16;
    });
    if (unknown) kept_.assign(frames.begin(), frames.end());
    for (ActFrame& frame : kept_) frame.tick = frames[0].tick;
    inner_.step(kept_.empty() ? frames : std::span<const ActFrame>(kept_), step_s);
  }

 private:
  Application& inner_;
  std::vector<ActFrame> kept_;
};
using Driven = Stubborn;
#else
using Driven = link::WatchedRobot&;
#endif

class Listening {
 public:
  Listening(const Script& script, const Dialect& dialect)
      : script_(script),
        dialect_(dialect),
        watched_(robot_, script.free_running ? link::wire::FREE_RUNNING : link::wire::LOCK_STEP,
                 [this] { return now_s_; }),
        driven_(watched_),
        cutter_(dialect.carrier) {
    must(driven_.reset(1, 0).has_value(), "the first reset succeeds");
    end_.emplace(driven_, config());
  }

  void run() {
    for (const Script::Piece& piece : script_.pieces) {
      pass(now_s_ + kWait_s * piece.wait);
      piece.bytes.empty() ? hang_up() : hear(piece.bytes);
    }
    hang_up();
    pass(now_s_ + kAfter_s);
  }

 private:
  link::RobotEndConfig config() const {
    link::RobotEndConfig config = link::robot_config();
    config.lock_step = !script_.free_running;
    config.free_running = script_.free_running;
    return config;
  }
  void check() const {
    must(watched_.broken().empty(), "the rules of time hold", watched_.broken());
    if (peer_) must(end_->outgoing(*peer_).size() <= kMostKept, "who does not read is not written to for ever");
  }
  /// Time passes, and the end is told whenever it asked for it.
  void pass(double until_s) {
    int polls = 0;
    while (now_s_ < until_s) {
      now_s_ = std::min(until_s, std::max(now_s_ + 1e-6, end_->due_s()));
      end_->poll(now_s_);
      look();
      must(++polls < kMostPolls, "an end that is told the time does not ask for it again and again");
    }
  }
  /// Takes what the end says, and its closing.
  void look() {
    check();
    if (!peer_) return;
    if (!script_.deaf) end_->sent(*peer_, end_->outgoing(*peer_).size(), now_s_);
    if (end_->gone(*peer_) || end_->closing(*peer_)) hang_up();
  }
  void hang_up() {
    if (!peer_ || dialect_.carrier == link::Carrier::Packets) return;
    cutter_ = link::FrameCutter(dialect_.carrier);
    end_->lost(*peer_, now_s_);
    peer_.reset();
    ++connection_;
  }
  /// Frame by frame, so that the model knows when each was heard.
  void hear(std::string_view bytes) {
    if (!peer_) peer_ = end_->open(dialect_.carrier, "fuzzer", now_s_);
    cutter_.feed(bytes);
    while (peer_) {
      const auto frame = cutter_.next();
      if (!frame) return;
      watched_.heard(connection_, dialect_.carrier, *frame);
      end_->receive(*peer_, *frame, now_s_);
      look();
    }
  }

  const Script& script_;
  const Dialect& dialect_;
  double now_s_ = 0;
  link::NotebookRobot robot_{2};
  link::WatchedRobot watched_;
  Driven driven_;
  std::optional<link::RobotEnd> end_;
  std::optional<link::RobotEnd::PeerId> peer_;
  std::uint32_t connection_ = 0;
  link::FrameCutter cutter_;
};

}  // namespace

void talk_to_robot(const Script& script, const Dialect& dialect) { Listening(script, dialect).run(); }

}  // namespace ganglion::fuzz
