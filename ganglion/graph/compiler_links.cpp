// What each component reads and writes: the places it is bound to.
#include <algorithm>
#include <limits>

#include "ganglion/graph/compiler.h"

namespace ganglion {

void Compiler::connect(std::size_t index) {
  const ComponentModel& model = model_.components[index];
  Part& part = controller_.parts_[index];
  layout::Block& block = *controller_.block_;
  if (model.descriptor == nullptr) return;
  for (const InputStretch& input : inputs_[index]) {
    part.views.push_back({std::span<const double>(block.now).subspan(input.first, input.count),
                          std::span<const double>(block.ages).subspan(input.age_first, input.ages)});
  }
  Links links;
  for (std::size_t o = 0; o < model.outputs.size(); ++o) {
    const OutputShape& output = model.outputs[o];
    const auto span = std::span<double>(block.now).subspan(part.outputs_at[o], static_cast<std::size_t>(output.size()));
    if (output.declared) part.outputs.push_back(span);
    const PortDescriptor* port = model.port(output.name);
    if (port != nullptr && port->role == PortRole::Appraisal) links.appraisal = span;
  }
  std::fill(links.appraisal.begin(), links.appraisal.end(), std::numeric_limits<double>::quiet_NaN());
  links.inputs = part.views;
  links.outputs = part.outputs;
  links.stream = {identity_.seed, identity_.episode, identity_.robot, hash_name(model.id)};
  if (part.as<layout::CoordinatorRole>() != nullptr) connect_candidates(index);
  part.component->bind(links);
  if (part.as<layout::ActingRole>() != nullptr) connect_acting(index);
}

void Compiler::connect_acting(std::size_t index) {
  const ComponentModel& model = model_.components[index];
  auto& acting = *controller_.parts_[index].as<layout::ActingRole>();
  ActingLinks joints;
  std::size_t input = 0;
  bool satisfied_found = false;
  for (std::size_t p = 0; p < model.ports().size(); ++p) {
    const PortDescriptor& port = model.ports()[p];
    if (!is_input(model.component_class, port.role)) continue;
    if (port.role == PortRole::Feedback && !satisfied_found) {
      satisfied_found = true;
      joints.satisfied_by = input;
      joints.comparison = model.comparison;
    }
    ++input;
    if (port.role == PortRole::Request) connect_request(index, p);
  }
  for (const ReasonDescriptor& reason : model.descriptor->reasons) acting.likes.push_back(reason.like);
  joints.request = acting.request.get();
  joints.likes = acting.likes;
  acting.module->join(joints);
}

void Compiler::connect_candidates(std::size_t index) {
  auto& coordinator = *controller_.parts_[index].as<layout::CoordinatorRole>();
  for (const Wire& wire : model_.components[index].wires) {
    for (const Source& source : wire.sources) {
      if (source.kind != Source::Kind::ModuleCommand) continue;
      const Part& from = part(source.component);
      const auto* acting = from.as<layout::ActingRole>();
      coordinator.candidates.push_back(acting != nullptr ? &acting->module->command()
                                                         : &from.as<layout::CoordinatorRole>()->command);
      coordinator.candidate_parts.push_back(source.component);
      taker_[static_cast<std::size_t>(source.component)] = static_cast<int>(index);
    }
  }
  coordinator.shares.assign(coordinator.candidates.size(), 0);
}

}  // namespace ganglion
