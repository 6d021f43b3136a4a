#pragma once

#include <functional>
#include <map>

#include "ganglion/link/robot/linked_robot.h"
#include "ganglion/link/robot/peer.h"

namespace ganglion::link {

struct RobotEndConfig {
  std::string name = "ganglion";  ///< Of the program, in its Hello.
  std::size_t max_peers = 256;
  std::size_t max_watchers = 32;
  double handshake_s = 5;      ///< For a connection to say Hello.
  double unread_s = 10;        ///< For it to read what it was sent.
  double max_ttl_s = 0.5;      ///< Of commands in free-running.
  double free_after_s = 1;     ///< From a broken connection until somebody else may command.
  double silent_after_s = 10;  ///< The same from the last word of a connection that stands.
  /// Of one step [s], or tick_s where that is longer: in its time nothing else is looked at.
  double longest_step_s = 3600;
  bool lock_step = true;
  bool free_running = true;
  std::function<std::string()> token;        ///< Makes the token of a session.
  std::function<void(const Sentence&)> log;  ///< What happens, one line each.
  std::function<double()> clock;             ///< Asked within a long receive(); none: its now_s has to do.
};

/// The robot's end of the link: an application, whoever talks to it, and the rules of docs/link.md. It knows no socket
/// and no clock: bytes and the time are arguments, so that the same object serves TCP, serial lines and tests.
///
/// Whatever peers send, no more than kMostFrames frames and kMostBytes bytes are taken from them between two looks at
/// what is due, which are calls of poll(), its own included; a Step is carried out in slices, one in each.
class RobotEnd {
 public:
  using PeerId = std::uint32_t;
  static constexpr std::uint32_t kMostFrames = 64;
  static constexpr std::size_t kMostBytes = std::size_t{64} << 10;
  /// The application outlives it; it has been reset.
  RobotEnd(Application& application, RobotEndConfig config);

  /// A connection came. Serial lines are one connection that never ends: a Hello begins it anew.
  PeerId open(Carrier carrier, std::string name, double now_s);
  void receive(PeerId peer, std::string_view bytes, double now_s);
  /// A connection broke, or was closed as asked.
  void lost(PeerId peer, double now_s);

  /// What is to be sent, and how much of it was.
  std::string_view outgoing(PeerId peer) const;
  void sent(PeerId peer, std::size_t bytes, double now_s);
  /// Whether it is the one who commands.
  bool commands(PeerId peer) const noexcept { return session_ && session_->peer == peer; }
  /// Whether what it asked for is still being carried out: then it is not to be read.
  bool waits(PeerId peer) const noexcept { return work_ && commands(peer); }
  /// Once nothing is outgoing, the connection is to be closed.
  bool closing(PeerId peer) const;
  /// The connection is to be closed whatever is outgoing.
  bool gone(PeerId peer) const;
  /// Those to look at since the last call: something is outgoing, or they are to be closed.
  /// Valid until the next call.
  std::span<const PeerId> take_stirred();

  /// Time passes: ticks of a free-running robot, deadlines. Next needed at due_s().
  void poll(double now_s);
  double due_s() const;
  /// Everybody is told, and the robot takes its safe values.
  void shut_down(const Sentence& reason, double now_s);

  const LinkedRobot& robot() const noexcept { return robot_; }
  /// What was taken from peers.
  struct Taken {
    std::uint32_t frames = 0;
    std::size_t bytes = 0;
  };
  /// The most between two looks until now.
  const Taken& most_taken() const noexcept { return most_taken_; }
  /// How many controllers have left in order, or were made to.
  std::uint32_t sessions_ended() const noexcept { return sessions_ended_; }

 private:
  struct Session {
    std::string token;
    std::string name;
    wire::Pace pace = wire::LOCK_STEP;
    std::optional<PeerId> peer;  // none while its connection is broken
    double heard_s = 0;
    bool commanded = false;  // anything at all
    double lost_s = 0;
    std::optional<std::uint32_t> acted;  // tick of the last Act in free-running
    double aged_s = 0;                   // and until when its age is counted
    bool fresh = false;                  // it was not yet carried out
  };
  /// A Step that was begun.
  struct Work {
    std::uint32_t ticks_left = 0;
    double step_s = 0;
  };
  void take(std::uint32_t frames, std::size_t bytes, double now_s);
  void read(PeerId id, Peer& peer, double now_s);
  void handle(FrameKind kind, PeerId id, Peer& peer, double now_s);
  void greet(PeerId id, Peer& peer, double now_s);
  bool admit(PeerId id, Peer& peer, bool again, double now_s);
  bool resume(PeerId id, Peer& peer, double now_s);
  bool begin(PeerId id, Peer& peer, bool again, double now_s);
  void command(FrameKind kind, Peer& peer, double now_s);
  void act(Peer& peer, double now_s);
  void step(Peer& peer, double now_s);
  void carry_on(Peer& peer, double now_s);
  double longest_step_s() const noexcept;
  void reset(Peer& peer);
  void look_at_peers(double now_s);
  void run_tick(double now_s);
  void end_session(const Sentence& why);
  /// Whether a step of that length can be carried out at that tick; else the reason, or the answer, is on its way.
  bool due(std::uint32_t tick, double& step_s, Peer& peer);

  template <class Message>
  void send(Peer& peer, const Message& message) {
    if (peer.state == Peer::State::Closing || peer.state == Peer::State::Gone) return;
    peer.forget_sent();
    stir(peer);
    check_sent(peer, peer.writer->append(message, peer.out));
  }
  void stir(Peer& peer);
  void check_sent(Peer& peer, const Result<void>& written);
  void send_sense(Peer& peer, bool everything);
  void watch();
  void refuse(Peer& peer, wire::ByeCode code, const Sentence& reason);
  void log(const Sentence& line) const {
    if (config_.log) config_.log(line);
  }
  bool place_free(double now_s) const noexcept;

  RobotEndConfig config_;
  LinkedRobot robot_;
  std::map<PeerId, Peer> peers_;
  PeerId next_id_ = 1;
  std::vector<PeerId> stirred_, stirred_before_;
  std::uint32_t sessions_ended_ = 0;
  std::optional<Session> session_;
  std::optional<Work> work_;  // of the session's peer
  wire::Sense earlier_;       // the ticks of a Step before its last
  Taken taken_, most_taken_;  // since the last look; ever
  double latest_s_ = 0;       // the last time that anybody told
  double noted_s_;            // when a stranger who was sent away was last logged
  bool running_ = false;      // the robot's own clock goes
  double next_tick_s_ = 0;
  Messages in_;
  wire::Sense sense_;
  wire::Beat beat_;
};

}  // namespace ganglion::link
