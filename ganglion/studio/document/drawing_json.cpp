#include <algorithm>
#include <unordered_map>

#include "ganglion/base/text.h"
#include "ganglion/studio/document/drawing.h"
#include "ganglion/studio/document/json_text.h"

namespace ganglion::studio {
namespace {

constexpr std::size_t kMostChoices = 50;

template <class Texts>
void write_texts(JsonText& json, std::string_view name, const Texts& texts) {
  json.key(name).begin_list();
  for (const auto& text : texts) json.value(std::string_view(text));
  json.end_list();
}

void write_robot(JsonText& json, const Drawing& drawing) {
  json.key("robot").begin_object();
  json.member("path", drawing.robot_path.generic_string());
  json.member("name", drawing.robot ? drawing.robot->name : "").member("known", drawing.robot.has_value());
  const Description robot = drawing.robot.value_or(Description{});
  json.key("channels").begin_list();
  for (const SensationChannel& channel : robot.sensations) {
    json.begin_object().member("name", channel.name).member("unit", channel.unit);
    json.member("type", name_of(channel.type));
    write_texts(json, "elements", channel.elements);
    json.member("min", channel.min).member("max", channel.max).end_object();
  }
  json.end_list().key("commands").begin_list();
  for (const CommandChannel& channel : robot.commands) {
    json.begin_object().member("name", channel.name).key("elements").begin_list();
    for (const CommandElement& one : channel.elements) {
      json.begin_object().member("name", one.name).member("unit", one.unit);
      json.member("min", one.min).member("max", one.max).member("safe", one.safe).end_object();
    }
    json.end_list().end_object();
  }
  json.end_list().end_object();
}

/// The parts of a wire's text: "escape.active@previous".
void write_wire(JsonText& json, const std::string& text, int line, int column, bool ok) {
  constexpr std::string_view kPrevious = "@previous";
  std::string_view rest = text;
  const bool previous = rest.ends_with(kPrevious);
  if (previous) rest.remove_suffix(kPrevious.size());
  const std::size_t dot = std::min(rest.find('.'), rest.size());
  const std::string_view tail = rest.substr(std::min(dot + 1, rest.size()));
  const std::size_t second = std::min(tail.find('.'), tail.size());
  json.begin_object().member("text", text).member("from", rest.substr(0, dot));
  json.member("output", tail.substr(0, second)).member("element", tail.substr(std::min(second + 1, tail.size())));
  json.member("previous", previous).member("line", line).member("column", column).member("ok", ok).end_object();
}

void write_value(JsonText& json, const Parameters& parameters, const ParameterDescriptor& parameter) {
  const ParameterValue& value = parameters.value(parameter.name);
  if (const auto* word = std::get_if<std::string>(&value)) {
    json.value(*word);
  } else if (const auto* file = std::get_if<FileText>(&value)) {
    json.value(file->name);
  } else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    json.begin_list();
    for (const double number : *numbers) json.value(number);
    json.end_list();
  } else if (parameter.type == ParameterType::Boolean) {
    json.value(parameters.boolean(parameter.name));
  } else if (parameter.type == ParameterType::Choice) {
    json.value(parameters.choice(parameter.name));
  } else if (parameter.type == ParameterType::Integer) {
    json.value(parameters.integer(parameter.name));
  } else {
    json.value(parameters.real(parameter.name));
  }
}

void write_inputs(JsonText& json, const ComponentModel& component) {
  json.key("inputs").begin_list();
  for (const Wire& wire : component.wires) {
    const PortDescriptor& port = component.ports()[static_cast<std::size_t>(wire.port)];
    json.begin_object().member("port", port.name).key("wires").begin_list();
    for (const Source& source : wire.sources) {
      const bool ok = source.kind != Source::Kind::Unresolved;
      write_wire(json, source.text, source.place.line, source.place.column, ok);
    }
    json.end_list().end_object();
  }
  json.end_list();
}

template <class Texts>
void write_output(JsonText& json, std::string_view name, std::string_view unit, ValueType type, const Texts& elements) {
  json.begin_object().member("name", name).member("unit", unit).member("type", name_of(type));
  write_texts(json, "elements", elements);
  json.end_object();
}

/// Of a sensation whose channel is unknown still its one output, so that its wires have an end.
void write_outputs(JsonText& json, const ComponentModel& component) {
  json.key("outputs").begin_list();
  for (const OutputShape& output : component.outputs) {
    write_output(json, output.name, output.unit, output.type, output.elements);
  }
  if (component.outputs.empty() && component.descriptor == nullptr) {
    write_output(json, "", "", ValueType::Real, std::vector<std::string>{});
  } else if (component.outputs.empty()) {
    for (const PortDescriptor& port : component.ports()) {
      if (port.role != PortRole::Output && port.role != PortRole::Appraisal) continue;
      write_output(json, port.name, port.unit, port.type, element_names(port));
    }
  }
  json.end_list();
}

/// Every key of a component with its place, those of sub-sections included.
struct Key {
  std::string name;
  const config::MemberSource* member;
};
std::vector<Key> keys_of(const Drawing& drawing, const config::ItemSource& source) {
  std::vector<Key> keys;
  for (const std::size_t index : source.sections) {
    const config::SectionSource& section = drawing.map.sections[index];
    const std::string prefix = source.prefix(drawing.map, index);
    for (const config::MemberSource& member : section.members) keys.push_back({prefix + member.key, &member});
  }
  return keys;
}

bool is_structure(const std::string& key) {
  return key == "id" || key == "kind" || key == "command" || key == "channel" || key == "in" || key.starts_with("in.");
}

class ComponentWriter {
 public:
  ComponentWriter(JsonText& json, const Drawing& drawing, std::string_view text)
      : json_(json), drawing_(drawing), text_(text) {
    for (const ComponentModel& component : drawing.model.components) by_line_.emplace(component.place.line, &component);
  }

