#include "ganglion/graph/commands.h"

#include <algorithm>
#include <map>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

std::vector<std::string> command_names(const Description& robot) {
  std::vector<std::string> names;
  for (const CommandChannel& channel : robot.commands) names.push_back(channel.name);
  return names;
}

std::vector<std::string> element_names(const CommandChannel& channel) {
  std::vector<std::string> names;
  for (const CommandElement& element : channel.elements) names.push_back(element.name);
  return names;
}

/// Values that have names meet the robot's by name, in any order; others by place.
bool meets(const PortDescriptor& port, const std::vector<std::string>& wanted) {
  std::vector<std::string> mine = ::ganglion::element_names(port);
  if (mine.empty()) return static_cast<std::size_t>(port.size) == wanted.size();
  return mine.size() == wanted.size() && std::is_permutation(mine.begin(), mine.end(), wanted.begin());
}

void report_elements(const ComponentModel& component, const PortDescriptor& port, const CommandChannel& channel,
                     Problems& problems) {
  const std::vector<std::string> mine = ::ganglion::element_names(port);
  const Sentence given = mine.empty() ? say({"{} values", "{} valores"}, port.size) : Sentence::quoted(join(mine));
  const Place& place = component.command.empty() ? component.place : component.command_place;
  report_wire(problems, component, place,
              say({"commands {{{}}} but \"{}\" takes {{{}}}", "manda {{{}}} pero \"{}\" admite {{{}}}"}, given,
                  channel.name, join(element_names(channel))),
              {.part = "command", .found = channel.name});
}

void check_elements(const ComponentModel& component, const CommandChannel& channel, Problems& problems) {
  for (const PortDescriptor& port : component.ports()) {
    if (port.role != PortRole::Command || port.size == 0) continue;
    if (!meets(port, element_names(channel))) report_elements(component, port, channel, problems);
  }
}

std::string part_of(const ComponentModel& component, const Wire& wire) {
  return fmt::format("in.{}", component.ports()[static_cast<std::size_t>(wire.port)].name);
}

bool commands_or_requests(const ComponentModel& component, const Wire& wire) noexcept {
  const PortRole role = component.ports()[static_cast<std::size_t>(wire.port)].role;
  return role == PortRole::Candidate || role == PortRole::Request;
}

/// Where the commands go that do not go to the robot directly.
struct Takers {
  std::vector<std::string> of;  ///< For each component the one that takes its command or bids; "" = none.
  std::vector<int> by;          ///< Its index; -1 = none.
  bool complete = true;         ///< Every wire for commands was understood.
};

/// Whether what a goal asks here and what it asked before are set-points: those it may ask of several modules.
bool asks_standing(const ControllerModel& model, const Takers& takers, const Source& source,
                   const ComponentModel& component, const Wire& wire) {
  const int before = takers.by[static_cast<std::size_t>(source.component)];
  if (before < 0 || !component.ports()[static_cast<std::size_t>(wire.port)].standing) return false;
  const PortDescriptor* asked = model.components[static_cast<std::size_t>(before)].port_of(PortRole::Request);
  return asked != nullptr && asked->standing && &model.components[static_cast<std::size_t>(before)] != &component;
}

Takers find_takers(const ControllerModel& model, Problems& problems) {
  const std::size_t count = model.components.size();
  Takers takers{std::vector<std::string>(count), std::vector<int>(count, -1), model.misread.empty()};
  for (std::size_t i = 0; i < count; ++i) {
    const ComponentModel& component = model.components[i];
    for (const Wire& wire : component.wires) {
      for (const Source& source : wire.sources) {
        const bool understood = source.kind != Source::Kind::Unresolved;
        takers.complete = takers.complete && (understood || !commands_or_requests(component, wire));
        const bool goal = source.kind == Source::Kind::Goal;
        if (source.kind != Source::Kind::ModuleCommand && !goal) continue;
        std::string& already = takers.of[static_cast<std::size_t>(source.component)];
        const bool standing = goal && asks_standing(model, takers, source, component, wire);
        if (!already.empty() && !standing) {
          report_wire(
              problems, component, source.place,
              goal ? say({"\"{}\" already asks \"{}\"", "\"{}\" ya hace solicitudes a \"{}\""}, source.text, already)
                   : say({"the command of \"{}\" already goes to \"{}\"", "el mando de \"{}\" ya va a \"{}\""},
                         source.text, already),
              {.part = part_of(component, wire), .found = source.text});
        }
        already = component.id;
        takers.by[static_cast<std::size_t>(source.component)] = static_cast<int>(i);
      }
    }
  }
  return takers;
}

/// Values that a component's port of that role has; 0 = as many as there are, or there is no such port.
int width_of(const ComponentModel& component, PortRole role) noexcept {
  for (const PortDescriptor& port : component.ports()) {
    if (port.role == role) return port.width();
  }
  return 0;
}

/// What a command ends in behind coordinators that take any number of values.
struct End {
  Sentence text;
  int width = 0;
  const CommandChannel* channel = nullptr;  ///< The robot's, where it ends there.
};

