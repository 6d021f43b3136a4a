// What each component reads and writes: the places it is bound to.
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
    if (port.role == PortRole::Request) connect_request(index, p);
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

}  // namespace ganglion
