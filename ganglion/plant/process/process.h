#pragma once

#include <vector>

#include "ganglion/plant/plant.h"

namespace ganglion {

struct ProcessConfig {
  double gain = 1;
  double lag_s = 1;         ///< Time constant of the first lag.
  double second_lag_s = 0;  ///< Of the second; 0 = there is none.
  double dead_time_s = 0;   ///< Until a command acts.
  double start = 0;         ///< Of the value.
  double min = -1;          ///< Of the command.
  double max = 1;
  double noise = 0;            ///< Standard deviation of what is measured.
  double trip = 0;             ///< It fails where the value is farther from 0 than that; 0 = never.
  std::vector<double> loads;   ///< Added to the command where it acts, each from its time on.
  std::vector<double> load_s;  ///< When.
};

/// A process of first or second order with dead time, as textbooks of control have it:
/// value(s) = gain exp(-dead_time s) / ((1 + lag s)(1 + second_lag s)) (command(s) + load(s) exp(dead_time s)).
///
/// Worked out exactly, however long the steps are: between changes of command and load the answer is a sum of two
/// exponentials. Its cost is the command's size times the time, in units of the command and seconds.
/// Memory    16 bytes for each ms of dead time, taken in reset(). Source: the standard model; trip is ours.
class Process final : public Plant {
 public:
  explicit Process(ProcessConfig config) : config_(std::move(config)) {}
  /// Fails with BadParameter where min > max, or loads and their times do not go together;
  /// with TooLarge over kMaxLoads of them.
  static Result<void> judge(ProcessConfig& config);

  CommandElement element(std::size_t n) const override;
  std::span<const PlantTruth> truths() const noexcept override;
  void reset() override;
  void step(std::span<const double> commands, double step_s, Draws& draws) noexcept override;
  void sense(std::span<double> values) const noexcept override { values[0] = measured_; }
  void tell(std::span<double> truths) const noexcept override;
  double cost() const noexcept override { return cost_; }
  bool failed() const noexcept override;

  static constexpr std::size_t kMaxLoads = 1000;  ///< Each step looks through them.

 private:
  /// A command, and from when on it acts.
  struct Sent {
    double from_s = 0;
    double command = 0;
  };
  double safe() const noexcept;
  double load_at(double time_s) const noexcept;
  /// The time at which the command or the load changes next, after time_s.
  double next_change_s(double time_s) const noexcept;
  void send(double command) noexcept;
  /// Goes on under an input that stays.
  void advance(double input, double time_s) noexcept;

  ProcessConfig config_;
  double time_s_ = 0;
  double first_ = 0;   // behind the first lag
  double value_ = 0;   // behind both
  double acting_ = 0;  // the command that acts now
  double measured_ = 0;
  double cost_ = 0;
  std::vector<Sent> sent_;  // a ring of those that do not act yet
  std::size_t begin_ = 0, count_ = 0;
};

}  // namespace ganglion
