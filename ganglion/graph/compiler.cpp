#include <algorithm>
#include <limits>

#include "ganglion/graph/controller.h"

namespace ganglion {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// Lays a resolved model out as a Controller.
class Compiler {
 public:
  Compiler(const ControllerModel& model, const RobotDescription& robot, const KindList& kinds, const Identity& identity)
      : model_(model), robot_(robot), kinds_(kinds), identity_(identity) {}

  Result<Controller> run() {
    Problems problems;
    controller_.schedule_ = order(model_, problems);
    if (!problems.empty()) return tl::unexpected<Error>(problems.sorted().front());
    for (const ComponentModel& model : model_.components) {
      if (auto made = make_part(model); !made) return tl::unexpected<Error>(made.error());
    }
    lay_out_signals();
    lay_out_commands();
    lay_out_inputs();
    reserve();
    for (std::size_t i = 0; i < model_.components.size(); ++i) connect(i);
    join_digest();
    controller_.grow();
    return std::move(controller_);
  }

 private:
  using Part = Controller::Part;

  Result<void> make_part(const ComponentModel& model);
  void lay_out_signals();
  void lay_out_commands();
  void lay_out_inputs();
  void lay_out_wire(Part& part, const Source& source);
  void reserve();
  void connect(std::size_t index);
  void connect_acting(std::size_t index, const Links& links);
  void connect_candidates(Part& part, const ComponentModel& model);
  void join_digest();
  std::size_t add_signal(const std::string& name, const std::string& unit) {
    controller_.signals_.push_back({name, unit});
    return controller_.signals_.size() - 1;
  }
  Part& part(int index) { return controller_.parts_[static_cast<std::size_t>(index)]; }