  void write() {
    json_.key("components").begin_list();
    for (const config::ItemSource& source : drawing_.sources) {
      const ComponentModel* model = model_of(source);
      if (model != nullptr) {
        write_understood(*model, &source);
        by_line_.erase(model->place.line);
      } else {
        write_misread(source);
      }
    }
    for (const ComponentModel& component : drawing_.model.components) {  // written in a list of inline tables
      if (by_line_.contains(component.place.line)) write_understood(component, nullptr);
    }
    json_.end_list();
  }

 private:
  const ComponentModel* model_of(const config::ItemSource& source) const {
    const config::SectionSource& section = drawing_.map.sections[source.sections.front()];
    const config::MemberSource* id = section.member("id");
    const auto found = by_line_.find(id != nullptr ? id->line : section.line);
    return found != by_line_.end() ? found->second : nullptr;
  }

  void write_head(const std::string& id, std::string_view component_class, std::string_view kind, int line,
                  bool editable) {
    json_.begin_object().member("id", id).member("class", component_class).member("kind", kind);
    json_.member("line", line).member("editable", editable).key("position");
    const auto at = drawing_.layout.find(id);
    if (at != drawing_.layout.end()) {
      json_.begin_list().value(at->second.first).value(at->second.second).end_list();
    } else {
      json_.null();
    }
  }

  void write_understood(const ComponentModel& component, const config::ItemSource* source) {
    const Descriptor* kind = component.descriptor;
    write_head(component.id, name_of(component.component_class), kind != nullptr ? kind->name : "",
               component.place.line, source != nullptr);
    json_.member("channel", component.channel).member("command", component.command);
    write_inputs(json_, component);
    write_outputs(json_, component);
    const std::vector<Key> keys = source != nullptr ? keys_of(drawing_, *source) : std::vector<Key>{};
    json_.key("parameters").begin_list();
    for (const Key& key : keys) write_parameter(component, key);
    json_.end_list().key("unknown").begin_list();
    for (const Key& key : keys) {
      const bool parameter =
          find_in(component.parameters, key.name) != nullptr || find_in(component.common, key.name) != nullptr;
      if (!parameter && !is_structure(key.name)) write_unknown(key);
    }
    json_.end_list().end_object();
  }

