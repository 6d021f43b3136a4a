#include "ganglion/graph/shapes.h"

#include <algorithm>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

/// The input whose wires an output of many values has one for: the candidates, or else the first that takes many.
int many_input(const ComponentModel& component) noexcept {
  const auto ports = component.ports();
  int first = -1;
  for (std::size_t p = 0; p < ports.size(); ++p) {
    if (ports[p].role == PortRole::Candidate) return static_cast<int>(p);
    const bool input = is_input(component.component_class, ports[p].role);
    if (input && ports[p].many && first < 0) first = static_cast<int>(p);
  }
  return first;
}

/// Names of that input's wires.
std::vector<std::string> candidate_names(const ComponentModel& component) {
  std::vector<std::string> names;
  const Wire* wire = component.wire(many_input(component));
  if (wire == nullptr) return names;
  for (const Source& source : wire->sources) names.push_back(source.text.substr(0, source.text.find('@')));
  return names;
}

OutputShape shape_of(const PortDescriptor& port, const ComponentModel& component, bool declared) {
  OutputShape shape{
      std::string(port.name), std::string(port.unit), port.type, {}, declared, port.derived, port.meaning};
  if (port.many) {
    shape.elements = candidate_names(component);
  } else if (!port.elements.empty()) {
    shape.elements = element_names(port);
  } else if (port.size > 1) {
    for (int i = 0; i < port.size; ++i) shape.elements.push_back(std::to_string(i));
  }
  return shape;
}

void shape_sensation(ComponentModel& component, const Description& robot) {
  OutputShape values{"", "", ValueType::Real, {}, true};
  if (component.channel_index >= 0) {
    const SensationChannel& channel = robot.sensations[static_cast<std::size_t>(component.channel_index)];
    values = {"", channel.unit, channel.type, channel.elements, true};
  }
  component.outputs = {std::move(values), {"age_s", "s", ValueType::Real, {}, false}};
}

void shape(ComponentModel& component, const Description& robot) {
  component.outputs.clear();
  if (component.component_class == ComponentClass::Sensation) {
    shape_sensation(component, robot);
    return;
  }
  for (const PortDescriptor& port : component.ports()) {
    if (port.role == PortRole::Output) component.outputs.push_back(shape_of(port, component, true));
  }
  for (const PortDescriptor& port : common_outputs(component.component_class, component.ports())) {
    component.outputs.push_back(shape_of(port, component, false));
  }
  for (const PortDescriptor& port : component.ports()) {
    if (port.role == PortRole::Appraisal && component.component_class == ComponentClass::Acting) {
      component.outputs.push_back(shape_of(port, component, false));
    }
  }
}

bool open_size(const PortDescriptor& port) noexcept { return port.size == 0 && port.elements.empty() && !port.many; }
bool open_unit(const PortDescriptor& port) noexcept { return port.unit == "*"; }
bool open(const PortDescriptor& port) noexcept { return open_size(port) || open_unit(port); }

/// Gives open outputs the shape of what is wired to the component's first open input.
class Adoption {
 public:
  Adoption(ControllerModel& model, const Description& robot, const ComponentIndex& ids)
      : model_(model), robot_(robot), ids_(ids), settled_(model.components.size(), false) {}

  void run() {
    for (std::size_t i = 0; i < model_.components.size(); ++i) settle(static_cast<int>(i));
  }

 private:
  /// Follows the wires back to the first shape that is known; a loop of open shapes stays as it is.
  void settle(int start) {
    std::vector<int> chain;
    for (int at = start; at >= 0 && !settled_[static_cast<std::size_t>(at)]; at = giver(at)) {
      settled_[static_cast<std::size_t>(at)] = true;
      chain.push_back(at);
    }
    for (auto at = chain.rbegin(); at != chain.rend(); ++at) adopt(model_.components[static_cast<std::size_t>(*at)]);
  }

