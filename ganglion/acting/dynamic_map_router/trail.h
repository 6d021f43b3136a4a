#pragma once

#include <optional>
#include <vector>

#include "ganglion/grid/router.h"

namespace ganglion {

/// The last steps driven, newest first out; beyond its length the oldest are forgotten.
class Trail {
 public:
  explicit Trail(std::size_t length) : steps_(length) {}

  void push(const grid::RouteStep& step) noexcept {
    if (steps_.empty()) return;
    newest_ = (newest_ + 1) % steps_.size();
    steps_[newest_] = step;
    count_ = count_ < steps_.size() ? count_ + 1 : count_;
  }
  void pop() noexcept {
    newest_ = (newest_ + steps_.size() - 1) % steps_.size();
    --count_;
  }
  void clear() noexcept { count_ = 0; }

  /// The step that undoes the newest one, for a robot standing where that one led: the same line with the same heading,
  /// driven the other way.
  std::optional<grid::RouteStep> way_back(grid::CellIndex cell) const noexcept {
    if (count_ == 0 || steps_[newest_].to != cell) return std::nullopt;
    grid::RouteStep step = steps_[newest_];
    std::swap(step.from, step.to);
    step.motion = step.motion == grid::Motion::Forward ? grid::Motion::Backward : grid::Motion::Forward;
    step.direction = static_cast<std::uint8_t>(grid::turned(step.direction, 4));
    return step;
  }

 private:
  std::vector<grid::RouteStep> steps_;
  std::size_t newest_ = 0;
  std::size_t count_ = 0;
};

}  // namespace ganglion
