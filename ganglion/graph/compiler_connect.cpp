#include <algorithm>
#include <limits>

#include "ganglion/graph/compiler.h"

namespace ganglion {

void Compiler::connect(std::size_t index) {
  const ComponentModel& model = model_.components[index];
  Part& part = controller_.parts_[index];
  Controller::Block& block = *controller_.block_;
  if (model.descriptor == nullptr) return;
  for (const InputStretch& input : inputs_[index]) {
    part.views.push_back({std::span<const double>(block.now).subspan(input.first, input.count),
                          std::span<const double>(block.ages).subspan(input.age_first, input.ages)});
  }
  Links links;
  std::size_t at = part.signals.first;
  for (const OutputShape& output : model.outputs) {
    const auto span = std::span<double>(block.now).subspan(at, static_cast<std::size_t>(output.size()));
    if (output.declared) part.outputs.push_back(span);
    at += span.size();
    const PortDescriptor* port = model.descriptor->port(output.name);
    if (port != nullptr && port->role == PortRole::Appraisal) links.appraisal = span;
  }
  std::fill(links.appraisal.begin(), links.appraisal.end(), std::numeric_limits<double>::quiet_NaN());
  links.inputs = part.views;
  links.outputs = part.outputs;
  links.stream = {identity_.seed, identity_.episode, identity_.robot, hash_name(model.id)};
  if (part.sensing) part.sensing->bind(links);
  if (part.goal) part.goal->bind(links);
  if (part.acting) connect_acting(index, links);
  if (part.coordinator) {
    connect_candidates(index);
    part.coordinator->bind(links);
  }
}

void Compiler::connect_acting(std::size_t index, const Links& links) {
  const ComponentModel& model = model_.components[index];
  Part& part = controller_.parts_[index];
  ActingLinks joints;
  std::size_t input = 0;
  bool satisfied_found = false;
  for (std::size_t p = 0; p < model.descriptor->ports.size(); ++p) {
    const PortDescriptor& port = model.descriptor->ports[p];
    if (!is_input(model.component_class, port.role)) continue;
    if (port.role == PortRole::Feedback && !satisfied_found) {
      satisfied_found = true;
      joints.satisfied_by = input;
      joints.circular = port.type == ValueType::Circular;
    }
    ++input;
    if (port.role != PortRole::Request) continue;
    if (!part.request) part.request = std::make_unique<RequestSlot>();
    part.request->width = port.elements.empty() ? port.size : static_cast<int>(port.elements.size());
    const Wire* wire = model.wire(static_cast<int>(p));
    if (wire == nullptr) continue;
    std::vector<GlobalGoal*> goals;
    for (const Source& source : wire->sources) {
      Controller::Part& from = this->part(source.component);
      if (source.kind == Source::Kind::Goal) goals.push_back(from.goal.get());
      if (source.kind != Source::Kind::ModuleCommand) continue;
      from.below = part.request.get();
      asked_[static_cast<std::size_t>(source.component)] = static_cast<int>(index);
    }
    if (!goals.empty()) part.arbiter.emplace(std::move(goals), model.preemption);
  }
  joints.request = part.request.get();
  joints.tolerance = model.tolerance;
  part.acting->bind(links);
  part.acting->join(joints);
}

void Compiler::connect_candidates(std::size_t index) {
  Part& part = controller_.parts_[index];
  for (const Wire& wire : model_.components[index].wires) {
    for (const Source& source : wire.sources) {
      if (source.kind != Source::Kind::ModuleCommand) continue;
      const Part& from = this->part(source.component);
      part.candidates.push_back(from.acting ? &from.acting->command() : &from.command);
      part.candidate_parts.push_back(source.component);
      taker_[static_cast<std::size_t>(source.component)] = static_cast<int>(index);
    }
  }
  part.shares.assign(part.candidates.size(), 0);
}

/// A module whose command a coordinator makes a request of another module hears what becomes of it, and pays what that
/// module pays.
void Compiler::connect_answers() {
  for (std::size_t i = 0; i < controller_.parts_.size(); ++i) {
    Part& part = controller_.parts_[i];
    if (!part.acting) continue;
    if (part.below != nullptr) part.acting->set_below(part.below);
    if (taker_[i] < 0) continue;
    auto last = static_cast<std::size_t>(taker_[i]);
    while (taker_[last] >= 0) last = static_cast<std::size_t>(taker_[last]);  // no circle: the order was found
    if (asked_[last] < 0) continue;
    part.charged_by = asked_[last];
    part.acting->set_answer(this->part(part.charged_by).request.get());
  }
}

void Compiler::join_digest() {
  for (Part& part : controller_.parts_) part.digest = controller_.digest_.join(identity_.robot, part.id);
  controller_.command_digest_ = controller_.digest_.join(identity_.robot, "@commands");
}

Result<Controller> Controller::compile(const ControllerModel& model, const RobotDescription& robot,
                                       const KindList& kinds, const Identity& identity) {
  return Compiler(model, robot, kinds, identity).run();
}

}  // namespace ganglion
