// Where every value, age and input of a controller stands.
#include <algorithm>
#include <limits>

#include "ganglion/graph/commands.h"
#include "ganglion/graph/compiler.h"
#include "ganglion/graph/loops.h"

namespace ganglion {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// Where the values of a wire come from: its first value and the index of its age.
struct Origin {
  std::size_t value, age;
};

/// What the values of its command are called: as its own port says, or else as the robot's command does.
std::vector<std::string> command_elements(const ComponentModel& model, const Description& robot) {
  std::vector<std::string> names;
  int size = 0;
  for (const PortDescriptor& port : model.ports()) {
    if (port.role != PortRole::Command) continue;
    for (const ElementDescriptor& element : port.elements) names.emplace_back(element.name);
    size = port.size;
  }
  if (names.empty() && model.command_index >= 0) {
    for (const auto& element : robot.commands[static_cast<std::size_t>(model.command_index)].elements) {
      names.push_back(element.name);
    }
    return names;
  }
  for (int i = static_cast<int>(names.size()); i < size; ++i) names.push_back(std::to_string(i));
  return names;
}

/// Of each element of a robot's command the value of the writer's that is meant for it: the one of its name, where the
/// writer names them.
std::vector<std::size_t> order_of(const CommandChannel& channel, const ComponentModel* writer) {
  std::vector<std::size_t> order;
  const PortDescriptor* port = writer != nullptr ? writer->port_of(PortRole::Command) : nullptr;
  for (std::size_t i = 0; i < channel.elements.size(); ++i) {
    std::size_t from = i;
    for (std::size_t n = 0; port != nullptr && n < port->elements.size(); ++n) {
      if (port->elements[n].name == channel.elements[i].name) from = n;
    }
    order.push_back(from);
  }
  return order;
}

}  // namespace

void Compiler::lay_out_signals() {
  for (std::size_t i = 0; i < model_.components.size(); ++i) {
    const ComponentModel& model = model_.components[i];
    Part& part = controller_.parts_[i];
    part.signals.first = controller_.signals_.size();
    part.out_ages = {ages_, model.outputs.size()};
    ages_ += model.outputs.size();
    part.outputs_at.resize(model.outputs.size());
    lay_out_outputs(model, part, false);
    if (makes_commands(model)) {
      part.command_signals.first = controller_.signals_.size();
      for (const std::string& element : command_elements(model, robot_)) {
        add_signal(model.id + ".command." + element, "");
        ++part.command_signals.count;
      }
    }
    part.digested = controller_.signals_.size() - part.signals.first;
    lay_out_outputs(model, part, true);
    part.signals.count = controller_.signals_.size() - part.signals.first;
    find_common(model, part);
  }
}

/// Those that are derived come last: they are in no digest.
void Compiler::lay_out_outputs(const ComponentModel& model, Part& part, bool derived) {
  for (std::size_t o = 0; o < model.outputs.size(); ++o) {
    const OutputShape& output = model.outputs[o];
    if (output.derived != derived) continue;
    part.outputs_at[o] = controller_.signals_.size();
    const std::string name = output.name.empty() ? model.id : model.id + "." + output.name;
    if (output.elements.empty()) add_signal(name, output.unit, output.meaning);
    for (const std::string& element : output.elements) add_signal(name + "." + element, output.unit, output.meaning);
  }
}

void Compiler::find_common(const ComponentModel& model, Part& part) const {
  if (model.descriptor == nullptr) return;
  for (const PortDescriptor& port : common_outputs(model.component_class, model.ports())) {
    for (std::size_t o = 0; o < model.outputs.size(); ++o) {
      if (!model.outputs[o].declared && model.outputs[o].name == port.name)
        part.common_at.push_back(part.outputs_at[o]);
    }
  }
}

