#include "ganglion/graph/wire_hints.h"

#include <algorithm>

#include "ganglion/base/text.h"
#include "ganglion/graph/commands.h"

namespace ganglion {
namespace {

std::string name_of(const ComponentModel& component, const OutputShape& output) {
  return output.name.empty() ? component.id : component.id + "." + output.name;
}

}  // namespace

std::vector<std::string> WireHints::givers_for(const PortDescriptor& port) const {
  std::vector<std::string> names;
  for (const ComponentModel& component : model_.components) {
    const bool goal = component.component_class == ComponentClass::Goal && port.role == PortRole::Request;
    if ((makes_commands(component) || goal) && !component.id.empty()) names.push_back(component.id);
  }
  return names;
}

std::vector<std::string> WireHints::sources_for(const PortDescriptor& port) const {
  const int wanted = port.width();
  std::vector<std::string> names;
  for (const ComponentModel& component : model_.components) {
    for (const OutputShape& output : component.outputs) {
      if (port.unit != "*" && port.unit != output.unit) continue;
      const std::string name = name_of(component, output);
      if (wanted == 0 || wanted == output.size()) names.push_back(name);
      if (wanted != 1) continue;
      for (const std::string& element : output.elements) names.push_back(name + "." + element);
    }
  }
  return names;
}

Sentence WireHints::for_unknown(const PortDescriptor& port, const std::string& text) const {
  std::vector<std::string> owners, all;
  for (const ComponentModel& component : model_.components) {
    owners.push_back(component.id);
    for (const OutputShape& output : component.outputs) all.push_back(name_of(component, output));
  }
  for (const CommandChannel& channel : robot_.commands) owners.push_back(channel.name);
  const auto dot = std::min(text.find('.'), text.size());
  if (const auto owner = nearest(text.substr(0, dot), owners)) {
    return say({"; did you mean \"{}{}\"?", "; ¿quiso decir \"{}{}\"?"}, *owner, text.substr(dot));
  }
  if (const auto near = nearest(text, all)) return say({"; did you mean \"{}\"?", "; ¿quiso decir \"{}\"?"}, *near);
  const std::vector<std::string> fitting = sources_for(port);
  return suggestion("", fitting.empty() ? all : fitting);
}

Sentence WireHints::for_channel(const std::string& channel) const {
  for (const ComponentModel& component : model_.components) {
    if (component.channel == channel) {
      return say({"wire the sensation that reads it: \"{}\"", "conecte la sensación que lo lee: \"{}\""}, component.id);
    }
  }
  return say({"add a [[sensation]] with channel = \"{}\" and wire its id",
              "añada una [[sensation]] con channel = \"{}\" y conecte su id"},
             channel);
}

std::vector<std::string> WireHints::parts_of(const Source& source) const {
  std::vector<std::string> parts;
  if (source.kind == Source::Kind::RobotCommand) {
    for (const CommandElement& element : robot_.commands[static_cast<std::size_t>(source.component)].elements) {
      parts.push_back(element.name);
    }
  } else {
    const ComponentModel& from = model_.components[static_cast<std::size_t>(source.component)];
    parts = from.outputs[static_cast<std::size_t>(std::max(0, source.port))].elements;
  }
  const std::string owner = source.text.substr(0, source.text.find('@'));
  for (std::string& part : parts) part = fmt::format("{}.{}{}", owner, part, source.previous ? "@previous" : "");
  return parts;
}

}  // namespace ganglion
