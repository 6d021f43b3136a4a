#include "ganglion/module/tick/acting_cycle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ganglion {

void ActingCycle::settle(std::optional<double> frame_cost) noexcept {
  last_cost_ = std::nullopt;
  if (joints_.below == nullptr) {
    if (share_ == 1 && command_.kind == CommandKind::Act) last_cost_ = frame_cost;
  } else if (!interrupted()) {
    last_cost_ = joints_.below->total_cost();
  }
  if (joints_.request == nullptr) return;
  if (joints_.request->status == RequestStatus::Pending) settle_request();
  joints_.request->lost = joints_.request->status == RequestStatus::Satisfied && holds_no_more();
}

/// A reading that is missing shows nothing.
bool ActingCycle::holds_no_more() const noexcept {
  const std::span<const double> reading = inputs_[joints_.satisfied_by].values;
  return std::all_of(reading.begin(), reading.end(), [](double value) { return std::isfinite(value); }) &&
         !equal_within(reading, sought_.span(), joints_.comparison);
}

void ActingCycle::settle_request() noexcept {
  RequestSlot& request = *joints_.request;
  ++request.ticks;
  std::optional<double> spent = last_cost_;
  if (request.standing) {
    request.cost = spent.value_or(0);
    request.has_cost = spent.has_value();
    return;
  }
  const bool seen = request.serial == seen_serial_;  // else nobody knows yet what it means
  if (seen && equal_within(inputs_[joints_.satisfied_by].values, sought_.span(), joints_.comparison)) {
    request.status = RequestStatus::Satisfied;
    ++request.concluded;
    if (interrupted()) spent = joints_.below->total_cost();  // nothing is learned from it, yet it was paid
  }
  if (spent) {
    request.cost += *spent;
    request.has_cost = true;
  }
}

bool ActingCycle::waits() const noexcept {
  if (!interrupted()) return false;
  // An ended or replaced request frees the module at once: what is under way below serves nobody.
  return joints_.request == nullptr ||
         (joints_.request->status == RequestStatus::Pending && joints_.request->serial == seen_serial_);
}

void ActingCycle::cycle(const Tick& tick) noexcept {
  const Request request = get_request();
  const Feedback feedback = get_feedback(tick);
  if (request.fresh) seek(request, feedback, sought_);
  if (const auto cost = get_cost()) internal_adaptation(feedback, *cost);
  const bool asked = joints_.request == nullptr || request.present();
  const Command command = asked ? internal_propagation(request, feedback) : unasked();
  settled_ = standing() && request.present() && settled(request, feedback);
  send_appraisal();
  send_command(command);
}

/// A module that has given up goes on saying so until it is asked anew: it waits for help.
Command ActingCycle::unasked() const noexcept {
  const bool given_up = joints_.request->status == RequestStatus::Withdrawn;
  return given_up ? Command::withdraw(joints_.request->reason) : Command::inactive();
}

Request ActingCycle::get_request() noexcept {
  const RequestSlot* slot = joints_.request;
  if (slot == nullptr || slot->status != RequestStatus::Pending) return {};
  const bool fresh = slot->serial != seen_serial_;
  seen_serial_ = slot->serial;
  return {slot->span(), fresh};
}

Feedback ActingCycle::get_feedback(const Tick& tick) const noexcept {
  Feedback feedback{tick, inputs_, interrupted() ? 0 : share_};
  const RequestSlot* answer = joints_.below != nullptr ? joints_.below : joints_.answer;
  if (answer != nullptr && share_ > 0 && command_.kind == CommandKind::Act) {
    feedback.outcome = answer->status;
    if (answer->status == RequestStatus::Withdrawn) feedback.reason = answer->reason.common();
  }
  return feedback;
}

bool ActingCycle::interrupted() const noexcept {
  return joints_.below != nullptr && !joints_.below->standing && joints_.below->status == RequestStatus::Pending;
}

std::optional<Cost> ActingCycle::get_cost() const noexcept {
  return last_cost_ ? std::optional<Cost>(Cost{*last_cost_}) : std::nullopt;
}

void ActingCycle::seek(const Request& fresh, const Feedback&, Sought& into) const noexcept { into.set(fresh.values); }

bool ActingCycle::settled(const Request&, const Feedback&) const noexcept {
  return equal_within(inputs_[joints_.satisfied_by].values, sought_.span(), joints_.comparison);
}

void ActingCycle::expected_feedback(std::span<double> appraisal) const noexcept {
  std::fill(appraisal.begin(), appraisal.end(), std::numeric_limits<double>::quiet_NaN());
}

void ActingCycle::send_appraisal() const noexcept {
  if (!appraisal_.empty()) expected_feedback(appraisal_);
}

void ActingCycle::send_command(const Command& command) noexcept {
  command_ = command;
  share_ = 1;
  if (standing()) command_.ttl_s = std::min(command_.ttl_s, joints_.request->ttl_s);
  if (command_.kind == CommandKind::Withdraw) {
    Reason& reason = command_.reason;
    const auto own = static_cast<std::size_t>(static_cast<std::uint16_t>(reason.code)) - kFirstOwnReason;
    if (is_own(reason.code) && own < joints_.likes.size()) reason.like = joints_.likes[own];
    if (joints_.request != nullptr) joints_.request->withdraw(reason);
  }
  if (joints_.below != nullptr) send_below();
}

void ActingCycle::send_below() noexcept {
  RequestSlot& below = *joints_.below;
  if (command_.kind == CommandKind::Act) {
    if (below.standing) {
      below.keep_asking(command_.span(), command_.ttl_s);
    } else {
      below.ask(command_.span());
    }
  } else {
    below.clear();
    if (command_.kind == CommandKind::Withdraw) below.withdraw(command_.reason);  // so the application hears why
  }
}

}  // namespace ganglion
