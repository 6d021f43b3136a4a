#pragma once

#include <functional>

#include "ganglion/application/application.h"

namespace ganglion::link {

/// An application for tests: two wheels whose ways it sums up, and a list of all it was told to do.
class NotebookRobot final : public Application {
 public:
  struct Done {
    std::uint32_t tick = 0;
    double left = 0, right = 0, ttl_s = 0;
    CommandOrigin origin = CommandOrigin::Safe;
    friend bool operator==(const Done&, const Done&) = default;
  };
  explicit NotebookRobot(int robots = 1);

  const Description& description() const noexcept override { return description_; }
  int robots() const noexcept override { return static_cast<int>(ways_.size()); }
  Result<void> reset(std::uint64_t seed, std::uint32_t episode) override;
  void sense(std::span<SenseFrame> frames) noexcept override;
  void step(std::span<const ActFrame> frames, double step_s) noexcept override;

  /// What robot 0 did, tick by tick.
  const std::vector<Done>& done() const noexcept { return done_; }
  int resets() const noexcept { return resets_; }
  /// Called before each step.
  std::function<void(const ActFrame&)> stepping;
  bool refuses_reset = false;

 private:
  struct Ways {
    double left_m = 0, right_m = 0;
  };
  Description description_;
  std::vector<Ways> ways_;
  std::vector<Done> done_;
  std::uint32_t tick_ = 0;
  double time_s_ = 0;
  int resets_ = 0;
};

/// A controller to go with it: what it commands depends on what it senses.
void decide(const SenseFrame& sense, ActFrame& act) noexcept;

}  // namespace ganglion::link
