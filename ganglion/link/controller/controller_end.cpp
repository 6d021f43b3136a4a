#include "ganglion/link/controller/controller_end.h"

#include <algorithm>
#include <limits>

#include "ganglion/base/expects.h"
#include "ganglion/base/text.h"
#include "ganglion/link/wire/description.h"
#include "ganglion/link/wire/words.h"

namespace ganglion::link {
namespace {

constexpr std::size_t kMaxEvents = 100;  // kept until somebody takes them
constexpr int kBeganAnew = 3;            // Senses that lie behind ours, one after the other
constexpr double kBusy_s = 2.5;
constexpr double kInf = std::numeric_limits<double>::infinity();

Sentence started_again() {
  return say({"the robot's time went back: was it started again?", "el tiempo del robot retrocedió: ¿se reinició?"});
}

/// In what the robot on the line now differs from the one that was there before.
Sentence exchanged(const wire::Describe& before, const wire::Describe& now) {
  Sentence what;
  const auto was = read_description(before), is = read_description(now);
  if (was && is) {
    for (const Difference& one : differences(*was, *is)) {
      if (!what.empty()) what += Sentence::quoted("; ");
      what += text_of(one);
    }
  }
  if (what.empty()) what = say({"it describes itself otherwise", "se describe de otro modo"});
  return say({"another robot than before is on the line, which gets no command: {}",
              "en la línea hay otro robot que antes, que no recibe órdenes: {}"},
             what);
}

}  // namespace

ControllerEnd::ControllerEnd(ControllerEndConfig config)
    : config_(std::move(config)), reader_(config_.carrier), writer_(config_.carrier, config_.encoding) {}

void ControllerEnd::connected(double now_s) {
  reader_ = FrameReader(config_.carrier);
  out_.clear();
  connected_ = true;
  welcomed_ = greeted_ = described_ = false;
  heard_s_ = beat_s_ = now_s;
  ask_again(now_s);
}

void ControllerEnd::disconnected(double) {
  if (connected_ && !token_.empty()) ++statistics_.reconnections;
  connected_ = false;
  out_.clear();
}

void ControllerEnd::greet(double now_s) { want(Wanted::Greeting, now_s); }

void ControllerEnd::reset(std::uint64_t seed, std::uint32_t episode, double now_s) {
  reset_.set_seed(seed);
  reset_.set_episode(episode);
  want(Wanted::ResetEcho, now_s);
}

void ControllerEnd::act(std::span<const ActFrame> frames, double step_s, double now_s) {
  const bool lock_step = config_.pace == wire::LOCK_STEP;
  act_.set_tick(sense_.tick());
  act_.set_step_s(lock_step ? step_s : 0);
  write_acts(frames, floats_, act_);
  wanted_tick_ = sense_.tick() + 1;
  if (lock_step) {
    want(Wanted::Answer, now_s);
  } else if (greeted_) {
    send(act_);
    sent_s_ = now_s;
  }
}

void ControllerEnd::await_sense(double now_s) {
  if (!taken_) return;
  want(Wanted::NewerSense, now_s);
}

void ControllerEnd::bye(const Sentence& reason) {
  if (!connected_) return;
  wire::Bye message;
  write_words(reason, message);
  send(message);
}

void ControllerEnd::want(Wanted what, double now_s) {
  expects(done());
  waiting_for_ = what;
  asked_s_ = now_s;
  repeated_ = false;
  if (connected_ && greeted_) ask_again(now_s);  // else the Hello that was said comes first
}

void ControllerEnd::ask_again(double now_s) {
  sent_s_ = now_s;
  if (!greeted_) {
    wire::Hello hello;
    hello.set_major(1);
    hello.set_minor(1);
    hello.set_name(config_.name);
    hello.set_token(token_);
    hello.set_last_tick(sense_.tick());
    hello.set_role(config_.role);
    hello.set_pace(config_.pace);
    hello.set_floats(config_.floats);
    hello.set_truth(config_.truth);
    return send(hello);
  }
  if (waiting_for_ == Wanted::ResetEcho || waiting_for_ == Wanted::ResetSense) return send(reset_);
  if (waiting_for_ == Wanted::Answer) return send(act_);
}

void ControllerEnd::receive(std::string_view bytes, double now_s) {
  if (!bytes.empty()) heard_s_ = now_s;
  reader_.feed(bytes);
  while (connected_ && !failure_) {
    const auto payload = reader_.next();
    if (!payload) {
      const bool strange = !reader_.encoding();  // its very first byte is none of ours
      return fail(strange
                      ? say({"what answers there is no robot link: neither a JSON line nor a binary frame came",
                             "lo que responde allí no es el enlace de un robot: no llegó ni una línea JSON ni una "
                             "trama binaria"})
                      : say({"the robot breaks the rules of the link: {}", "el robot rompe las reglas del enlace: {}"},
                            payload.error().what));
    }
    if (!*payload) break;
    const auto kind = decode(**payload, *reader_.encoding(), in_);
    if (!kind && config_.carrier == Carrier::Packets) {  // damaged in a way that its checksum does not show
      ++statistics_.lost;
      misread_ = kind.error().what;
      continue;
    }
    if (!kind) {
      return fail(say({"the robot sent what cannot be read: {}", "el robot envió algo que no se puede leer: {}"},
                      kind.error().what));
    }
    handle(*kind, now_s);
  }
}

void ControllerEnd::handle(FrameKind kind, double now_s) {
  switch (kind) {
    case FrameKind::Hello:
      return heard_hello();
    case FrameKind::Describe:
      return heard_describe();
    case FrameKind::Sense:
      return heard_sense(now_s);
    case FrameKind::Beat:
      return heard_beat(now_s);
    case FrameKind::Reset:
      if (waiting_for_ == Wanted::ResetEcho) waiting_for_ = Wanted::ResetSense;
      return;
    case FrameKind::Event:
      if (events_.size() < kMaxEvents) events_.push_back(in_.event);
      return;
    case FrameKind::Bye:
      return heard_bye(now_s);
    default:
      return;  // of a later minor version, or an echo of our own
  }
}

void ControllerEnd::heard_hello() {
  if (in_.hello.major() != 1) {
    return fail(say({"the robot speaks protocol {}.{}, we speak 1.0: update the older of the two",
                     "el robot habla el protocolo {}.{}, aquí se habla 1.0: actualice el más antiguo de los dos"},
                    in_.hello.major(), in_.hello.minor()));
  }
  if (!token_.empty() && !in_.hello.resumed() && config_.carrier == Carrier::Stream) {
    return fail(say({"the robot began a new session in the middle of ours: was it started again?",
                     "el robot empezó otra sesión en medio de la nuestra: ¿se reinició?"}));
  }
  welcomed_ = true;
  token_ = in_.hello.token().substr(0, 100);
  robot_program_ = printable(in_.hello.name(), 100);
  floats_ = in_.hello.floats();
}

void ControllerEnd::heard_bye(double now_s) {
  // The place may still be held for a connection that broke a moment ago: our own, or that of a run just killed.
  if (in_.bye.code() == wire::BUSY && now_s - asked_s_ < kBusy_s) return disconnected(now_s);
  if (in_.bye.code() == wire::NO_SESSION && !description_.empty()) {
    return fail(say({"the robot knows nothing of this run any more: was it started again?",
                     "el robot ya no sabe nada de esta ejecución: ¿se reinició?"}));
  }
  const Sentence reason = read_words(in_.bye);
  fail(say({"the robot said goodbye: {}", "el robot se despidió: {}"},
           reason.empty() ? say({"without a reason", "sin dar razón"}) : reason));
}

void ControllerEnd::heard_describe() {
  if (!welcomed_) return;  // of an earlier connection over the same line, or its Hello was lost
  std::string description = in_.describe.SerializeAsString();
  if (!description_.empty() && description != description_) return fail(exchanged(describe_, in_.describe));
  description_ = std::move(description);
  describe_.Swap(&in_.describe);
  described_ = true;
}

bool ControllerEnd::began_anew(std::uint32_t tick) noexcept {
  older_ = tick >= older_tick_ ? older_ + 1 : 1;
  older_tick_ = tick;
  return older_ >= kBeganAnew;
}

void ControllerEnd::heard_sense(double now_s) {
  if (!described_) return;  // of an earlier connection over the same line
  const std::uint32_t tick = in_.sense.tick();
  const bool first = !greeted_;
  greeted_ = true;
  switch (waiting_for_) {
    case Wanted::Greeting:
    case Wanted::ResetSense:
      break;
    case Wanted::ResetEcho:
      if (first) ask_again(now_s);
      return;
    case Wanted::Answer:
      if (tick == wanted_tick_) break;
      if (tick > wanted_tick_) {
        return fail(say({"the robot went on without us: is there another controller?",
                         "el robot siguió sin nosotros: ¿hay otro controlador?"}));
      }
      if (tick + 1 < wanted_tick_ && (first || began_anew(tick))) return fail(started_again());
      ++statistics_.late;
      if (first) ask_again(now_s);  // the Act was lost with the connection
      return;
    case Wanted::NewerSense:
      if (tick > sense_.tick()) break;
      if (tick < sense_.tick() && began_anew(tick)) return fail(started_again());
      ++statistics_.late;
      return;
    case Wanted::Nothing:
      if (config_.pace == wire::LOCK_STEP && config_.role == wire::COMMAND) return;
      if (tick < sense_.tick() && began_anew(tick)) return fail(started_again());
      if (tick <= sense_.tick()) return;
      if (!taken_) ++statistics_.late;  // the one before
      break;
  }
  if (config_.pace == wire::FREE_RUNNING && waiting_for_ != Wanted::Greeting && tick > sense_.tick()) {
    statistics_.lost += tick - sense_.tick() - 1;
  }
  taken_ = false;
  older_ = 0;
  sense_.Swap(&in_.sense);
  answered(now_s);
}

void ControllerEnd::answered(double now_s) {
  if (waiting_for_ == Wanted::Answer && !repeated_) statistics_.round_trip_s = now_s - sent_s_;
  waiting_for_ = Wanted::Nothing;
  misread_ = {};
}

void ControllerEnd::heard_beat(double now_s) {
  if (!in_.beat.answer()) {
    in_.beat.set_answer(true);
    in_.beat.set_time_s(now_s);
    return send(in_.beat);
  }
  if (in_.beat.number() != beat_.number()) return;
  const double robot_s = in_.beat.time_ms() != 0 ? in_.beat.time_ms() / 1000.0 : in_.beat.time_s();
  statistics_.clock_offset_s = robot_s - (beat_s_ + now_s) / 2;
  if (config_.pace == wire::FREE_RUNNING || config_.role == wire::WATCH) statistics_.round_trip_s = now_s - beat_s_;
  ++beats_answered_;
}

void ControllerEnd::beat(double now_s) {
  beat_s_ = now_s;
  beat_.set_number(beat_.number() + 1);
  beat_.set_time_s(now_s);
  send(beat_);
}

void ControllerEnd::poll(double now_s) {
  if (failure_) return;
  statistics_.lost += reader_.take_damaged();
  if (!done() && now_s >= asked_s_ + config_.patience_s) return fail(silence());
  if (!connected_) return;
  if (greeted_ && now_s >= beat_s_ + config_.beat_s) beat(now_s);
  if (done()) return;
  const bool mute = now_s >= silent_s();
  if (mute && config_.carrier == Carrier::Stream) return disconnected(now_s);
  if (mute) welcomed_ = greeted_ = described_ = false;  // the robot may have been unplugged or started again: ask
  if (config_.carrier == Carrier::Packets && now_s >= sent_s_ + config_.repeat_s) {
    ++statistics_.repeated;
    repeated_ = true;
    ask_again(now_s);
  }
}

double ControllerEnd::due_s() const noexcept {
  if (done() || failure_) return kInf;
  double due_s = asked_s_ + config_.patience_s;
  if (!connected_) return due_s;
  if (greeted_) due_s = std::min(due_s, beat_s_ + config_.beat_s);
  return std::min(due_s, config_.carrier == Carrier::Packets ? sent_s_ + config_.repeat_s : silent_s());
}

double ControllerEnd::silent_s() const noexcept {
  // Heartbeats and what a free-running robot senses show that it is there, not that it got the Hello or the request.
  const bool requested = config_.carrier == Carrier::Stream && (!greeted_ || waiting_for_ != Wanted::NewerSense);
  return (requested ? sent_s_ : std::max(heard_s_, asked_s_)) + config_.silence_s;
}

Sentence ControllerEnd::silence() const {
  if (config_.carrier == Carrier::Packets && heard_s_ > asked_s_ && !reader_.damaged_packet().empty()) {
    return say(
        {"no answer for {:.0f} s: bytes come, but no whole packet, the last one \"{}\": is this text that the robot "
         "prints, or is its baud rate another?",
         "sin respuesta durante {:.0f} s: llegan bytes, pero ningún paquete entero, el último \"{}\": ¿es texto que "
         "imprime el robot, o es otra su velocidad en baudios?"},
        config_.patience_s, reader_.damaged_packet());
  }
  if (!misread_.empty()) {
    return say({"no answer for {:.0f} s, and what came cannot be read: {}",
                "sin respuesta durante {:.0f} s, y lo que llegó no se puede leer: {}"},
               config_.patience_s, misread_);
  }
  return say({"no answer for {:.0f} s: is the robot switched on, and nobody else's?",
              "sin respuesta durante {:.0f} s: ¿está el robot encendido y no lo usa nadie más?"},
             config_.patience_s);
}

void ControllerEnd::warn(const Sentence& remark) {
  if (events_.size() >= kMaxEvents) return;
  wire::Event event;
  event.set_level(wire::WARNING);
  event.set_tick(sense_.tick());
  event.set_text(remark.en);
  event.set_text_es(remark.es);
  events_.push_back(std::move(event));
}

std::vector<wire::Event> ControllerEnd::take_events() { return std::exchange(events_, {}); }

void ControllerEnd::fail(Sentence reason) {
  if (!failure_) failure_ = Error{ErrorCode::LinkLost, std::move(reason), {}};
}

}  // namespace ganglion::link