  const ControllerModel& model_;
  const RobotDescription& robot_;
  const KindList& kinds_;
  Identity identity_;
  Controller controller_;
  std::size_t values_ = 0, ages_ = 0;
  std::size_t command_age_ = 0;  // one for the whole command frame
  struct InputStretch {
    std::size_t first, count, age_first, ages;
  };
  std::vector<std::vector<InputStretch>> inputs_;  // for each component, for each input of its descriptor
};

template <class Product>
Result<void> make(std::span<const Kind<Product>* const> kinds, const ComponentModel& model,
                  std::unique_ptr<Product>& into) {
  const auto* kind = find_kind(kinds, model.descriptor->name);
  expects(kind != nullptr);
  auto made = kind->make(model.parameters);
  if (!made) {
    Error error = made.error();
    error.message = model.id + ": " + error.message;
    if (error.place.file.empty()) error.place = model.place;
    return tl::unexpected<Error>(std::move(error));
  }
  into = std::move(*made);
  return {};
}

Result<void> Compiler::make_part(const ComponentModel& model) {
  Part part;
  part.id = model.id;
  part.component_class = model.component_class;
  if (model.descriptor != nullptr) part.kind = model.descriptor->name;
  Result<void> made;
  switch (model.component_class) {
    case ComponentClass::Sensing:
      made = make(kinds_.sensing, model, part.sensing);
      break;
    case ComponentClass::Goal:
      made = make(kinds_.goal, model, part.goal);
      break;
    case ComponentClass::Acting:
      made = make(kinds_.acting, model, part.acting);
      break;
    case ComponentClass::Coordinator:
      made = make(kinds_.coordinator, model, part.coordinator);
      break;
    default:
      part.channel = static_cast<std::size_t>(model.channel_index);
      part.frame_offset = static_cast<std::size_t>(robot_.sensation_offset(part.channel));
  }
  controller_.parts_.push_back(std::move(part));
  return made;
}

std::vector<std::string> command_elements(const ComponentModel& model, const RobotDescription& robot) {
  std::vector<std::string> names;
  if (model.command_index >= 0) {
    for (const auto& element : robot.commands[static_cast<std::size_t>(model.command_index)].elements) {
      names.push_back(element.name);
    }
    return names;
  }
  for (const PortDescriptor& port : model.descriptor->ports) {
    if (port.role != PortRole::Command) continue;
    names.assign(port.elements.begin(), port.elements.end());
    for (int i = static_cast<int>(names.size()); i < port.size; ++i) names.push_back(std::to_string(i));
  }
  return names;
}

void Compiler::lay_out_signals() {
  for (std::size_t i = 0; i < model_.components.size(); ++i) {
    const ComponentModel& model = model_.components[i];
    Part& part = controller_.parts_[i];
    part.signals.first = controller_.signals_.size();
    part.out_ages = {ages_, model.outputs.size()};
    ages_ += model.outputs.size();
    bool common_found = false;
    for (const OutputShape& output : model.outputs) {
      if (!output.declared && !common_found) part.common = controller_.signals_.size();
      common_found = common_found || !output.declared;
      const std::string name = output.name.empty() ? model.id : model.id + "." + output.name;
      if (output.elements.empty()) add_signal(name, output.unit);
      for (const std::string& element : output.elements) add_signal(name + "." + element, output.unit);
    }
    if (part.acting || part.coordinator) {
      part.command_signals.first = controller_.signals_.size();
      for (const std::string& element : command_elements(model, robot_)) {
        add_signal(model.id + ".command." + element, "");
        ++part.command_signals.count;
      }
    }
    part.signals.count = controller_.signals_.size() - part.signals.first;
  }
}

void Compiler::lay_out_commands() {
  controller_.command_frame_.first = controller_.signals_.size();
  for (std::size_t c = 0; c < robot_.commands.size(); ++c) {
    const CommandChannel& channel = robot_.commands[c];
    Controller::ChannelOut out;
    out.offset = static_cast<std::size_t>(robot_.command_offset(c));
    out.elements = channel.elements;
    for (std::size_t i = 0; i < model_.components.size(); ++i) {
      if (model_.components[i].command_index == static_cast<int>(c)) out.writer = static_cast<int>(i);
    }
    for (const CommandElement& element : channel.elements) add_signal(channel.name + "." + element.name, element.unit);
    controller_.channels_.push_back(std::move(out));
  }
  controller_.command_frame_.count = controller_.signals_.size() - controller_.command_frame_.first;
  values_ = controller_.signals_.size();
}

void Compiler::lay_out_inputs() {
  command_age_ = ages_++;
  inputs_.resize(model_.components.size());
  for (std::size_t i = 0; i < model_.components.size(); ++i) {
    const ComponentModel& model = model_.components[i];
    Part& part = controller_.parts_[i];
    part.in_ages.first = ages_;
    if (model.descriptor == nullptr) continue;
    for (std::size_t p = 0; p < model.descriptor->ports.size(); ++p) {
      if (!is_input(model.component_class, model.descriptor->ports[p].role)) continue;
      const std::size_t first = values_, age_first = ages_;
      if (const Wire* wire = model.wire(static_cast<int>(p))) {
        for (const Source& source : wire->sources) lay_out_wire(part, source);
      }
      inputs_[i].push_back({first, values_ - first, age_first, ages_ - age_first});
    }
    part.in_ages.count = ages_ - part.in_ages.first;
  }
}

/// Where the values of a wire come from: its first value and the index of its age.
struct Origin {
  std::size_t value, age;
};

void Compiler::lay_out_wire(Part& part, const Source& source) {
  if (source.size == 0) return;  // goals and commands do not travel by value
  Origin origin{};
  if (source.kind == Source::Kind::RobotCommand) {
    const auto channel = static_cast<std::size_t>(source.component);
    origin = {controller_.command_frame_.first + static_cast<std::size_t>(robot_.command_offset(channel)),
              command_age_};
  } else {
    const Part& from = controller_.parts_[static_cast<std::size_t>(source.component)];
    const auto& outputs = model_.components[static_cast<std::size_t>(source.component)].outputs;
    std::size_t port = 0;
    if (source.kind == Source::Kind::Output) port = static_cast<std::size_t>(source.port);
    if (source.kind == Source::Kind::SensationAge) port = 1;
    origin = {from.signals.first, from.out_ages.first + port};
    for (std::size_t o = 0; o < port; ++o) origin.value += static_cast<std::size_t>(outputs[o].size());
  }
  if (source.element > 0) origin.value += static_cast<std::size_t>(source.element);
  const auto count = static_cast<std::size_t>(source.size);
  part.gather.push_back({values_, origin.value, count, ages_, origin.age, source.previous});
  values_ += count;
  ++ages_;
}

void Compiler::reserve() {
  Controller::Block& block = *controller_.block_;
  block.now.assign(values_, kMissing);
  block.ages.assign(ages_, std::numeric_limits<double>::infinity());
  for (const Part& part : controller_.parts_) {
    if (part.component_class == ComponentClass::Sensation || part.component_class == ComponentClass::Sensing) continue;
    for (std::size_t i = 0; i < part.signals.count; ++i) block.now[part.signals.first + i] = 0;
  }
  block.ages[command_age_] = 0;
  const ActFrame safe = make_act_frame(robot_);
  std::copy(safe.values.begin(), safe.values.end(),
            block.now.begin() + static_cast<std::ptrdiff_t>(controller_.command_frame_.first));
  block.before = block.now;
  block.ages_before = block.ages;
}

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
  links.inputs = part.views;
  links.outputs = part.outputs;
  links.stream = {identity_.seed, identity_.episode, identity_.robot, hash_name(model.id)};
  if (part.sensing) part.sensing->bind(links);
  if (part.goal) part.goal->bind(links);
  if (part.acting) connect_acting(index, links);
  if (part.coordinator) {
    connect_candidates(part, model);
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
      if (source.kind == Source::Kind::ModuleCommand) from.below = part.request.get();
    }
    if (!goals.empty()) part.arbiter.emplace(std::move(goals), model.preemption);
  }
  joints.request = part.request.get();
  joints.tolerance = model.tolerance;
  part.acting->bind(links);
  part.acting->join(joints);
}

void Compiler::connect_candidates(Part& part, const ComponentModel& model) {
  for (const Wire& wire : model.wires) {
    for (const Source& source : wire.sources) {
      if (source.kind != Source::Kind::ModuleCommand) continue;
      const Part& from = this->part(source.component);
      part.candidates.push_back(from.acting ? &from.acting->command() : &from.command);
      part.candidate_parts.push_back(source.component);
    }
  }
  part.shares.assign(part.candidates.size(), 0);
}

void Compiler::join_digest() {
  for (Part& part : controller_.parts_) {
    part.digest = controller_.digest_.join(identity_.robot, part.id);
    if (part.acting && part.below != nullptr) part.acting->set_below(part.below);
  }
  controller_.command_digest_ = controller_.digest_.join(identity_.robot, "@commands");
}

Result<Controller> Controller::compile(const ControllerModel& model, const RobotDescription& robot,
                                       const KindList& kinds, const Identity& identity) {
  return Compiler(model, robot, kinds, identity).run();
}

}  // namespace ganglion
