#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "ganglion/experience/writer.h"
#include "ganglion/graph/controller.h"

namespace ganglion {

/// When what was learned is handed over: once a second, and before that where requests were concluded or the last try
/// found no place, but not before kLeast_s have passed. Times of any clock that only goes forward [s].
class HandoverTimes {
 public:
  static constexpr double kLeast_s = 0.05;
  static constexpr double kMost_s = 1;

  explicit HandoverTimes(double start_s) noexcept : tried_s_(start_s) {}
  bool due(double now_s, std::uint64_t concluded) const noexcept {
    const double since_s = now_s - tried_s_;
    return since_s >= kMost_s || (since_s >= kLeast_s && (refused_ || concluded != concluded_));
  }
  void tried(double now_s, std::uint64_t concluded, bool taken) noexcept {
    tried_s_ = now_s;
    refused_ = !taken;
    if (taken) concluded_ = concluded;
  }

 private:
  double tried_s_;
  std::uint64_t concluded_ = 0;
  bool refused_ = false;
};

/// Hands what a controller learns to whoever keeps it. Looks at the clock, so it is asked between ticks: what happens in
/// them does not depend on it.
class HandingOver {
 public:
  /// `keeper` may be null: nothing is kept.
  HandingOver(ExperienceWriter* keeper, const Controller& controller)
      : keeper_(keeper),
        controller_(&controller),
        learners_(keeper != nullptr ? controller.learners() : std::vector<LearningComponent>()),
        times_(now_s()) {}

  void between_ticks() {
    if (learners_.empty()) return;
    const double now = now_s();
    const std::uint64_t concluded = controller_->concluded();
    if (times_.due(now, concluded)) times_.tried(now, concluded, keeper_->offer(learners_));
  }
  /// All of it, at the end; waits until it is kept.
  Result<void> conclude() { return learners_.empty() ? Result<void>() : keeper_->conclude(learners_); }

 private:
  static double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  ExperienceWriter* keeper_;
  const Controller* controller_;
  std::vector<LearningComponent> learners_;
  HandoverTimes times_;
};

}  // namespace ganglion
