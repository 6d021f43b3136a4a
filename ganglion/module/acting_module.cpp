#include "ganglion/module/acting_module.h"

#include <algorithm>
#include <limits>

namespace ganglion {

void ActingModule::settle(std::optional<double> frame_cost) noexcept {
  last_cost_ = std::nullopt;
  if (joints_.below == nullptr) {
    if (granted_ && command_.kind == CommandKind::Act) last_cost_ = frame_cost;
  } else if (!interrupted()) {
    last_cost_ = joints_.below->total_cost();
  }
  RequestSlot* request = joints_.request;
  if (request == nullptr || request->status != RequestStatus::Pending) return;
  ++request->ticks;
  std::optional<double> spent = last_cost_;
  const PortView& reached = links().inputs[joints_.satisfied_by];
  if (equal_within(reached.values, request->span(), joints_.tolerance, joints_.circular)) {
    request->status = RequestStatus::Satisfied;
    if (interrupted()) spent = joints_.below->total_cost();  // nothing is learned from it, yet it was paid
  }
  if (spent) {
    request->cost += *spent;
    request->has_cost = true;
  }
}

bool ActingModule::waits() const noexcept {
  if (joints_.below == nullptr || joints_.below->status != RequestStatus::Pending) return false;
  // An ended or replaced request frees the module at once: what is under way below serves nobody.
  return joints_.request == nullptr ||
         (joints_.request->status == RequestStatus::Pending && joints_.request->serial == seen_serial_);
}

void ActingModule::cycle(const Tick& tick) noexcept {
  const Request request = get_request();
  const Feedback feedback = get_feedback(tick);
  if (const auto cost = get_cost()) internal_adaptation(feedback, *cost);
  const bool asked = joints_.request == nullptr || request.present();
  const Command command = asked ? internal_propagation(request, feedback) : unasked();
  send_appraisal();
  send_command(command);
}

/// A module that has given up goes on saying so until it is asked anew: it waits for help.
Command ActingModule::unasked() const noexcept {
  const bool given_up = joints_.request->status == RequestStatus::Withdrawn;
  return given_up ? Command::withdraw(joints_.request->reason) : Command::inactive();
}

Request ActingModule::get_request() noexcept {
  const RequestSlot* slot = joints_.request;
  if (slot == nullptr || slot->status != RequestStatus::Pending) return {};
  const bool fresh = slot->serial != seen_serial_;
  seen_serial_ = slot->serial;
  return {slot->span(), fresh};
}

Feedback ActingModule::get_feedback(const Tick& tick) const noexcept {
  Feedback feedback{tick, links().inputs, granted_ && !interrupted()};
  const RequestSlot* answer = joints_.below != nullptr ? joints_.below : joints_.answer;
  if (answer != nullptr && granted_ && command_.kind == CommandKind::Act) {
    feedback.outcome = answer->status;
    if (answer->status == RequestStatus::Withdrawn) feedback.reason = answer->reason;
  }
  return feedback;
}

bool ActingModule::interrupted() const noexcept {
  return joints_.below != nullptr && joints_.below->status == RequestStatus::Pending;
}

std::optional<Cost> ActingModule::get_cost() const noexcept {
  return last_cost_ ? std::optional<Cost>(Cost{*last_cost_}) : std::nullopt;
}

void ActingModule::expected_feedback(std::span<double> appraisal) const noexcept {
  std::fill(appraisal.begin(), appraisal.end(), std::numeric_limits<double>::quiet_NaN());
}

void ActingModule::send_appraisal() const noexcept {
  if (!links().appraisal.empty()) expected_feedback(links().appraisal);
}

void ActingModule::send_command(const Command& command) noexcept {
  command_ = command;
  granted_ = true;
  if (command.kind == CommandKind::Withdraw && joints_.request != nullptr) joints_.request->withdraw(command.reason);
  if (joints_.below == nullptr) return;
  if (command.kind == CommandKind::Act) {
    joints_.below->ask(command.span());
  } else {
    joints_.below->clear();
    if (command.kind == CommandKind::Withdraw) joints_.below->withdraw(command.reason);  // so the application hears why
  }
}

}  // namespace ganglion
