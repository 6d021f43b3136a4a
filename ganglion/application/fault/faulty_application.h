#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ganglion/application/application.h"
#include "ganglion/application/fault/fault.h"
#include "ganglion/random/draws.h"

namespace ganglion {

/// What a fault's work on every robot has in common.
struct FaultPlan {
  FaultPlan(const Fault& of, FaultSite at, const Description& robot, double step_s);

  Fault fault;
  FaultSite site;
  double step_s;
  std::vector<double> dead, min, max;  ///< Of every value of a frame.
  std::vector<char> circular, discrete;
  std::vector<double> turn;  ///< Of those that go round by another number than 2 pi; else 0.
  double depth = 0;          ///< Late: ticks of delay.
  /// What one robot needs to remember for it; a double: absurd delays are refused by what this says.
  double bytes_each() const noexcept;
};

/// One fault at work on one robot.
class FaultAtWork {
 public:
  explicit FaultAtWork(std::shared_ptr<const FaultPlan> plan);
  /// An episode begins: draws whether and when.
  void reset(std::uint64_t seed, std::uint32_t episode, std::uint32_t robot) noexcept;
  bool on_commands() const noexcept { return plan_->site.commands; }
  /// Spoils a frame's values; `clocks` are its ages [s] or, of commands, times to live [s].
  void spoil(std::span<double> values, std::span<double> clocks, std::uint32_t tick, double time_s) noexcept;

 private:
  bool active(double time_s) const noexcept;
  void hold(std::span<double> values) noexcept;
  void shift(std::span<double> values, std::span<double> clocks, bool active) noexcept;
  void lose(std::span<double> values, std::span<double> clocks, bool lost) noexcept;
  double bounded(std::size_t n, double value) const noexcept;

  std::shared_ptr<const FaultPlan> plan_;
  std::vector<double> held_;         // Stuck, Lost: by the order of the site's values
  std::vector<double> held_clocks_;  // Lost: by the order of the site's channels
  std::vector<double> past_;         // Late: a ring of `depth_` rows of values
  std::size_t depth_ = 0, row_ = 0, rows_ = 0;
  StreamId stream_{};
  bool happens_ = false, holds_ = false;
  double from_s_ = 0;
};

/// The most that all faults of all robots may remember.
inline constexpr double kMaxFaultBytes = 256.0 * (1 << 20);

/// What each fault does to robots of that kind. Fails as site_of() does; with TooLarge over kMaxFaults or, at the fault
/// that is too much, over kMaxFaultBytes for so many robots and a time step of step_s.
Result<std::vector<std::shared_ptr<const FaultPlan>>> plan_faults(const std::vector<Fault>& faults,
                                                                  const Description& robot, int robots, double step_s);

/// An application whose sensations and commands suffer the given faults, in their order. With no fault it is the
/// application itself, to the bit; what a fault draws depends on seed, episode, robot, the fault's own words and tick.
/// Nothing is allocated while stepping.
class FaultyApplication final : public Application {
 public:
  /// `inner` outlives it. `step_s` is the time step, for delays. Fails as plan_faults() does.
  static Result<std::unique_ptr<FaultyApplication>> make(Application& inner, const std::vector<Fault>& faults,
                                                         double step_s);

  const Description& description() const noexcept override { return inner_.description(); }
  int robots() const noexcept override { return inner_.robots(); }
  Result<void> reset(std::uint64_t seed, std::uint32_t episode) override;
  void sense(std::span<SenseFrame> frames) noexcept override;
  void step(std::span<const ActFrame> frames, double step_s) noexcept override;
  const Error* failure() const noexcept override { return inner_.failure(); }
  void show(Exhibition& to) const override { inner_.show(to); }

 private:
  explicit FaultyApplication(Application& inner) : inner_(inner) {}

  Application& inner_;
  std::vector<std::vector<FaultAtWork>> faults_;  // of each robot
  std::vector<ActFrame> act_;
  std::uint32_t tick_ = 0;
  double time_s_ = 0;
};

}  // namespace ganglion
