#include "ganglion/link/robot/linked_robot.h"

#include <algorithm>

#include "ganglion/link/wire/description.h"

namespace ganglion::link {

LinkedRobot::LinkedRobot(Application& application) : application_(application), witness_(application.witness()) {
  const auto robots = static_cast<std::size_t>(application.robots());
  sense_.assign(robots, make_sense_frame(description()));
  act_.assign(robots, make_act_frame(description()));
  taken_ = act_;
  write_description(description(), describe_);
  describe_.set_robots(static_cast<std::uint32_t>(robots));
  describe_.set_truth(has_truth());
  if (has_truth()) describe_truth(*witness_, describe_);
  look();
}

Result<void> LinkedRobot::reset(std::uint64_t seed, std::uint32_t episode) {
  if (auto done = application_.reset(seed, episode); !done) return done;
  tick_ = 0;
  take_safe_values();
  look();
  return {};
}

void LinkedRobot::look() noexcept {
  application_.sense(sense_);
  for (SenseFrame& frame : sense_) make_canonical(frame);
}

Result<void> LinkedRobot::take(const wire::Act& act, double max_ttl_s) {
  if (!read_acts(act, taken_)) {
    const std::size_t robots = taken_.size();
    return fail(ErrorCode::BadParameter,
                {"an Act here must have {} values, and {} (or none) of ttl_s, origins and reasons, for {} robot{}",
                 "un Act debe tener aquí {} valores, y {} (o ninguno) de ttl_s, origins y reasons, para {} robot{}"},
                robots * taken_.front().values.size(), robots * taken_.front().ttl_s.size(), robots,
                robots == 1 ? "" : "s");
  }
  for (ActFrame& frame : taken_) make_safe(description(), max_ttl_s, frame);
  act_.swap(taken_);
  return {};
}

void LinkedRobot::take_safe_values() noexcept {
  for (ActFrame& frame : act_) link::take_safe_values(description(), frame);
}

void LinkedRobot::step(double step_s) noexcept {
  for (ActFrame& frame : act_) frame.tick = tick_;
  application_.step(act_, step_s);
  age_commands(step_s);
  ++tick_;
  look();
}

void LinkedRobot::age_commands(double elapsed_s, double keep_s) noexcept {
  for (ActFrame& frame : act_) {
    std::size_t value = 0;
    for (std::size_t n = 0; n < frame.ttl_s.size(); ++n) {
      frame.ttl_s[n] = std::max(std::min(frame.ttl_s[n], keep_s), frame.ttl_s[n] - elapsed_s);
      const auto& elements = description().commands[n].elements;
      for (std::size_t e = 0; e < elements.size() && frame.ttl_s[n] <= 0; ++e) {
        frame.values[value + e] = elements[e].safe;
        frame.origins[n] = CommandOrigin::Safe;
        frame.reasons[n] = 0;
      }
      value += elements.size();
    }
  }
}

void LinkedRobot::write(bool floats, wire::Sense& out) const {
  write_senses(sense_, floats, out);
  out.set_tick(tick_);
}

void LinkedRobot::write_no_truth(wire::Sense& out) {
  out.clear_truth_values();
  out.clear_rows();
  out.clear_done();
  out.mutable_movers()->Clear();
}

void LinkedRobot::write_truth(RowsTold& told, wire::Sense& out) const {
  write_no_truth(out);
  if (!has_truth()) return;
  link::write_truth(*witness_, application_.robots(), out);
  told.tell(*witness_, application_.robots(), out);
}

}  // namespace ganglion::link