  void write_parameter(const ComponentModel& component, const Key& key) {
    const ParameterDescriptor* own = find_in(component.parameters, key.name);
    const ParameterDescriptor* common = find_in(component.common, key.name);
    if (own == nullptr && common == nullptr) return;
    json_.begin_object().member("name", key.name).key("value");
    if (own != nullptr) {
      write_value(json_, component.parameters, *own);
    } else {
      write_value(json_, component.common, *common);
    }
    json_.member("line", key.member->line).end_object();
  }

  static const ParameterDescriptor* find_in(const Parameters& parameters, std::string_view name) noexcept {
    for (const ParameterDescriptor& descriptor : parameters.descriptors()) {
      if (descriptor.name == name) return &descriptor;
    }
    return nullptr;
  }

  void write_unknown(const Key& key) {
    json_.begin_object().member("key", key.name).member("text", key.member->value.of(text_)).end_object();
  }

  /// Of an unknown kind: its wires as they stand, all else as text.
  void write_misread(const config::ItemSource& source) {
    const std::vector<Key> keys = keys_of(drawing_, source);
    const auto kind = std::find_if(keys.begin(), keys.end(), [](const Key& key) { return key.name == "kind"; });
    write_head(source.id, source.list, kind != keys.end() ? config::unquoted(kind->member->value.of(text_)) : "",
               drawing_.map.sections[source.sections.front()].line, true);
    json_.member("channel", "").member("command", "").key("inputs").begin_list();
    for (const Key& key : keys) {
      if (!key.name.starts_with("in.")) continue;
      json_.begin_object().member("port", key.name.substr(3)).key("wires").begin_list();
      for (const config::Region& one : config::strings_in(text_, key.member->value)) {
        write_wire(json_, config::unquoted(one.of(text_)), key.member->line, 0, false);
      }
      json_.end_list().end_object();
    }
    json_.end_list().key("outputs").begin_list().end_list().key("parameters").begin_list().end_list();
    json_.key("unknown").begin_list();
    for (const Key& key : keys) {
      if (!is_structure(key.name)) write_unknown(key);
    }
    json_.end_list().end_object();
  }

  JsonText& json_;
  const Drawing& drawing_;
  std::string_view text_;
  std::unordered_map<int, const ComponentModel*> by_line_;
};

/// The nearest first. A drawing may have thousands of ids, of which nobody chooses.
void write_choices(JsonText& json, const Subject& subject) {
  const auto near = nearest(subject.found, subject.choices);
  json.key("choices").begin_list();
  if (near) json.value(*near);
  std::size_t room = kMostChoices - (near ? 1 : 0);
  for (const std::string& choice : subject.choices) {
    if (choice == near) continue;
    if (room-- == 0) break;
    json.value(choice);
  }
  json.end_list();
}

void write_problem(JsonText& json, const DrawingProblem& problem, Language language) {
  const Error& error = problem.error;
  json.begin_object().member("code", name_of(error.code)).member("message", error.what.in(language));
  json.member("line", error.place.line).member("column", error.place.column);
  json.member("component", problem.component).member("port", problem.port()).member("key", problem.key);
  json.key("subject").begin_object().member("component", error.subject.component).member("part", error.subject.part);
  json.member("found", error.subject.found);
  write_choices(json, error.subject);
  json.end_object().end_object();
}

}  // namespace

std::string drawing_json(const Drawing& drawing, std::string_view text, Language language) {
  JsonText json;
  json.begin_object().member("name", drawing.model.name).member("tick_s", drawing.model.tick_s);
  write_robot(json, drawing);
  ComponentWriter(json, drawing, text).write();
  json.key("problems").begin_list();
  for (const DrawingProblem& problem : drawing.problems) write_problem(json, problem, language);
  json.end_list().member("runnable", drawing.problems.empty()).end_object();
  return json.take();
}

}  // namespace ganglion::studio
