#pragma once

#include <functional>
#include <map>
#include <string>

#include "ganglion/application/application.h"
#include "ganglion/link/wire/codec.h"

namespace ganglion::link {

/// A robot under the eyes of a model that reads what is said to it by itself, and holds what it does to three rules: no
/// command is in force later than its time to live after the frame that brought it; nothing is outside the limits; no
/// tick is carried out twice, nor without anybody having asked for it. All robots of a link keep one pace.
class WatchedRobot final : public Application {
 public:
  /// `inner` outlives it. `now` is the time that heard() and step() happen at.
  WatchedRobot(Application& inner, wire::Pace pace, std::function<double()> now);

  /// These bytes are about to reach the robot over that connection.
  void heard(std::uint32_t connection, Carrier carrier, std::string_view bytes);
  /// The first rule that was broken, and how; "" while none is.
  const std::string& broken() const noexcept { return broken_; }

  const Description& description() const noexcept override { return inner_.description(); }
  int robots() const noexcept override { return inner_.robots(); }
  Result<void> reset(std::uint64_t seed, std::uint32_t episode) override;
  void sense(std::span<SenseFrame> frames) noexcept override { inner_.sense(frames); }
  void step(std::span<const ActFrame> frames, double step_s) noexcept override;

 private:
  struct Listener {
    explicit Listener(Carrier carrier) : reader(carrier) {}
    FrameReader reader;
    std::optional<std::uint32_t> acted;  // tick of the last Act since a Hello or Reset
  };
  void hear(FrameKind kind, Listener& listener);
  void hear_act(Listener& listener);
  void check_limits(const ActFrame& frame);
  void check_times(const ActFrame& frame, double clock_s);
  void check_tick(const ActFrame& frame);
  void accuse(std::string what) {
    if (broken_.empty()) broken_ = std::move(what);
  }

  Application& inner_;
  wire::Pace pace_;
  std::function<double()> now_;
  std::map<std::uint32_t, Listener> listeners_;
  Messages in_;
  std::map<std::uint32_t, std::uint32_t> asked_;  // lock-step: how often each tick was asked for
  double robot_s_ = 0;                            // time of steps, all episodes together
  double holds_until_s_ = 0;  // no command heard so far lives longer; robot's time in lock-step, else now()
  double fresh_s_ = 0;  // free-running: of its life, at most a tick begins with the tick that first carries it out
  double first_hello_s_ = -1;
  std::uint32_t hellos_ = 0, resets_heard_ = 0, resets_ = 0, steps_ = 0;
  std::uint32_t next_tick_ = 0;
  std::string broken_;
};

}  // namespace ganglion::link
