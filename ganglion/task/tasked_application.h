#pragma once

#include <memory>
#include <vector>

#include "ganglion/task/task_model.h"

namespace ganglion {

/// An application with the tasks that are set to each of its robots: their channels stand behind its own in a frame, of
/// which it fills the first values only. What `ganglion sim` serves and a run drives. reset() takes memory; sense() and
/// step() take none. After a reset that failed the tasks' channels are NaN, and nothing is judged.
class TaskedApplication final : public Application, public Witness {
 public:
  /// `description` is that of the inner application with the tasks' channels behind. Fails where a task cannot be made,
  /// or not be set there; with Unsupported where nobody knows the truth.
  static Result<std::unique_ptr<Application>> make(std::unique_ptr<Application> inner, Description description,
                                                   std::span<const TaskModel> tasks);

  const Description& description() const noexcept override { return description_; }
  int robots() const noexcept override { return inner_->robots(); }
  Result<void> reset(std::uint64_t seed, std::uint32_t episode) override;
  void sense(std::span<SenseFrame> frames) noexcept override;
  void step(std::span<const ActFrame> frames, double step_s) noexcept override;
  const Error* failure() const noexcept override { return inner_->failure(); }
  const Witness* witness() const noexcept override { return this; }
  const Terrain* terrain() const noexcept override { return inner_->terrain(); }
  std::span<const InterventionDescriptor> interventions() const noexcept override { return interventions_; }
  Result<Intervened> intervene(const Intervention& what) override;

  std::span<const TruthChannel> truth_channels() const noexcept override { return truth_->truth_channels(); }
  std::span<const double> truth_of(int robot) const noexcept override { return truth_->truth_of(robot); }
  double time_s() const noexcept override { return truth_->time_s(); }
  std::span<const LedgerForm> ledgers() const noexcept override { return ledgers_; }
  const Ledger* ledger(int robot, std::string_view task) const noexcept override;
  std::span<const PlacedMover> movers() const noexcept override { return truth_->movers(); }

  const Application& inner() const noexcept { return *inner_; }

 private:
  /// One task, set to every robot.
  struct Set {
    std::string id;
    std::uint64_t name_hash = 0;
    std::size_t values = 0;  // of its channels
    std::size_t channels = 0;
    std::vector<std::unique_ptr<Task>> tasks;  // of each robot
  };
  TaskedApplication(std::unique_ptr<Application> inner, Description description);
  Result<void> add(const TaskModel& model);
  Outlook outlook(int robot) const noexcept;
  void judge() noexcept;

  std::unique_ptr<Application> inner_;
  const Witness* truth_;  // of inner_
  Description description_;
  std::size_t own_values_, own_channels_;  // of inner_ in a frame
  std::vector<Set> sets_;
  std::vector<LedgerForm> ledgers_;
  std::vector<InterventionDescriptor> interventions_;
  std::uint32_t tick_ = 0;
  bool set_ = false;  // the tasks have begun; not after a reset that failed
};

}  // namespace ganglion
