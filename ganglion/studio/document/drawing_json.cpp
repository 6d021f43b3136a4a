#include <algorithm>
#include <unordered_map>

#include "ganglion/base/text.h"
#include "ganglion/studio/document/drawing.h"
#include "ganglion/studio/document/wording.h"

namespace ganglion::studio {
namespace {

Json robot_json(const Drawing& drawing) {
  Json json = {{"path", drawing.robot_path.generic_string()},
               {"name", drawing.robot ? drawing.robot->name : ""},
               {"known", drawing.robot.has_value()},
               {"channels", Json::array()},
               {"commands", Json::array()}};
  if (!drawing.robot) return json;
  for (const SensationChannel& channel : drawing.robot->sensations) {
    json["channels"].push_back({{"name", channel.name},
                                {"unit", channel.unit},
                                {"type", name_of(channel.type)},
                                {"elements", channel.elements},
                                {"min", channel.min},
                                {"max", channel.max}});
  }
  for (const CommandChannel& channel : drawing.robot->commands) {
    Json elements = Json::array();
    for (const CommandElement& one : channel.elements) {
      elements.push_back(
          {{"name", one.name}, {"unit", one.unit}, {"min", one.min}, {"max", one.max}, {"safe", one.safe}});
    }
    json["commands"].push_back({{"name", channel.name}, {"elements", std::move(elements)}});
  }
  return json;
}

/// The parts of a wire's text: "escape.active@previous".
Json wire_json(const std::string& text, int line, int column, bool ok) {
  constexpr std::string_view kPrevious = "@previous";
  std::string_view rest = text;
  const bool previous = rest.ends_with(kPrevious);
  if (previous) rest.remove_suffix(kPrevious.size());
  const std::size_t dot = rest.find('.');
  const std::string_view from = rest.substr(0, dot);
  const std::string_view tail = dot == std::string_view::npos ? std::string_view() : rest.substr(dot + 1);
  const std::size_t second = tail.find('.');
  return {{"text", text},
          {"from", from},
          {"output", tail.substr(0, second)},
          {"element", second == std::string_view::npos ? std::string_view() : tail.substr(second + 1)},
          {"previous", previous},
          {"line", line},
          {"column", column},
          {"ok", ok}};
}

Json value_json(const Parameters& parameters, const ParameterDescriptor& parameter) {
  switch (parameter.type) {
    case ParameterType::Real:
      return parameters.real(parameter.name);
    case ParameterType::Integer:
      return parameters.integer(parameter.name);
    case ParameterType::Boolean:
      return parameters.boolean(parameter.name);
    case ParameterType::Choice:
      return parameters.choice(parameter.name);
    case ParameterType::Word:
      return parameters.word(parameter.name);
    case ParameterType::Reals: {
      const auto values = parameters.reals(parameter.name);
      return std::vector<double>(values.begin(), values.end());
    }
  }
  return nullptr;
}

Json inputs_json(const ComponentModel& component) {
  Json inputs = Json::array();
  for (const Wire& wire : component.wires) {
    Json wires = Json::array();
    for (const Source& source : wire.sources) {
      const bool ok = source.kind != Source::Kind::Unresolved;
      wires.push_back(wire_json(source.text, source.place.line, source.place.column, ok));
    }
    const PortDescriptor& port = component.descriptor->ports[static_cast<std::size_t>(wire.port)];
    inputs.push_back({{"port", port.name}, {"wires", std::move(wires)}});
  }
  return inputs;
}

/// Of a sensation whose channel is unknown still its one output, so that its wires have an end.
Json outputs_json(const ComponentModel& component) {
  Json outputs = Json::array();
  for (const OutputShape& output : component.outputs) {
    outputs.push_back(
        {{"name", output.name}, {"unit", output.unit}, {"type", name_of(output.type)}, {"elements", output.elements}});
  }
  if (!outputs.empty()) return outputs;
  if (component.descriptor == nullptr) {
    outputs.push_back({{"name", ""}, {"unit", ""}, {"type", "real"}, {"elements", Json::array()}});
    return outputs;
  }
  for (const PortDescriptor& port : component.descriptor->ports) {
    if (port.role != PortRole::Output && port.role != PortRole::Appraisal) continue;
    outputs.push_back(
        {{"name", port.name}, {"unit", port.unit}, {"type", name_of(port.type)}, {"elements", port.elements}});
  }
  return outputs;
}

/// Every key of a component with its place, those of sub-sections included.
struct Key {
  std::string name;
  const MemberSource* member;
};
std::vector<Key> keys_of(const Drawing& drawing, const ComponentSource& source) {
  std::vector<Key> keys;
  for (const std::size_t index : source.sections) {
    const SectionSource& section = drawing.map.sections[index];
    const std::string prefix =
        index == source.sections.front() ? "" : section.name.substr(source.component_class.size() + 1) + ".";
    for (const MemberSource& member : section.members) keys.push_back({prefix + member.key, &member});
  }
  return keys;
}

class ComponentJson {
 public:
  ComponentJson(const Drawing& drawing, std::string_view text) : drawing_(drawing), text_(text) {
    for (const ComponentModel& component : drawing.model.components) by_line_.emplace(component.place.line, &component);
  }

