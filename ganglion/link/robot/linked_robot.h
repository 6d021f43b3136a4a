#pragma once

#include <vector>

#include "ganglion/link/robot/truth_teller.h"
#include "ganglion/link/wire/frames.h"

namespace ganglion::link {

/// The robots of an application as the link sees them: the present tick, its frames, and the commands that hold.
class LinkedRobot {
 public:
  /// The application outlives this; it has been reset.
  explicit LinkedRobot(Application& application);

  const Description& description() const noexcept { return application_.description(); }
  bool has_truth() const noexcept { return witness_ != nullptr; }
  const wire::Describe& describe() const noexcept { return describe_; }
  std::uint32_t tick() const noexcept { return tick_; }

  /// An episode begins, at tick 0, under safe values.
  Result<void> reset(std::uint64_t seed, std::uint32_t episode);
  /// Takes commands, made safe; what lives longer than max_ttl_s is cut. Fails with BadParameter, and takes nothing,
  /// where the frame does not fit the description.
  Result<void> take(const wire::Act& act, double max_ttl_s);
  void take_safe_values() noexcept;
  /// The commands are carried out for step_s, and have that much less time to live afterwards.
  void step(double step_s) noexcept;
  /// Lets time pass for the commands without carrying them out. Those that live shorter than a tick of the robot would
  /// never be carried out: of a fresh command `keep_s` of its life are spared.
  void age_commands(double elapsed_s, double keep_s = 0) noexcept;

  void write(bool floats, wire::Sense& out) const;
  /// What is true now, and what the listener does not know of yet.
  void write_truth(RowsTold& told, wire::Sense& out) const;
  /// None of it.
  static void write_no_truth(wire::Sense& out);

 private:
  void look() noexcept;

  Application& application_;
  const Witness* witness_;  // of the application; null where nothing but sensations is known
  wire::Describe describe_;
  std::vector<SenseFrame> sense_;
  std::vector<ActFrame> act_, taken_;
  std::uint32_t tick_ = 0;
};

}  // namespace ganglion::link