  static const Source* wire_of(const ComponentModel& component) {
    if (component.descriptor == nullptr) return nullptr;
    const auto ports = component.ports();
    const bool any = std::any_of(ports.begin(), ports.end(), [](const PortDescriptor& port) {
      return port.role == PortRole::Output && open(port);
    });
    if (!any) return nullptr;
    for (std::size_t p = 0; p < ports.size(); ++p) {
      if (ports[p].role != PortRole::Feedback || !open(ports[p])) continue;
      const Wire* wire = component.wire(static_cast<int>(p));
      return wire != nullptr && !wire->sources.empty() ? &wire->sources.front() : nullptr;
    }
    return nullptr;
  }

  int giver(int at) const {
    const Source* source = wire_of(model_.components[static_cast<std::size_t>(at)]);
    return source != nullptr ? find(ids_, parts_of(*source).front()) : -1;
  }

  static std::vector<std::string> parts_of(const Source& source) {
    return split(std::string_view(source.text).substr(0, source.text.find('@')), '.');
  }

  void adopt(ComponentModel& component) const {
    const Source* source = wire_of(component);
    if (source == nullptr) return;
    const std::vector<std::string> parts = parts_of(*source);
    const int from = find(ids_, parts.front());
    const OutputShape given = from >= 0 ? given_by(model_.components[static_cast<std::size_t>(from)], parts)
                                        : command_shape(robot_.command(parts.front()), parts.size());
    std::size_t output = 0;
    for (const PortDescriptor& port : component.ports()) {
      if (port.role != PortRole::Output) continue;
      OutputShape& shape = component.outputs[output++];
      if (open_size(port)) shape.elements = given.elements;
      if (open_unit(port)) shape.unit = given.unit;
    }
  }

  static OutputShape given_by(const ComponentModel& from, const std::vector<std::string>& parts) {
    const bool sensation = from.component_class == ComponentClass::Sensation;
    for (const OutputShape& output : from.outputs) {
      const bool meant = parts.size() == 1 ? output.declared : output.name == parts[1];
      if (meant && parts.size() <= (sensation ? 1u : 2u)) return output;
      if (meant || (sensation && output.name.empty() && parts[1] != "age_s")) {
        return {"", output.unit, output.type, {}, true};  // one element of several
      }
    }
    return {"", "s", ValueType::Real, {}, true};  // an age; what is mistyped is reported with its wire
  }

  static OutputShape command_shape(const CommandChannel* channel, std::size_t parts) {
    OutputShape shape{"", "", ValueType::Real, {}, true};
    if (channel == nullptr || channel->elements.empty()) return shape;
    shape.unit = channel->elements.front().unit;
    if (parts > 1 || channel->elements.size() == 1) return shape;
    for (const CommandElement& element : channel->elements) shape.elements.push_back(element.name);
    return shape;
  }

  ControllerModel& model_;
  const Description& robot_;
  const ComponentIndex& ids_;
  std::vector<bool> settled_;
};

}  // namespace

ComponentIndex ids_of(const ControllerModel& model) {
  ComponentIndex ids;
  for (std::size_t i = 0; i < model.components.size(); ++i) ids.emplace(model.components[i].id, static_cast<int>(i));
  return ids;
}

int find(const ComponentIndex& ids, std::string_view id) noexcept {
  const auto found = ids.find(id);
  return found == ids.end() ? -1 : found->second;
}

bool shape_outputs(ControllerModel& model, const Description& robot, const ComponentIndex& ids, Problems& problems) {
  std::size_t values = 0;
  for (ComponentModel& component : model.components) {
    shape(component, robot);
    for (const OutputShape& output : component.outputs) values += static_cast<std::size_t>(output.size());
    if (values <= kMaxValues) continue;
    problems.add(
        component.place, ErrorCode::TooLarge,
        {"{}: with it the signals have more than {} values", "{}: con él las señales tienen más de {} valores"},
        component.id, kMaxValues);
    return false;
  }
  Adoption(model, robot, ids).run();
  return true;
}

}  // namespace ganglion