  Json list() {
    Json components = Json::array();
    for (const ComponentSource& source : drawing_.sources) {
      const ComponentModel* model = model_of(source);
      components.push_back(model != nullptr ? understood(*model, &source) : misread(source));
      if (model != nullptr) by_line_.erase(model->place.line);
    }
    for (const ComponentModel& component : drawing_.model.components) {  // written in a list of inline tables
      if (by_line_.contains(component.place.line)) components.push_back(understood(component, nullptr));
    }
    return components;
  }

 private:
  const ComponentModel* model_of(const ComponentSource& source) const {
    const SectionSource& section = drawing_.map.sections[source.sections.front()];
    const MemberSource* id = section.member("id");
    const auto found = by_line_.find(id != nullptr ? id->line : section.line);
    return found != by_line_.end() ? found->second : nullptr;
  }

  Json head(const std::string& id, std::string_view component_class, std::string_view kind, int line,
            bool editable) const {
    Json json = {{"id", id}, {"class", component_class}, {"kind", kind}, {"line", line}, {"editable", editable}};
    const auto at = drawing_.layout.find(id);
    json["position"] = at != drawing_.layout.end() ? Json{at->second.first, at->second.second} : Json();
    return json;
  }

  Json understood(const ComponentModel& component, const ComponentSource* source) const {
    const Descriptor* kind = component.descriptor;
    Json json = head(component.id, name_of(component.component_class), kind != nullptr ? kind->name : "",
                     component.place.line, source != nullptr);
    json["channel"] = component.channel;
    json["command"] = component.command;
    json["inputs"] = inputs_json(component);
    json["outputs"] = outputs_json(component);
    json["parameters"] = Json::array();
    json["unknown"] = Json::array();
    if (source == nullptr || kind == nullptr) return json;
    for (const Key& key : keys_of(drawing_, *source)) {
      if (const ParameterDescriptor* parameter = kind->parameter(key.name)) {
        json["parameters"].push_back(
            {{"name", key.name}, {"value", value_json(component.parameters, *parameter)}, {"line", key.member->line}});
      } else if (key.name == "tolerance") {
        json["parameters"].push_back({{"name", key.name}, {"value", component.tolerance}, {"line", key.member->line}});
      } else if (key.name == "preemption") {
        json["parameters"].push_back({{"name", key.name}, {"value", component.preemption}, {"line", key.member->line}});
      } else if (!known(key.name)) {
        json["unknown"].push_back({{"key", key.name}, {"text", key.member->value.of(text_)}});
      }
    }
    return json;
  }

  static bool known(const std::string& key) {
    return key == "id" || key == "kind" || key == "command" || key == "channel" || key == "in" ||
           key.starts_with("in.");
  }

  /// Of an unknown kind: its wires as they stand, all else as text.
  Json misread(const ComponentSource& source) const {
    std::string kind;
    Json inputs = Json::array(), unknown = Json::array();
    for (const Key& key : keys_of(drawing_, source)) {
      const MemberSource& member = *key.member;
      if (key.name == "kind") kind = unquoted(member.value.of(text_));
      if (key.name.starts_with("in.")) {
        Json wires = Json::array();
        for (const Region& one : strings_in(text_, member.value)) {
          wires.push_back(wire_json(unquoted(one.of(text_)), member.line, 0, false));
        }
        inputs.push_back({{"port", key.name.substr(3)}, {"wires", std::move(wires)}});
      } else if (!known(key.name)) {
        unknown.push_back({{"key", key.name}, {"text", member.value.of(text_)}});
      }
    }
    const int line = drawing_.map.sections[source.sections.front()].line;
    Json json = head(source.id, source.component_class, kind, line, true);
    json["channel"] = "";
    json["command"] = "";
    json["inputs"] = std::move(inputs);
    json["outputs"] = Json::array();
    json["parameters"] = Json::array();
    json["unknown"] = std::move(unknown);
    return json;
  }

  const Drawing& drawing_;
  std::string_view text_;
  std::unordered_map<int, const ComponentModel*> by_line_;
};

}  // namespace

Json drawing_json(const Drawing& drawing, std::string_view text, Language language) {
  Json json = {{"name", drawing.model.name}, {"tick_s", drawing.model.tick_s}, {"robot", robot_json(drawing)}};
  json["components"] = ComponentJson(drawing, text).list();
  json["problems"] = Json::array();
  for (const DrawingProblem& problem : drawing.problems) {
    json["problems"].push_back({{"code", name_of(problem.error.code)},
                                {"message", worded(problem.error.message, language)},
                                {"line", problem.error.place.line},
                                {"column", problem.error.place.column},
                                {"component", problem.component},
                                {"port", problem.port()},
                                {"key", problem.key}});
  }
  json["runnable"] = drawing.problems.empty();
  return json;
}

}  // namespace ganglion::studio