End end_of(const ControllerModel& model, const Description& robot, const Takers& takers, std::size_t start) {
  std::size_t at = start;
  for (std::size_t hops = 0; takers.by[at] >= 0 && hops < model.components.size(); ++hops) {
    at = static_cast<std::size_t>(takers.by[at]);
    const ComponentModel& taker = model.components[at];
    if (taker.component_class == ComponentClass::Acting) {
      return {say({"requests to \"{}\" have", "las solicitudes a \"{}\" tienen"}, taker.id),
              width_of(taker, PortRole::Request)};
    }
    if (const int width = width_of(taker, PortRole::Command)) {
      return {say({"\"{}\" has", "\"{}\" tiene"}, taker.id), width};
    }
  }
  const ComponentModel& last = model.components[at];
  if (at == start || last.command_index < 0) return {};  // what drives the robot directly was checked by element
  const CommandChannel& channel = robot.commands[static_cast<std::size_t>(last.command_index)];
  return {say({"\"{}\" takes", "\"{}\" admite"}, channel.name), static_cast<int>(channel.elements.size()), &channel};
}

/// Coordinators mix by place: what they hand to the robot must stand in its order.
void check_order(const ComponentModel& component, const End& end, Problems& problems) {
  const PortDescriptor& port = *component.port_of(PortRole::Command);
  if (end.channel == nullptr || port.elements.empty()) return;
  if (::ganglion::element_names(port) != element_names(*end.channel)) {
    report_elements(component, port, *end.channel, problems);
  }
}

void check_widths(const ControllerModel& model, const Description& robot, const Takers& takers, Problems& problems) {
  for (std::size_t i = 0; i < model.components.size(); ++i) {
    const ComponentModel& component = model.components[i];
    const int width = makes_commands(component) ? width_of(component, PortRole::Command) : 0;
    if (width == 0) continue;
    const End end = end_of(model, robot, takers, i);
    if (end.width == width) check_order(component, end, problems);
    if (end.width == 0 || end.width == width) continue;
    report_wire(problems, component, component.place,
                say({"commands {} value{}, but {} {}", "manda {} valor{}, pero {} {}"}, width,
                    width == 1 ? Text{"", ""} : Text{"s", "es"}, end.text, end.width),
                {.part = "command"});
  }
}

}  // namespace

bool makes_commands(const ComponentModel& component) noexcept {
  return component.component_class == ComponentClass::Acting ||
         component.component_class == ComponentClass::Coordinator;
}

void report_wire(Problems& problems, const ComponentModel& component, const Place& place, const Sentence& what,
                 Subject subject) {
  subject.component = component.id;
  problems.add(Error{ErrorCode::BadWire, component.id.empty() ? what : say({"{}: {}", "{}: {}"}, component.id, what),
                     place, std::move(subject)});
}

void bind_commands(ControllerModel& model, const Description& robot, Problems& problems) {
  for (ComponentModel& component : model.components) {
    if (component.command.empty()) continue;
    const CommandChannel* channel = robot.command(component.command);
    if (channel == nullptr) {
      report_wire(problems, component, component.command_place,
                  say({"the robot has no command \"{}\"{}", "el robot no tiene el mando \"{}\"{}"}, component.command,
                      suggestion(component.command, command_names(robot))),
                  {.part = "command", .found = component.command, .choices = command_names(robot)});
      continue;
    }
    component.command_index = static_cast<int>(channel - robot.commands.data());
    check_elements(component, *channel, problems);
  }
}

void check_commands(const ControllerModel& model, const Description& robot, Problems& problems) {
  const Takers takers = find_takers(model, problems);
  check_widths(model, robot, takers, problems);
  std::map<int, const ComponentModel*> writers;  // of each robot command
  for (std::size_t i = 0; i < model.components.size(); ++i) {
    const ComponentModel& component = model.components[i];
    const std::string& taker = takers.of[i];
    if (!taker.empty()) {
      if (component.command.empty()) continue;
      report_wire(problems, component, component.command_place,
                  say({"its command goes to \"{}\" already; leave out command = \"{}\"",
                       "su mando ya va a \"{}\"; quite command = \"{}\""},
                      taker, component.command),
                  {.part = "command", .found = component.command});
    } else if (component.command_index >= 0) {
      const auto [first, fresh] = writers.emplace(component.command_index, &component);
      if (fresh) continue;
      report_wire(problems, component, component.command_place,
                  say({"\"{}\" already commands \"{}\"; join them by a coordinator",
                       "\"{}\" ya manda \"{}\"; únalos con un coordinador"},
                      first->second->id, component.command),
                  {.part = "command", .found = component.command});
    } else if (makes_commands(component) && component.command.empty() && takers.complete && !component.id.empty() &&
               model.find(component.id) == static_cast<int>(i)) {
      report_wire(problems, component, component.place,
                  say({"its command goes nowhere; write command = \"...\" (the robot has: {}) or wire it to a "
                       "coordinator",
                       "su mando no va a ninguna parte; escriba command = \"...\" (el robot tiene: {}) o conéctelo a "
                       "un coordinador"},
                      join(command_names(robot))),
                  {.part = "command", .choices = command_names(robot)});
    }
  }
}

}  // namespace ganglion
