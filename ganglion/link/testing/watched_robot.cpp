#include "ganglion/link/testing/watched_robot.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/text.h"
#include "ganglion/link/wire/frames.h"

namespace ganglion::link {
namespace {

constexpr double kTolerance_s = 1e-6;       // of sums of times
constexpr double kLongestTtl_s = 0.5;       // docs/link.md, free-running
constexpr std::uint32_t kMostSteps = 1000;  // of one Step

}  // namespace

WatchedRobot::WatchedRobot(Application& inner, wire::Pace pace, std::function<double()> now)
    : inner_(inner), pace_(pace), now_(std::move(now)) {}

void WatchedRobot::heard(std::uint32_t connection, Carrier carrier, std::string_view bytes) {
  Listener& listener = listeners_.try_emplace(connection, carrier).first->second;
  listener.reader.feed(bytes);
  for (;;) {
    const auto payload = listener.reader.next();
    if (!payload || !*payload) return;
    if (const auto kind = decode(**payload, *listener.reader.encoding(), in_)) hear(*kind, listener);
  }
}

void WatchedRobot::hear(FrameKind kind, Listener& listener) {
  switch (kind) {
    case FrameKind::Hello:
      ++hellos_;
      if (first_hello_s_ < 0) first_hello_s_ = now_();
      listener.acted.reset();
      return;
    case FrameKind::Reset:
      ++resets_heard_;
      listener.acted.reset();
      return;
    case FrameKind::Act:
      return hear_act(listener);
    case FrameKind::Step:
      for (std::uint32_t n = 0; n < std::min(in_.step.ticks(), kMostSteps); ++n) ++asked_[in_.step.tick() + n];
      return;
    default:
      return;
  }
}

void WatchedRobot::hear_act(Listener& listener) {
  ++asked_[in_.act.tick()];
  const bool free_running = pace_ == wire::FREE_RUNNING;
  if (free_running && listener.acted && in_.act.tick() <= *listener.acted) return;  // said again: lives no longer
  listener.acted = in_.act.tick();
  double ttl_s = in_.act.ttl_ms() == 0 ? kDefaultTtl_s : in_.act.ttl_ms() / 1000.0;
  for (const double own_s : in_.act.ttl_s()) ttl_s = std::max(ttl_s, own_s);
  fresh_s_ = std::max(fresh_s_, std::min(ttl_s, description().tick_s));
  // In lock-step it begins to live at its own tick, which is at most the next one.
  holds_until_s_ = std::max(holds_until_s_, free_running ? now_() + std::min(ttl_s, kLongestTtl_s) : robot_s_ + ttl_s);
}

Result<void> WatchedRobot::reset(std::uint64_t seed, std::uint32_t episode) {
  if (++resets_ > resets_heard_ + 1) accuse("a reset nobody asked for");  // the first one comes before the link
  next_tick_ = 0;
  return inner_.reset(seed, episode);
}

void WatchedRobot::check_limits(const ActFrame& frame) {
  std::size_t n = 0;
  for (const CommandChannel& channel : description().commands) {
    for (const CommandElement& element : channel.elements) {
      const double value = frame.values[n++];
      if (value >= element.min && value <= element.max) continue;
      accuse(fmt::format("{}.{} is {} at tick {}", channel.name, element.name, shortest(value), frame.tick));
    }
  }
}

void WatchedRobot::check_times(const ActFrame& frame, double clock_s) {
  std::size_t n = 0;
  for (std::size_t c = 0; c < frame.ttl_s.size(); ++c) {
    bool safe = true;
    for (const CommandElement& element : description().commands[c].elements) {
      safe = frame.values[n++] == element.safe && safe;
    }
    if (safe || (frame.ttl_s[c] > 0 && clock_s + frame.ttl_s[c] <= holds_until_s_ + kTolerance_s)) continue;
    if (pace_ == wire::FREE_RUNNING && frame.ttl_s[c] <= fresh_s_) continue;
    if (frame.ttl_s[c] == 0 && clock_s < holds_until_s_) continue;  // said with no time to live: for the robot to drop
    accuse(fmt::format("a command lives until {:.3f} s at tick {}, but the last one heard only until {:.3f} s",
                       clock_s + frame.ttl_s[c], frame.tick, holds_until_s_));
  }
}

void WatchedRobot::check_tick(const ActFrame& frame) {
  if (frame.tick != next_tick_) accuse(fmt::format("tick {} follows {} ticks", frame.tick, next_tick_));
  next_tick_ = frame.tick + 1;
  ++steps_;
  if (pace_ == wire::LOCK_STEP) {
    const auto asked = asked_.find(frame.tick);
    if (asked == asked_.end() || asked->second == 0) {
      return accuse(fmt::format("tick {} is carried out once more than it was asked for", frame.tick));
    }
    --asked->second;
    return;
  }
  const double most = (now_() - first_hello_s_) / description().tick_s + hellos_ + 1;
  if (hellos_ == 0 || steps_ > most) accuse(fmt::format("{} ticks within {:.3f} s", steps_, now_() - first_hello_s_));
}

void WatchedRobot::step(std::span<const ActFrame> frames, double step_s) noexcept {
  check_tick(frames[0]);
  for (const ActFrame& frame : frames) {
    check_limits(frame);
    check_times(frame, pace_ == wire::LOCK_STEP ? robot_s_ : now_());
  }
  robot_s_ += step_s;
  fresh_s_ = 0;
  inner_.step(frames, step_s);
}

}  // namespace ganglion::link
