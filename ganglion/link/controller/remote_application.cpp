#include "ganglion/link/controller/remote_application.h"

#include <algorithm>

#include "ganglion/base/expects.h"
#include "ganglion/base/hash.h"

namespace ganglion::link {
namespace {

constexpr double kStuck_s = 3;  // the other side takes nothing

}  // namespace

RemoteApplication::RemoteApplication(std::unique_ptr<Line> line, const Description& file, int robots,
                                     const RemoteConfig& config)
    : line_(std::move(line)), file_(file), robots_(robots), config_(config), end_(config.end), room_(kRoomBytes) {}

RemoteApplication::~RemoteApplication() {
  end_.bye(say({"the run is over", "la ejecución terminó"}));
  if (!end_.outgoing().empty()) {
    const auto sent = line_->send(end_.outgoing(), line_->now_s() + 1);
    static_cast<void>(sent);  // who is not there any more needs no goodbye
  }
  line_->close();
}

Result<std::unique_ptr<RemoteApplication>> RemoteApplication::connect(std::unique_ptr<Line> line,
                                                                      const Description& file, int robots,
                                                                      const RemoteConfig& config) {
  RemoteConfig mine = config;
  mine.end.carrier = line->carrier();
  std::unique_ptr<RemoteApplication> made(new RemoteApplication(std::move(line), file, robots, mine));
  if (auto greeted = made->greet(); !greeted) return tl::unexpected<Error>(greeted.error());
  if (auto compared = made->compare(); !compared) return tl::unexpected<Error>(compared.error());
  return made;
}

Result<void> RemoteApplication::greet() {
  const double begun_s = line_->now_s();
  for (;;) {
    const auto reached = line_->connect(std::max(begun_s + config_.reach_s, line_->now_s() + kStuck_s));
    if (reached) break;
    const bool stop = config_.stop && config_.stop();
    if (line_->now_s() >= begun_s + config_.reach_s || stop) return reached;
    line_->wait_until(line_->now_s() + kRetry_s);
  }
  end_.greet(line_->now_s());
  end_.connected(line_->now_s());
  await();
  if (failure() != nullptr) return tl::unexpected<Error>(error());
  return {};
}

Result<void> RemoteApplication::compare() {
  const wire::Describe& describe = end_.describe();
  auto robot = read_description(describe);
  if (!robot) {
    return fail(ErrorCode::LinkLost,
                {"{}: what the robot says of itself makes no sense: {}",
                 "{}: lo que el robot dice de sí mismo no tiene sentido: {}"},
                line_->address(), robot.error().what);
  }
  const int robots = std::max(1, static_cast<int>(describe.robots()));
  if (robots != robots_) {
    return fail(ErrorCode::LinkLost,
                {"{}: there are {} robots, the experiment has {}: set application.robots = {}",
                 "{}: hay {} robots, el experimento tiene {}: fije application.robots = {}"},
                line_->address(), robots, robots_, robots);
  }
  differences_ = link::differences(file_, *robot);
  if (std::any_of(differences_.begin(), differences_.end(), [](const Difference& one) { return one.grave; })) {
    return fail(ErrorCode::LinkLost,
                {"{}: this is not the robot the controller was drawn for: {}",
                 "{}: este no es el robot para el que se dibujó el controlador: {}"},
                line_->address(), text_of(differences_));
  }
  map_.emplace(file_, *robot);
  sense_.assign(static_cast<std::size_t>(robots_), make_sense_frame(*robot));
  act_.assign(static_cast<std::size_t>(robots_), make_act_frame(*robot));
  if (RemoteWitness::told(describe) && config_.end.truth && !config_.truth.channels.empty()) {
    auto witness = RemoteWitness::make(describe, config_.truth);
    if (!witness) return fail(ErrorCode::LinkLost, {"{}: {}", "{}: {}"}, line_->address(), witness.error().what);
    witness_ = std::make_unique<RemoteWitness>(std::move(*witness));
  }
  take_sense(true);
  if (failure() != nullptr) return tl::unexpected<Error>(error());
  return {};
}

Result<void> RemoteApplication::reset(std::uint64_t seed, std::uint32_t episode) {
  if (failure() != nullptr) return tl::unexpected<Error>(error());
  end_.reset(seed, episode, line_->now_s());
  await();
  take_sense(true);
  if (failure() != nullptr) return tl::unexpected<Error>(error());
  return {};
}

void RemoteApplication::sense(std::span<SenseFrame> frames) noexcept {
  expects(frames.size() == sense_.size());
  if (config_.end.pace == wire::FREE_RUNNING && failure() == nullptr) {
    drain();  // the newest one counts
    end_.await_sense(line_->now_s());
    await();
    take_sense(false);
  }
  for (std::size_t n = 0; n < frames.size(); ++n) map_->to_file(sense_[n], frames[n]);
}

void RemoteApplication::step(std::span<const ActFrame> frames, double step_s) noexcept {
  expects(frames.size() == act_.size());
  if (failure() != nullptr) return;
  for (std::size_t n = 0; n < frames.size(); ++n) map_->to_robot(frames[n], act_[n]);
  asked_step_s_ = step_s;
  end_.act(act_, step_s, line_->now_s());
  if (config_.end.pace == wire::FREE_RUNNING) return flush();
  await();
  take_sense(false);
}

void RemoteApplication::stay_in_touch() noexcept {
  drain();
  end_.poll(line_->now_s());
  flush();
}

void RemoteApplication::take_sense(bool first) noexcept {
  if (failure() != nullptr) return;
  const wire::Sense& message = end_.sense();
  end_.take_sense();
  if (!read_senses(message, sense_)) {
    const SenseFrame& one = sense_.front();
    return end_.fail(
        say({"a Sense of {} robots must have {} values and {} ages (or none), as described",
             "un Sense de {} robots debe tener {} valores y {} antigüedades (o ninguna), como se describió"},
            robots_, sense_.size() * one.values.size(), sense_.size() * one.ages_s.size()));
  }
  tell_time(first);
  if (witness_ == nullptr) return;
  if (auto taken = witness_->take(message, sense_.front().time_s, first); !taken) end_.fail(taken.error().what);
}

void RemoteApplication::tell_time(bool first) noexcept {
  const double now_s = line_->now_s(), waited_s = now_s - std::exchange(taken_s_, now_s);
  const std::uint32_t tick = sense_.front().tick, ticks = tick - std::exchange(taken_tick_, tick);
  const double told_s = sense_.front().time_s;
  if (first) return clock_.start(told_s);
  if (ticks == 0) return;  // the link broke, and keeps what came last
  const bool free = config_.end.pace == wire::FREE_RUNNING;
  const RobotClock::Step step = clock_.take(told_s, ticks * (free ? file_.tick_s : asked_step_s_), waited_s);
  for (SenseFrame& frame : sense_) {
    frame.time_s = clock_.time_s();
    for (double& age_s : frame.ages_s) age_s += clock_.stood_s();
  }
  if (clock_.hopeless()) return end_.fail(clock_.words(step));
  if (step != RobotClock::Step::Regular && clock_.news()) end_.warn(clock_.words(step));
}

void RemoteApplication::await() noexcept {
  do {
    if (end_.wants_connection() && !reconnect()) {
      end_.poll(line_->now_s());
      continue;
    }
    flush();
    if (end_.done() || failure() != nullptr || end_.wants_connection()) continue;
    const auto got = line_->receive(room_, end_.due_s());
    const double now_s = line_->now_s();
    if (!got) {
      end_.disconnected(now_s);
    } else if (*got > 0) {
      end_.receive({room_.data(), *got}, now_s);
    }
    end_.poll(now_s);
  } while (!end_.done() && failure() == nullptr);
  if (failure() != nullptr) line_->close();
}

void RemoteApplication::flush() noexcept {
  std::string& out = end_.outgoing();
  if (out.empty()) return;
  const auto sent = line_->send(out, line_->now_s() + kStuck_s);
  out.clear();
  if (!sent) end_.disconnected(line_->now_s());
}

void RemoteApplication::drain() noexcept {
  while (!end_.wants_connection() && failure() == nullptr) {
    const auto got = line_->receive(room_, line_->now_s());
    if (!got) return end_.disconnected(line_->now_s());
    if (*got == 0) return;
    end_.receive({room_.data(), *got}, line_->now_s());
  }
}

bool RemoteApplication::reconnect() noexcept {
  if (config_.stop && config_.stop()) {
    end_.fail(say({"interrupted while the connection was broken", "interrumpida con la conexión cortada"}));
    return false;
  }
  line_->close();
  line_->wait_until(tried_s_ + kRetry_s);
  tried_s_ = line_->now_s();
  if (!line_->connect(tried_s_ + kStuck_s)) return false;
  end_.connected(line_->now_s());
  return true;
}

Error RemoteApplication::error() const {
  Error error = *end_.failure();
  error.what = say({"{}: {}", "{}: {}"}, line_->address(), error.what);
  return error;
}

Sentence text_of(const std::vector<Difference>& differences) {
  Sentence text;
  for (const Difference& one : differences) {
    if (!text.empty()) text += Sentence::quoted("; ");
    text += text_of(one);
  }
  return text;
}

}  // namespace ganglion::link