void Compiler::lay_out_commands() {
  controller_.sense_values_ = static_cast<std::size_t>(robot_.sensation_values());
  controller_.sense_channels_ = robot_.sensations.size();
  controller_.command_frame_.first = controller_.signals_.size();
  for (std::size_t c = 0; c < robot_.commands.size(); ++c) {
    const CommandChannel& channel = robot_.commands[c];
    layout::ChannelOut out;
    out.offset = static_cast<std::size_t>(robot_.command_offset(c));
    out.elements = channel.elements;
    for (std::size_t i = 0; i < model_.components.size(); ++i) {
      if (model_.components[i].command_index == static_cast<int>(c)) out.writer = static_cast<int>(i);
    }
    out.from = order_of(channel, out.writer >= 0 ? &model_.components[static_cast<std::size_t>(out.writer)] : nullptr);
    for (const CommandElement& element : channel.elements) add_signal(channel.name + "." + element.name, element.unit);
    controller_.channels_.push_back(std::move(out));
  }
  controller_.command_frame_.count = controller_.signals_.size() - controller_.command_frame_.first;
  values_ = controller_.signals_.size();
}

void Compiler::lay_out_inputs() {
  loops_ = loops_of(model_);
  command_age_ = ages_++;
  inputs_.resize(model_.components.size());
  for (std::size_t i = 0; i < model_.components.size(); ++i) {
    const ComponentModel& model = model_.components[i];
    if (model.descriptor == nullptr) continue;
    const auto ports = model.ports();
    for (std::size_t p = 0; p < ports.size(); ++p) {
      if (!is_input(model.component_class, ports[p].role)) continue;
      const std::size_t first = values_, age_first = ages_;
      if (const Wire* wire = model.wire(static_cast<int>(p))) {
        for (const Source& source : wire->sources) lay_out_wire(i, ports[p], source);
      }
      inputs_[i].push_back({first, values_ - first, age_first, ages_ - age_first});
    }
  }
}

void Compiler::lay_out_wire(std::size_t index, const PortDescriptor& port, const Source& source) {
  if (source.size == 0) return;  // goals and commands do not travel by value
  Part& part = controller_.parts_[index];
  Origin origin{};
  if (source.kind == Source::Kind::RobotCommand) {
    const auto channel = static_cast<std::size_t>(source.component);
    origin = {controller_.command_frame_.first + static_cast<std::size_t>(robot_.command_offset(channel)),
              command_age_};
  } else {
    const Part& from = controller_.parts_[static_cast<std::size_t>(source.component)];
    std::size_t output = 0;
    if (source.kind == Source::Kind::Output) output = static_cast<std::size_t>(source.port);
    if (source.kind == Source::Kind::SensationAge) output = 1;
    origin = {from.outputs_at[output], from.out_ages.first + output};
  }
  if (source.element > 0) origin.value += static_cast<std::size_t>(source.element);
  const auto count = static_cast<std::size_t>(source.size);
  part.gather.push_back({values_, origin.value, count, ages_, origin.age, source.previous});
  // Neither an expectation nor a percept's own past, come back by a loop, is a reading that ages it.
  const bool loop = source.kind == Source::Kind::Output && source.previous &&
                    loops_[static_cast<std::size_t>(source.component)] == loops_[index];
  auto* sensing = part.as<layout::SensingRole>();
  if (sensing != nullptr && port.role != PortRole::Appraisal && !loop) sensing->aged_by.push_back(ages_);
  values_ += count;
  ++ages_;
}

void Compiler::reserve() {
  layout::Block& block = *controller_.block_;
  block.now.assign(values_, kMissing);
  block.ages.assign(ages_, std::numeric_limits<double>::infinity());
  for (const Part& part : controller_.parts_) {
    if (part.as<layout::SensationRole>() != nullptr || part.as<layout::SensingRole>() != nullptr) continue;
    for (std::size_t i = 0; i < part.signals.count; ++i) block.now[part.signals.first + i] = 0;
  }
  block.ages[command_age_] = 0;
  const ActFrame safe = make_act_frame(robot_);
  std::copy(safe.values.begin(), safe.values.end(),
            block.now.begin() + static_cast<std::ptrdiff_t>(controller_.command_frame_.first));
  block.ages_before = block.ages;
}

}  // namespace ganglion
