#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ganglion/application/model.h"
#include "ganglion/application/step_clock.h"
#include "ganglion/plant/plant.h"
#include "ganglion/task/task_model.h"

namespace ganglion {

/// Plants of one kind as an Application, each by itself. One that fails puts itself back at the end of the step: the next
/// frame shows the new trial, counts it, and carries no cost. Commands lapse to their safe values after their time to
/// live, exactly.
class PlantApplication final : public Application, public Witness {
 public:
  /// `plants` are of one kind. They have that description.
  PlantApplication(Description description, std::vector<TruthChannel> truth,
                   std::vector<std::unique_ptr<Plant>> plants);

  const Description& description() const noexcept override { return description_; }
  int robots() const noexcept override { return static_cast<int>(plants_.size()); }
  Result<void> reset(std::uint64_t seed, std::uint32_t episode) override;
  void sense(std::span<SenseFrame> frames) noexcept override;
  void step(std::span<const ActFrame> frames, double step_s) noexcept override;
  const Witness* witness() const noexcept override { return this; }

  std::span<const TruthChannel> truth_channels() const noexcept override { return truth_; }
  std::span<const double> truth_of(int robot) const noexcept override;
  double time_s() const noexcept override { return clock_.time_s(); }

 private:
  /// What is kept of one plant.
  struct State {
    double cost = 0;
    bool has_cost = false;
    std::uint32_t trials = 0;
  };
  void act(std::size_t plant, const ActFrame& frame, double step_s, Draws& draws) noexcept;

  Description description_;
  std::vector<TruthChannel> truth_;
  std::vector<std::unique_ptr<Plant>> plants_;
  std::vector<State> states_;
  std::vector<double> commands_;  // of one plant
  mutable std::vector<double> row_;
  std::uint64_t seed_ = 0;
  std::uint32_t episode_ = 0;
  std::uint32_t tick_ = 0;
  StepClock clock_;
};

/// A plant as its file states it: `format = 1`, `kind`, `name`, `tick_s`, the kind's parameters, any number of `[[task]]`.
class PlantModel final : public ApplicationModel {
 public:
  /// Null if there were problems.
  static std::shared_ptr<const ApplicationModel> read(const ApplicationSource& source,
                                                      std::span<const PlantKind* const> kinds,
                                                      std::span<const TaskKind* const> tasks, Problems& problems);

  const Description& description() const noexcept override { return tasked_; }
  std::span<const TruthChannel> truth() const noexcept override { return truth_; }
  std::span<const LedgerForm> ledgers() const noexcept override { return ledgers_; }
  std::span<const std::string> tasks() const noexcept override { return task_ids_; }
  Result<std::unique_ptr<Application>> make() const override;

 private:
  void describe(const Plant& plant);

  const PlantKind* kind_ = nullptr;
  Parameters parameters_{{}};
  int plants_ = 1;
  Description own_;     // of the plant alone
  Description tasked_;  // with the channels of its tasks behind
  std::vector<TruthChannel> truth_;
  std::vector<TaskModel> tasks_;
  std::vector<std::string> task_ids_;
  std::vector<LedgerForm> ledgers_;
};

}  // namespace ganglion
