#include "ganglion/link/robot/robot_end.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "ganglion/base/expects.h"
#include "ganglion/base/text.h"
#include "ganglion/link/wire/words.h"

namespace ganglion::link {
namespace {

constexpr std::size_t kEnoughPendingBytes = std::size_t{64} << 10;  // then a slow reader misses frames
constexpr int kRefusedAtOnce = 8;
constexpr std::size_t kMaxPendingBytes = std::size_t{3} << 20;  // then it is dropped
constexpr double kNoteEvery_s = 1;  // of strangers who are sent away, so that a log does not fill by them
constexpr double kInf = std::numeric_limits<double>::infinity();

}  // namespace

RobotEnd::RobotEnd(Application& application, RobotEndConfig config)
    : config_(std::move(config)), robot_(application), noted_s_(-kInf) {
  expects(config_.token != nullptr);
}

RobotEnd::PeerId RobotEnd::open(Carrier carrier, std::string name, double now_s) {
  const PeerId id = next_id_++;
  latest_s_ = now_s;
  Peer& peer = peers_.try_emplace(id, id, carrier, std::move(name), now_s).first->second;
  if (peers_.size() > config_.max_peers) {
    refuse(peer, wire::TOO_MANY,
           say({"no more than {} connections; try again later", "no más de {} conexiones; pruebe más tarde"},
               config_.max_peers));
  }
  return id;
}

void RobotEnd::receive(PeerId id, std::string_view bytes, double now_s) {
  const auto found = peers_.find(id);
  if (found == peers_.end()) return;
  Peer& peer = found->second;
  if (session_ && session_->peer == id) session_->heard_s = now_s;
  latest_s_ = now_s;
  while (!bytes.empty() && peer.state != Peer::State::Closing && peer.state != Peer::State::Gone) {
    const std::string_view piece = bytes.substr(0, kMostBytes);
    take(0, piece.size(), now_s);
    peer.reader.feed(piece);
    bytes.remove_prefix(piece.size());
    read(id, peer, now_s);
  }
}

void RobotEnd::take(std::uint32_t frames, std::size_t bytes, double now_s) {
  if (taken_.frames + frames > kMostFrames || taken_.bytes + bytes > kMostBytes) {
    poll(config_.clock ? config_.clock() : now_s);
  }
  taken_.frames += frames;
  taken_.bytes += bytes;
  most_taken_.frames = std::max(most_taken_.frames, taken_.frames);
  most_taken_.bytes = std::max(most_taken_.bytes, taken_.bytes);
}

void RobotEnd::read(PeerId id, Peer& peer, double now_s) {
  while (!waits(id)) {
    const auto payload = peer.reader.next();
    if (!payload) return refuse(peer, wire::BROKEN, payload.error().what);
    if (!*payload) return;
    take(1, 0, now_s);
    if (peer.state == Peer::State::Closing || peer.state == Peer::State::Gone) return;
    const auto kind = decode(**payload, *peer.reader.encoding(), in_);
    if (kind) {
      handle(*kind, id, peer, now_s);
    } else if (peer.carrier != Carrier::Packets) {  // else it is damaged in a way that its checksum does not show
      refuse(peer, wire::BROKEN, kind.error().what);
    }
  }
}

void RobotEnd::handle(FrameKind kind, PeerId id, Peer& peer, double now_s) {
  if (kind == FrameKind::Hello) return greet(id, peer, now_s);
  if (!peer.accepted()) {
    // On a serial line, what is left of an earlier connection.
    if (peer.carrier == Carrier::Packets) return;
    return refuse(peer, wire::BROKEN,
                  kind == FrameKind::Unknown ? say({"say Hello first", "diga Hello primero"})
                                             : say({"say Hello before {}", "diga Hello antes de {}"}, name_of(kind)));
  }
  if (kind == FrameKind::Unknown) return;
  switch (kind) {
    case FrameKind::Beat:
      if (in_.beat.answer()) return;
      beat_.set_number(in_.beat.number());
      beat_.set_answer(true);
      beat_.set_time_s(now_s);
      return send(peer, beat_);
    case FrameKind::Bye:
      if (peer.state == Peer::State::Commanding) end_session(say({"{} said bye", "{} se despidió"}, session_->name));
      peer.state = peer.carrier == Carrier::Stream ? Peer::State::Closing : Peer::State::New;
      return stir(peer);
    case FrameKind::Act:
    case FrameKind::Step:
    case FrameKind::Reset:
      if (peer.state == Peer::State::Commanding) return command(kind, peer, now_s);
      return refuse(peer, wire::BROKEN, say({"who watches sends no {}", "quien mira no envía {}"}, name_of(kind)));
    default:
      return refuse(peer, wire::BROKEN, say({"{} is for the robot to send", "{} lo envía el robot"}, name_of(kind)));
  }
}

void RobotEnd::watch() {
  for (auto& [id, peer] : peers_) {
    if (peer.state == Peer::State::Watching) send_sense(peer, false);
  }
}

void RobotEnd::send_sense(Peer& peer, bool everything) {
  const bool awaited = peer.state == Peer::State::Commanding && session_->pace == wire::LOCK_STEP;
  if (!awaited && !everything && peer.pending() > kEnoughPendingBytes) {
    ++peer.skipped;
    return;
  }
  robot_.write(peer.floats, sense_);
  if (everything) peer.told = {};
  if (peer.truth) {
    robot_.write_truth(peer.told, sense_);
  } else {
    LinkedRobot::write_no_truth(sense_);
  }
  send(peer, sense_);
}

void RobotEnd::check_sent(Peer& peer, const Result<void>& written) {
  if (!written) {
    return refuse(peer, wire::REFUSED,
                  say({"{}: let fewer robots share the link", "{}: haga que menos robots compartan el enlace"},
                      written.error().what));
  }
  if (peer.pending() <= kMaxPendingBytes) return;
  if (peer.carrier == Carrier::Packets) {  // nobody at the other end of the cable
    peer.out.clear();
    peer.sent = 0;
    return;
  }
  log(say({"{} does not read what it is sent: closed", "{} no lee lo que se le envía: se cerró"}, peer.name));
  peer.state = Peer::State::Gone;
  stir(peer);
}

void RobotEnd::refuse(Peer& peer, wire::ByeCode code, const Sentence& reason) {
  if (peer.state == Peer::State::Closing || peer.state == Peer::State::Gone) return;
  wire::Bye bye;
  bye.set_code(code);
  write_words(reason, bye);
  const bool commanding = peer.state == Peer::State::Commanding, stranger = peer.state == Peer::State::New;
  peer.state = Peer::State::New;
  // Who has not told an encoding is answered so that a person can read it.
  if (!peer.writer) peer.writer.emplace(peer.carrier, peer.reader.encoding().value_or(Encoding::Json));
  send(peer, bye);
  if (peer.carrier == Carrier::Stream) peer.state = Peer::State::Closing;
  if (!stranger || latest_s_ >= noted_s_ + kNoteEvery_s) {
    if (stranger) noted_s_ = latest_s_;
    log(say({"{}: closed: {}", "{}: se cerró: {}"}, peer.name, read_words(bye)));
  }
  if (commanding && (code == wire::BROKEN || code == wire::REFUSED)) {
    end_session(say({"it broke the rules of the link", "no cumplió las reglas del enlace"}));
  }
}

void RobotEnd::lost(PeerId id, double now_s) {
  if (session_ && session_->peer == id) {
    work_.reset();
    session_->peer.reset();
    session_->lost_s = now_s;
    log(say({"{}: connection lost; safe values once its commands run out",
             "{}: conexión perdida; valores seguros cuando venzan sus mandos"},
            session_->name));
  }
  peers_.erase(id);
}

std::string_view RobotEnd::outgoing(PeerId id) const {
  const auto found = peers_.find(id);
  return found == peers_.end() ? std::string_view{} : std::string_view(found->second.out).substr(found->second.sent);
}

void RobotEnd::sent(PeerId id, std::size_t bytes, double now_s) {
  const auto found = peers_.find(id);
  if (found == peers_.end()) return;
  found->second.sent += bytes;
  if (bytes > 0) found->second.unread_s = now_s;
}

bool RobotEnd::closing(PeerId id) const {
  const auto found = peers_.find(id);
  return found == peers_.end() || found->second.state == Peer::State::Closing;
}

bool RobotEnd::gone(PeerId id) const {
  const auto found = peers_.find(id);
  return found == peers_.end() || found->second.state == Peer::State::Gone;
}

std::span<const RobotEnd::PeerId> RobotEnd::take_stirred() {
  stirred_before_.swap(stirred_);
  stirred_.clear();
  for (const PeerId id : stirred_before_) {
    if (const auto found = peers_.find(id); found != peers_.end()) found->second.stirred = false;
  }
  return stirred_before_;
}

void RobotEnd::stir(Peer& peer) {
  if (!peer.stirred) stirred_.push_back(peer.id);
  peer.stirred = true;
}

void RobotEnd::poll(double now_s) {
  taken_ = {};
  latest_s_ = now_s;
  look_at_peers(now_s);
  if (running_) {
    const double tick_s = robot_.description().tick_s;
    if (now_s - next_tick_s_ > 1) next_tick_s_ = now_s;  // the program was stopped, or cannot keep up
    for (; next_tick_s_ <= now_s; next_tick_s_ += tick_s) run_tick(now_s);
  }
  if (!work_) return;
  const PeerId id = *session_->peer;
  Peer& peer = peers_.at(id);
  carry_on(peer, now_s);
  read(id, peer, now_s);  // what it sent meanwhile
}

void RobotEnd::look_at_peers(double now_s) {
  int refused = 0;
  for (auto& [id, peer] : peers_) {
    if (peer.carrier == Carrier::Packets) continue;
    const bool late = peer.state == Peer::State::New && now_s >= peer.opened_s + config_.handshake_s;
    if (late && refused++ < kRefusedAtOnce) {  // the rest in the next call, so that a tick need not wait
      refuse(peer, wire::TOO_SLOW,
             say({"no Hello within {} s", "ningún Hello en {} s"}, shortest(config_.handshake_s)));
    }
    if (peer.pending() == 0) peer.unread_s = now_s;
    if (now_s < peer.unread_s + config_.unread_s) continue;
    peer.state = Peer::State::Gone;
    stir(peer);
  }
}

double RobotEnd::due_s() const {
  if (work_) return -kInf;
  double due_s = running_ ? next_tick_s_ : kInf;
  for (const auto& [id, peer] : peers_) {
    if (peer.carrier == Carrier::Packets || peer.state == Peer::State::Gone) continue;
    if (peer.state == Peer::State::New) {
      due_s = std::min(due_s, peer.opened_s + config_.handshake_s);
    }
    if (peer.pending() > 0) due_s = std::min(due_s, peer.unread_s + config_.unread_s);
  }
  return due_s;
}

void RobotEnd::shut_down(const Sentence& reason, double) {
  for (auto& [id, peer] : peers_) refuse(peer, wire::SHUTDOWN, reason);
  if (session_) end_session(reason);
  running_ = false;
}

}  // namespace ganglion::link
