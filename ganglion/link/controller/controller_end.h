#pragma once

#include <optional>
#include <span>
#include <string>

#include "ganglion/link/controller/statistics.h"
#include "ganglion/link/wire/codec.h"
#include "ganglion/link/wire/frames.h"

namespace ganglion::link {

struct ControllerEndConfig {
  std::string name = "ganglion";  ///< Of the program, in its Hello.
  Carrier carrier = Carrier::Stream;
  Encoding encoding = Encoding::Binary;
  wire::Pace pace = wire::LOCK_STEP;
  wire::Role role = wire::COMMAND;
  bool floats = false;  ///< Sense may come in single precision.
  bool truth = true;
  double silence_s = 3;    ///< A connection that says nothing for so long is given up.
  double repeat_s = 0.3;   ///< On lines that lose frames: a request is made again after that time.
  double patience_s = 15;  ///< Without an answer the whole link is given up.
  double beat_s = 1;
};

/// The controller's end of the link: one session, over as many connections as it takes (docs/link.md). It knows no
/// socket and no clock; RemoteApplication carries its bytes.
class ControllerEnd {
 public:
  explicit ControllerEnd(ControllerEndConfig config);

  /// A connection stands: says Hello.
  void connected(double now_s);
  void receive(std::string_view bytes, double now_s);
  /// It broke; another one is wanted, unless the session is over.
  void disconnected(double now_s);
  bool wants_connection() const noexcept { return !connected_ && !failure_; }
  /// To be sent; the caller clears what was.
  std::string& outgoing() noexcept { return out_; }
  /// Time passes: repeats, heartbeats, patience. Next needed at due_s().
  void poll(double now_s);
  double due_s() const noexcept;

  /// Requests. Each waits until done() or failure(), and only one at a time.
  void greet(double now_s);
  void reset(std::uint64_t seed, std::uint32_t episode, double now_s);
  void act(std::span<const ActFrame> frames, double step_s, double now_s);
  /// Free-running: a Sense newer than the last one taken; there may be one already.
  void await_sense(double now_s);
  /// The present Sense is used.
  void take_sense() noexcept { taken_ = true; }
  bool done() const noexcept { return waiting_for_ == Wanted::Nothing; }
  /// Last words; nothing is awaited.
  void bye(const Sentence& reason);

  /// What came cannot be used.
  void fail(Sentence reason);
  /// Told as if the robot had told it.
  void warn(const Sentence& remark);
  /// Why the link is of no more use.
  const std::optional<Error>& failure() const noexcept { return failure_; }
  const wire::Describe& describe() const noexcept { return describe_; }
  /// The last one that counts.
  const wire::Sense& sense() const noexcept { return sense_; }
  /// Told by the robot since the last call.
  std::vector<wire::Event> take_events();
  const LinkStatistics& statistics() const noexcept { return statistics_; }
  std::uint32_t beats_answered() const noexcept { return beats_answered_; }
  const std::string& robot_program() const noexcept { return robot_program_; }

 private:
  enum class Wanted : std::uint8_t { Nothing, Greeting, ResetEcho, ResetSense, Answer, NewerSense };
  void handle(FrameKind kind, double now_s);
  void heard_hello();
  void heard_describe();
  /// A robot whose ticks lie behind ours again and again began anew, and did not say so.
  bool began_anew(std::uint32_t tick) noexcept;
  /// Why nothing was answered.
  Sentence silence() const;
  void heard_sense(double now_s);
  void heard_bye(double now_s);
  void heard_beat(double now_s);
  void want(Wanted what, double now_s);
  void ask_again(double now_s);
  void beat(double now_s);
  void answered(double now_s);
  /// When this connection is given up, if nothing comes.
  double silent_s() const noexcept;
  template <class Message>
  void send(const Message& message) {
    if (auto written = writer_.append(message, out_); !written) fail(written.error().what);
  }

  ControllerEndConfig config_;
  FrameReader reader_;
  FrameWriter writer_;
  Messages in_;
  std::string out_;
  bool connected_ = false;
  bool welcomed_ = false;   // its Hello came over this connection
  bool greeted_ = false;    // Hello, Describe and the first Sense came over this connection
  bool described_ = false;  // over this connection
  Wanted waiting_for_ = Wanted::Nothing;
  std::string token_;
  std::string robot_program_;
  bool floats_ = false;  // the robot takes no doubles
  wire::Describe describe_;
  std::string description_;  // its bytes, as the first connection told it
  wire::Sense sense_;
  wire::Reset reset_;
  wire::Act act_;
  wire::Beat beat_;
  std::uint32_t beats_answered_ = 0;
  std::uint32_t wanted_tick_ = 0;
  std::uint32_t older_tick_ = 0;  // of the last Sense that lies behind ours
  int older_ = 0;                 // how many there were, one after the other
  double asked_s_ = 0;            // when the present request was made
  double sent_s_ = 0;             // when it was last made over this connection
  double heard_s_ = 0;            // the last byte
  double beat_s_ = 0;             // of the last Beat
  bool repeated_ = false;
  bool taken_ = false;  // the present Sense
  Sentence misread_;    // of the last packet since an answer that was whole, and could not be read
  std::vector<wire::Event> events_;
  std::optional<Error> failure_;
  LinkStatistics statistics_;
};

}  // namespace ganglion::link
