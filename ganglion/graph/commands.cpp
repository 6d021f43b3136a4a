#include "ganglion/graph/commands.h"

#include <map>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

std::vector<std::string> command_names(const RobotDescription& robot) {
  std::vector<std::string> names;
  for (const CommandChannel& channel : robot.commands) names.push_back(channel.name);
  return names;
}

std::vector<std::string> element_names(const CommandChannel& channel) {
  std::vector<std::string> names;
  for (const CommandElement& element : channel.elements) names.push_back(element.name);
  return names;
}

void check_elements(const ComponentModel& component, const CommandChannel& channel, Problems& problems) {
  const std::vector<std::string> wanted = element_names(channel);
  for (const PortDescriptor& port : component.descriptor->ports) {
    if (port.role != PortRole::Command || port.size == 0) continue;
    const std::vector<std::string> mine(port.elements.begin(), port.elements.end());
    if (mine.empty() ? static_cast<std::size_t>(port.size) == wanted.size() : mine == wanted) continue;
    report_wire(
        problems, component, component.command_place,
        fmt::format("commands {{{}}} but \"{}\" takes {{{}}}",
                    mine.empty() ? fmt::format("{} values", port.size) : join(mine), channel.name, join(wanted)));
  }
}

bool commands_or_requests(const ComponentModel& component, const Wire& wire) noexcept {
  const PortRole role = component.descriptor->ports[static_cast<std::size_t>(wire.port)].role;
  return role == PortRole::Candidate || role == PortRole::Request;
}

/// Where the commands go that do not go to the robot directly.
struct Takers {
  std::vector<std::string> of;  ///< For each component the one that takes its command or bids; "" = none.
  bool complete = true;         ///< Every wire for commands was understood.
};

Takers find_takers(const ControllerModel& model, Problems& problems) {
  Takers takers{std::vector<std::string>(model.components.size()), model.misread.empty()};
  for (const ComponentModel& component : model.components) {
    for (const Wire& wire : component.wires) {
      for (const Source& source : wire.sources) {
        const bool understood = source.kind != Source::Kind::Unresolved;
        takers.complete = takers.complete && (understood || !commands_or_requests(component, wire));
        const bool goal = source.kind == Source::Kind::Goal;
        if (source.kind != Source::Kind::ModuleCommand && !goal) continue;
        std::string& already = takers.of[static_cast<std::size_t>(source.component)];
        if (!already.empty()) {
          report_wire(problems, component, source.place,
                      goal ? fmt::format("\"{}\" already asks \"{}\"", source.text, already)
                           : fmt::format("the command of \"{}\" already goes to \"{}\"", source.text, already));
        }
        already = component.id;
      }
    }
  }
  return takers;
}

}  // namespace

bool makes_commands(const ComponentModel& component) noexcept {
  return component.component_class == ComponentClass::Acting ||
         component.component_class == ComponentClass::Coordinator;
}

void report_wire(Problems& problems, const ComponentModel& component, const Place& place, const std::string& message) {
  const std::string_view id = component.id;
  problems.add(place, ErrorCode::BadWire, "{}{}{}", id, id.empty() ? "" : ": ", message);
}

void bind_commands(ControllerModel& model, const RobotDescription& robot, Problems& problems) {
  for (ComponentModel& component : model.components) {
    if (component.command.empty()) continue;
    const CommandChannel* channel = robot.command(component.command);
    if (channel == nullptr) {
      report_wire(problems, component, component.command_place,
                  fmt::format("the robot has no command \"{}\"{}", component.command,
                              suggestion(component.command, command_names(robot))));
      continue;
    }
    component.command_index = static_cast<int>(channel - robot.commands.data());
    check_elements(component, *channel, problems);
  }
}

void check_commands(const ControllerModel& model, const RobotDescription& robot, Problems& problems) {
  const Takers takers = find_takers(model, problems);
  std::map<int, const ComponentModel*> writers;  // of each robot command
  for (std::size_t i = 0; i < model.components.size(); ++i) {
    const ComponentModel& component = model.components[i];
    const std::string& taker = takers.of[i];
    if (!taker.empty()) {
      if (component.command.empty()) continue;
      report_wire(
          problems, component, component.command_place,
          fmt::format("its command goes to \"{}\" already; leave out command = \"{}\"", taker, component.command));
    } else if (component.command_index >= 0) {
      const auto [first, fresh] = writers.emplace(component.command_index, &component);
      if (fresh) continue;
      report_wire(problems, component, component.command_place,
                  fmt::format("\"{}\" already commands \"{}\"; join them by a coordinator", first->second->id,
                              component.command));
    } else if (makes_commands(component) && component.command.empty() && takers.complete && !component.id.empty() &&
               model.find(component.id) == static_cast<int>(i)) {
      report_wire(problems, component, component.place,
                  fmt::format("its command goes nowhere; write command = \"...\" (the robot has: {}) or wire it to a "
                              "coordinator",
                              join(command_names(robot))));
    }
  }
}

}  // namespace ganglion
