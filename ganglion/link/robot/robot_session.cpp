#include <algorithm>
#include <limits>

#include "ganglion/base/text.h"
#include "ganglion/link/robot/robot_end.h"

// Who commands, and what becomes of the commands.
namespace ganglion::link {
namespace {

constexpr double kNoLimit_s = std::numeric_limits<double>::infinity();
constexpr double kMaxStep_s = 3600;  // of all ticks of a Step

}  // namespace

void RobotEnd::greet(PeerId id, Peer& peer, double now_s) {
  if (peer.accepted() && peer.carrier == Carrier::Stream) {
    return refuse(peer, wire::BROKEN,
                  say({"Hello is said once in a connection", "Hello se dice una sola vez en una conexión"}));
  }
  const bool again = commands(id);  // over a serial line, which was unplugged or whose controller was started again
  if (again) {
    work_.reset();
    session_->peer.reset();
    session_->lost_s = now_s;
    peer.state = Peer::State::New;
  }
  peer.writer.emplace(peer.carrier, *peer.reader.encoding());
  peer.floats = in_.hello.floats();
  peer.truth = in_.hello.truth();
  peer.told = {};
  const bool resumed = !in_.hello.token().empty();
  if (!admit(id, peer, again, now_s)) return;
  wire::Hello answer;
  answer.set_major(1);
  answer.set_minor(1);
  answer.set_name(config_.name);
  answer.set_last_tick(robot_.tick());
  answer.set_resumed(resumed && peer.state == Peer::State::Commanding);
  if (peer.state == Peer::State::Commanding) answer.set_token(session_->token);
  send(peer, answer);
  wire::Describe describe = robot_.describe();
  describe.set_lock_step(config_.lock_step);
  describe.set_free_running(config_.free_running);
  send(peer, describe);
  send_sense(peer, true);
}

bool RobotEnd::admit(PeerId id, Peer& peer, bool again, double now_s) {
  if (in_.hello.major() != 1) {
    refuse(peer, wire::VERSION,
           say({"this robot speaks protocol 1.0, not {}.{}: use a controller of the same major version",
                "este robot habla el protocolo 1.0, no el {}.{}: use un controlador de la misma versión mayor"},
               in_.hello.major(), in_.hello.minor()));
    return false;
  }
  if (in_.hello.role() == wire::WATCH) {
    const auto watching = std::count_if(peers_.begin(), peers_.end(),
                                        [](const auto& one) { return one.second.state == Peer::State::Watching; });
    if (static_cast<std::size_t>(watching) >= config_.max_watchers) {
      refuse(peer, wire::TOO_MANY,
             say({"no more than {} may watch", "no pueden mirar más de {}"}, config_.max_watchers));
      return false;
    }
    peer.state = Peer::State::Watching;
    return true;
  }
  const bool able = in_.hello.pace() == wire::LOCK_STEP ? config_.lock_step : config_.free_running;
  if (!able) {
    refuse(peer, wire::REFUSED,
           say({"this robot cannot go {}; ask for the other pace", "este robot no puede ir {}; pida el otro ritmo"},
               in_.hello.pace() == wire::LOCK_STEP ? Text{"in lock-step", "paso a paso"}
                                                   : Text{"free-running", "a su propio ritmo"}));
    return false;
  }
  return in_.hello.token().empty() ? begin(id, peer, again, now_s) : resume(id, peer, now_s);
}

bool RobotEnd::resume(PeerId id, Peer& peer, double now_s) {
  if (!session_ || session_->token != in_.hello.token()) {
    refuse(peer, wire::NO_SESSION,
           session_
               ? say({"that session is over: {} commands the robot now", "esa sesión terminó: ahora {} manda el robot"},
                     session_->name)
               : say({"that session is over: the robot was started again, or told goodbye",
                      "esa sesión terminó: el robot se reinició o alguien se despidió de él"}));
    return false;
  }
  if (session_->peer && session_->peer != id) {
    refuse(peers_.at(*session_->peer), wire::REPLACED,
           say({"the session goes on over another connection", "la sesión sigue por otra conexión"}));
  }
  work_.reset();
  session_->peer = id;
  session_->heard_s = now_s;
  peer.state = Peer::State::Commanding;
  peer.reader.limit(kMaxFrameBytes);
  log(say({"{} is back from {}", "{} vuelve desde {}"}, session_->name, peer.name));
  return true;
}

bool RobotEnd::place_free(double now_s) const noexcept {
  if (!session_) return true;
  if (!session_->peer) return now_s - session_->lost_s >= config_.free_after_s;
  return now_s - session_->heard_s >= (session_->commanded ? config_.silent_after_s : config_.free_after_s);
}

bool RobotEnd::begin(PeerId id, Peer& peer, bool again, double now_s) {
  if (!again && !place_free(now_s)) {
    refuse(peer, wire::BUSY,
           say({"{} commands this robot: watch (role WATCH), or come back when it is done",
                "{} manda este robot: mire (papel WATCH), o vuelva cuando acabe"},
               session_->name));
    return false;
  }
  if (session_ && session_->peer) {
    refuse(peers_.at(*session_->peer), wire::REPLACED,
           say({"silent for too long: another controller took the place",
                "demasiado tiempo en silencio: otro controlador tomó el lugar"}));
  }
  Session session;
  // A Hello that is repeated since our answer was lost asks for the same session, whichever answer arrives.
  session.token = again && !session_->commanded ? session_->token : config_.token();
  session.name = in_.hello.name().empty() ? peer.name : printable(in_.hello.name(), 100);
  session.pace = in_.hello.pace();
  session.peer = id;
  session.heard_s = now_s;
  session_ = std::move(session);
  work_.reset();
  peer.state = Peer::State::Commanding;
  peer.reader.limit(kMaxFrameBytes);
  robot_.take_safe_values();
  if (session_->pace == wire::FREE_RUNNING && !running_) next_tick_s_ = now_s + robot_.description().tick_s;
  running_ = session_->pace == wire::FREE_RUNNING;
  log(say({"{} commands from {}", "{} manda desde {}"}, session_->name, peer.name));
  return true;
}

void RobotEnd::command(FrameKind kind, Peer& peer, double now_s) {
  session_->commanded = true;
  if (kind == FrameKind::Reset) return reset(peer);
  if (kind == FrameKind::Act) return act(peer, now_s);
  if (session_->pace == wire::FREE_RUNNING) {
    return refuse(peer, wire::BROKEN,
                  say({"Step is for lock-step: a free-running robot has a clock of its own",
                       "Step es para ir paso a paso: un robot que va a su propio ritmo tiene su propio reloj"}));
  }
  step(peer, now_s);
}

double RobotEnd::longest_step_s() const noexcept {
  return std::min(kMaxStep_s, std::max(config_.longest_step_s, robot_.description().tick_s));
}

bool RobotEnd::due(std::uint32_t tick, double& step_s, Peer& peer) {
  if (tick < robot_.tick()) {  // it was carried out, the answer got lost
    send_sense(peer, true);
    return false;
  }
  if (tick > robot_.tick()) {
    refuse(
        peer, wire::BROKEN,
        say({"a command for tick {}, but the robot is at {}", "un mando para el ciclo {}, pero el robot va por el {}"},
            tick, robot_.tick()));
    return false;
  }
  if (step_s == 0) step_s = robot_.description().tick_s;
  if (!(step_s > 0 && step_s <= longest_step_s())) {
    refuse(peer, wire::BROKEN,
           say({"step_s is {}, must be > 0 and at most {}", "step_s es {}, debe ser > 0 y como máximo {}"},
               shortest(step_s), shortest(longest_step_s())));
    return false;
  }
  return true;
}

void RobotEnd::act(Peer& peer, double now_s) {
  double step_s = in_.act.step_s();
  const bool lock_step = session_->pace == wire::LOCK_STEP;
  if (lock_step && !due(in_.act.tick(), step_s, peer)) return;
  if (!lock_step && session_->acted && in_.act.tick() <= *session_->acted) return;
  if (auto taken = robot_.take(in_.act, lock_step ? kNoLimit_s : config_.max_ttl_s); !taken) {
    return refuse(peer, wire::BROKEN, taken.error().what);
  }
  session_->acted = in_.act.tick();
  session_->aged_s = now_s;
  session_->fresh = true;
  if (!lock_step) return;
  robot_.step(step_s);
  send_sense(peer, false);
  watch();
}

void RobotEnd::step(Peer& peer, double now_s) {
  double step_s = in_.step.step_s();
  const std::uint32_t ticks = in_.step.ticks();
  if (ticks < 1 || ticks > 1000) {
    return refuse(
        peer, wire::BROKEN,
        say({"Step asks for {} ticks, must be 1 to 1000", "Step pide {} ciclos, deben ser de 1 a 1000"}, ticks));
  }
  if (!due(in_.step.tick(), step_s, peer)) return;
  if (ticks * step_s > kMaxStep_s) {
    return refuse(peer, wire::BROKEN,
                  say({"Step asks for {} ticks of {} s, must be at most {} s in all",
                       "Step pide {} ciclos de {} s, deben ser como máximo {} s en total"},
                      ticks, shortest(step_s), shortest(kMaxStep_s)));
  }
  earlier_.clear_earlier();
  work_ = Work{ticks, step_s};
  carry_on(peer, now_s);
}

void RobotEnd::carry_on(Peer& peer, double now_s) {
  session_->heard_s = now_s;  // it waits for us
  double left_s = longest_step_s();
  do {
    robot_.step(work_->step_s);
    left_s -= work_->step_s;
    if (--work_->ticks_left > 0) robot_.write(peer.floats, *earlier_.add_earlier());
    watch();
  } while (work_->ticks_left > 0 && work_->step_s <= left_s);
  if (work_->ticks_left > 0) return;
  work_.reset();
  sense_.mutable_earlier()->Swap(earlier_.mutable_earlier());
  send_sense(peer, false);
  sense_.clear_earlier();
}

void RobotEnd::reset(Peer& peer) {
  if (auto done = robot_.reset(in_.reset.seed(), in_.reset.episode()); !done) {
    return refuse(peer, wire::REFUSED,
                  say({"the robot cannot be reset: {}", "el robot no se puede reiniciar: {}"}, done.error().what));
  }
  session_->acted.reset();
  for (auto& [id, other] : peers_) other.told = {};
  send(peer, in_.reset);
  send_sense(peer, true);
  watch();
}

void RobotEnd::run_tick(double now_s) {
  const double tick_s = robot_.description().tick_s;
  if (session_ && session_->acted) {
    robot_.age_commands(std::max(0.0, now_s - session_->aged_s), session_->fresh ? tick_s : 0);
    session_->aged_s = now_s + tick_s;  // the step itself takes its part
    session_->fresh = false;
  }
  robot_.step(tick_s);
  if (session_ && session_->peer) send_sense(peers_.at(*session_->peer), false);
  watch();
}

void RobotEnd::end_session(const Sentence& why) {
  work_.reset();
  robot_.take_safe_values();
  log(say({"session ended: {}", "la sesión terminó: {}"}, why));
  session_.reset();
  ++sessions_ended_;
}

}  // namespace ganglion::link
