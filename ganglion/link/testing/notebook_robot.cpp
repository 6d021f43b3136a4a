#include "ganglion/link/testing/notebook_robot.h"

#include <cmath>
#include <limits>

namespace ganglion::link {

NotebookRobot::NotebookRobot(int robots) : ways_(static_cast<std::size_t>(robots)) {
  description_.name = "Notebook";
  description_.body = Body{0.2, 0.1, 0, {}};
  description_.sensations = {
      {.name = "ways.length", .unit = "m", .elements = {"left", "right"}, .min = -100, .max = 100},
      {.name = "sonar.range", .unit = "m", .min = 0, .max = 3, .period_s = 0.2}};
  description_.commands = {{"drive", {{"left", "m/s", -1, 1, 0}, {"right", "m/s", -1, 1, 0}}}};
  description_.tick_s = 0.1;
}

Result<void> NotebookRobot::reset(std::uint64_t, std::uint32_t) {
  if (refuses_reset) return fail(ErrorCode::BadParameter, {"no place to stand", "no hay dónde estar"});
  std::fill(ways_.begin(), ways_.end(), Ways{});
  done_.clear();
  tick_ = 0;
  time_s_ = 0;
  ++resets_;
  return {};
}

void NotebookRobot::sense(std::span<SenseFrame> frames) noexcept {
  for (std::size_t n = 0; n < frames.size(); ++n) {
    SenseFrame& frame = frames[n];
    frame.tick = tick_;
    frame.time_s = time_s_;
    frame.cost = tick_ == 0 ? std::nullopt : std::optional(0.25 * tick_);
    const double missing[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -0.0};
    frame.values = {ways_[n].left_m, ways_[n].right_m, missing[tick_ % 3]};
    frame.ages_s = {0, 0.1 * (tick_ % 2)};
  }
}

void NotebookRobot::step(std::span<const ActFrame> frames, double step_s) noexcept {
  if (stepping) stepping(frames[0]);
  for (std::size_t n = 0; n < frames.size(); ++n) {
    ways_[n].left_m += frames[n].values[0] * step_s;
    ways_[n].right_m += frames[n].values[1] * step_s;
  }
  done_.push_back({tick_, frames[0].values[0], frames[0].values[1], frames[0].ttl_s[0], frames[0].origins[0]});
  ++tick_;
  time_s_ += step_s;
}

void decide(const SenseFrame& sense, ActFrame& act) noexcept {
  act.tick = sense.tick;
  act.values = {0.5 - 0.1 * sense.values[0], sense.tick % 7 == 0 ? -0.3 : 0.7};
  act.origins = {CommandOrigin::Commanded};
  act.ttl_s = {sense.tick % 5 == 0 ? 0.04 : 0.3};
}

}  // namespace ganglion::link
