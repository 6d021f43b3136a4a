#include <algorithm>

#include "ganglion/base/text.h"
#include "ganglion/graph/commands.h"
#include "ganglion/graph/shapes.h"
#include "ganglion/graph/wire_hints.h"

namespace ganglion {
namespace {

/// Finds out what each wire's text means.
class Resolver {
 public:
  Resolver(ControllerModel& model, const Description& robot, Problems& problems)
      : model_(model), robot_(robot), problems_(problems), hints_(model, robot), ids_(ids_of(model)) {}

  void run() {
    for (ComponentModel& component : model_.components) {
      bind_channel(component);
      check_name(component);
    }
    bind_commands(model_, robot_, problems_);
    if (!shape_outputs(model_, robot_, ids_, problems_)) return;
    for (ComponentModel& component : model_.components) {
      for (Wire& wire : component.wires) resolve_wire(component, wire);
      check_candidates(component);
    }
    check_commands(model_, robot_, problems_);
  }

 private:
  template <class... Args>
  void problem(const ComponentModel& component, const Place& place, Wording<std::type_identity_t<Args>...> words,
               const Args&... args) {
    report_wire(problems_, component, place, say<Args...>(words, args...), subject_);
    subject_.choices.clear();
  }
  /// The end of a problem's sentence; whoever mends it is offered the names.
  Sentence offer(std::string_view word, const std::vector<std::string>& names) {
    subject_.choices = names;
    return suggestion(word, names);
  }
  /// What the problems are about that follow.
  void look_at(std::string part, std::string found) { subject_ = {"", std::move(part), std::move(found), {}}; }

  void bind_channel(ComponentModel& component);
  void check_name(const ComponentModel& component);
  void resolve_wire(ComponentModel& component, Wire& wire);
  void resolve_source(const ComponentModel& component, const PortDescriptor& port, Source& source);
  void resolve_data(const ComponentModel& component, const PortDescriptor& port, Source& source,
                    const std::string& text);
  void resolve_output(const ComponentModel& component, Source& source, const std::vector<std::string>& parts);
  void resolve_sensation(const ComponentModel& component, Source& source, const std::vector<std::string>& parts);
  void resolve_robot_command(const ComponentModel& component, Source& source, const std::vector<std::string>& parts);
  void check_shape(const ComponentModel& component, const PortDescriptor& port, const Source& source);
  void check_order(const ComponentModel& component, const PortDescriptor& port, const Source& source);
  void check_candidates(const ComponentModel& component);
  std::string unit_of(const Source& source) const;
  bool is_appraisal(const Source& source) const;
  bool has_part(int component, const std::string& name) const;
  bool misread(const std::string& id) const {
    return std::any_of(model_.misread.begin(), model_.misread.end(),
                       [&](const std::string& lost) { return lost.empty() || lost == id; });
  }

  ControllerModel& model_;
  const Description& robot_;
  Problems& problems_;
  WireHints hints_;
  ComponentIndex ids_;
  Subject subject_;  // of the problems that come next
};

std::vector<std::string> channel_names(const Description& robot) {
  std::vector<std::string> names;
  for (const SensationChannel& channel : robot.sensations) names.push_back(channel.name);
  return names;
}

int element_index(const std::vector<std::string>& elements, const std::string& name) {
  const auto found = std::find(elements.begin(), elements.end(), name);
  return found == elements.end() ? -1 : static_cast<int>(found - elements.begin());
}

void Resolver::bind_channel(ComponentModel& component) {
  if (component.component_class != ComponentClass::Sensation) return;
  const SensationChannel* channel = robot_.sensation(component.channel);
  if (channel != nullptr) {
    component.channel_index = static_cast<int>(channel - robot_.sensations.data());
  } else if (!component.channel.empty()) {
    look_at("channel", component.channel);
    problem(component, component.channel_place,
            {"the robot has no channel \"{}\"{}", "el robot no tiene el canal \"{}\"{}"}, component.channel,
            offer(component.channel, channel_names(robot_)));
  }
}

/// Its signals and the robot's command would go by one name, and that command could not be wired.
void Resolver::check_name(const ComponentModel& component) {
  if (robot_.command(component.id) == nullptr) return;
  look_at("id", component.id);
  problem(component, component.place,
          {"the robot has a command of this name; choose another id",
           "el robot tiene un mando con este nombre; elija otro id"});
}

void Resolver::resolve_wire(ComponentModel& component, Wire& wire) {
  const PortDescriptor& port = component.ports()[static_cast<std::size_t>(wire.port)];
  for (Source& source : wire.sources) {
    if (problems_.full()) continue;
    look_at(fmt::format("in.{}", port.name), source.text);
    resolve_source(component, port, source);
  }
  if (port.role != PortRole::Request || wire.sources.size() < 2) return;
  for (const Source& source : wire.sources) {
    if (source.kind == Source::Kind::ModuleCommand) {
      look_at(fmt::format("in.{}", port.name), source.text);
      problem(component, source.place,
              {"a request comes either from goals or from one module; \"{}\" is a module",
               "una solicitud viene de objetivos globales o de un solo módulo; \"{}\" es un módulo"},
              source.text);
    }
  }
}

void Resolver::resolve_source(const ComponentModel& component, const PortDescriptor& port, Source& source) {
  std::string text = source.text;
  constexpr std::string_view kPrevious = "@previous";
  if (text.ends_with(kPrevious)) {
    source.previous = true;
    text.resize(text.size() - kPrevious.size());
  } else if (const auto at = text.find('@'); at != std::string::npos) {
    problem(component, source.place,
            {"\"{}\": the only mark is @previous, as in \"{}@previous\"",
             "\"{}\": la única marca es @previous, como en \"{}@previous\""},
            text, text.substr(0, at));
    return;
  }
  if (port.role != PortRole::Candidate && port.role != PortRole::Request) {
    resolve_data(component, port, source, text);
    return;
  }
  const int found = find(ids_, text);
  if (found < 0 && misread(text)) return;
  const ComponentModel* from = found < 0 ? nullptr : &model_.components[static_cast<std::size_t>(found)];
  const bool commands = from != nullptr && makes_commands(*from);
  const bool goal = from != nullptr && from->component_class == ComponentClass::Goal && port.role == PortRole::Request;
  if (!commands && !goal) {
    problem(component, source.place, {"\"{}\" is no {}{}", "\"{}\" no es {}{}"}, text,
            port.role == PortRole::Request
                ? Text{"goal or acting module", "un objetivo global ni un módulo de actuación"}
                : Text{"acting module or coordinator", "un módulo de actuación ni un coordinador"},
            offer(text, hints_.givers_for(port)));
    return;
  }
  if (source.previous) {
    problem(component, source.place,
            {"a command is handed on within its tick; leave out @previous",
             "un mando se entrega dentro de su ciclo; quite @previous"});
    return;
  }
  source.kind = goal ? Source::Kind::Goal : Source::Kind::ModuleCommand;
  source.component = found;
}

void Resolver::resolve_data(const ComponentModel& component, const PortDescriptor& port, Source& source,
                            const std::string& text) {
  const std::vector<std::string> parts = split(text, '.');
  const int found = find(ids_, parts[0]);
  if (parts.size() > 1 && robot_.sensation(text) != nullptr && (found < 0 || !has_part(found, parts[1]))) {
    problem(component, source.place, {"\"{}\" is a channel of the robot; {}", "\"{}\" es un canal del robot; {}"}, text,
            hints_.for_channel(text));
    return;
  }
  if (found >= 0) {
    source.component = found;
    if (model_.components[static_cast<std::size_t>(found)].component_class == ComponentClass::Sensation) {
      resolve_sensation(component, source, parts);
    } else {
      resolve_output(component, source, parts);
    }
  } else if (robot_.command(parts[0]) != nullptr) {
    resolve_robot_command(component, source, parts);
  } else if (!misread(parts[0])) {
    subject_.choices = hints_.sources_for(port);
    problem(component, source.place,
            {"\"{}\" is no sensation or module{}", "\"{}\" no es una sensación ni un módulo{}"}, parts[0],
            hints_.for_unknown(port, text));
  }
  if (source.kind == Source::Kind::Unresolved) return;
  if (port.role == PortRole::Appraisal && !is_appraisal(source)) {
    problem(component, source.place,
            {"input \"{}\" takes what an acting module expects; \"{}\" is no appraisal",
             "la entrada \"{}\" admite lo que espera un módulo de actuación; \"{}\" no es una evaluación"},
            port.name, source.text);
    return;
  }
  check_shape(component, port, source);
  check_order(component, port, source);
}

bool Resolver::is_appraisal(const Source& source) const {
  if (source.kind != Source::Kind::Output) return false;
  const ComponentModel& from = model_.components[static_cast<std::size_t>(source.component)];
  const PortDescriptor* port = from.descriptor->port(from.outputs[static_cast<std::size_t>(source.port)].name);
  return port != nullptr && port->role == PortRole::Appraisal;
}

/// Whether "component.name" means something.
bool Resolver::has_part(int component, const std::string& name) const {
  const auto& outputs = model_.components[static_cast<std::size_t>(component)].outputs;
  return std::any_of(outputs.begin(), outputs.end(), [&](const OutputShape& output) {
    return output.name == name || (output.name.empty() && element_index(output.elements, name) >= 0);
  });
}

void Resolver::resolve_sensation(const ComponentModel& component, Source& source,
                                 const std::vector<std::string>& parts) {
  const ComponentModel& from = model_.components[static_cast<std::size_t>(source.component)];
  const OutputShape& shape = from.outputs.front();
  if (from.channel_index < 0) return;  // reported already; nothing is known of it
  source.size = shape.size();
  if (parts.size() == 2 && parts[1] == "age_s") {
    source.kind = Source::Kind::SensationAge;
    source.size = 1;
  } else if (parts.size() == 2) {
    source.element = element_index(shape.elements, parts[1]);
    source.size = 1;
    if (source.element >= 0) source.kind = Source::Kind::Sensation;
  } else if (parts.size() == 1) {
    source.kind = Source::Kind::Sensation;
  }
  if (source.kind != Source::Kind::Unresolved) return;
  if (shape.elements.empty()) {
    problem(component, source.place,
            {"\"{}\" is one value; write \"{}\", or \"{}.age_s\" for its age",
             "\"{}\" es un solo valor; escriba \"{}\", o \"{}.age_s\" para su antigüedad"},
            from.id, from.id, from.id);
    return;
  }
  std::vector<std::string> names = shape.elements;
  names.emplace_back("age_s");
  problem(component, source.place, {"sensation \"{}\" has no \"{}\"{}", "la sensación \"{}\" no tiene \"{}\"{}"},
          parts[0], parts.back(), offer(parts.back(), names));
}

void Resolver::resolve_output(const ComponentModel& component, Source& source, const std::vector<std::string>& parts) {
  const ComponentModel& from = model_.components[static_cast<std::size_t>(source.component)];
  std::vector<std::string> names;
  std::vector<int> declared;
  for (std::size_t i = 0; i < from.outputs.size(); ++i) {
    names.push_back(from.outputs[i].name);
    if (from.outputs[i].declared) declared.push_back(static_cast<int>(i));
  }
  if (parts.size() == 1) {
    if (names.empty()) {
      problem(component, source.place, {"\"{}\" has no outputs", "\"{}\" no tiene salidas"}, from.id);
      return;
    }
    if (declared.size() != 1) {
      for (std::string& name : names) name = from.id + "." + name;
      problem(component, source.place,
              {"\"{}\" has several outputs; say which{}", "\"{}\" tiene varias salidas; diga cuál{}"}, from.id,
              offer("", names));
      return;
    }
    source.port = declared.front();
  } else {
    source.port = element_index(names, parts[1]);
  }
  if (source.port < 0 || parts.size() > 3) {
    problem(component, source.place, {"\"{}\" has no output \"{}\"{}", "\"{}\" no tiene la salida \"{}\"{}"}, from.id,
            source.text.substr(from.id.size() + 1), offer(parts[1], names));
    return;
  }
  const OutputShape& shape = from.outputs[static_cast<std::size_t>(source.port)];
  source.size = shape.size();
  if (parts.size() == 3) {
    source.element = element_index(shape.elements, parts[2]);
    source.size = 1;
    if (source.element < 0) {
      problem(component, source.place, {"\"{}.{}\" has no \"{}\"{}", "\"{}.{}\" no tiene \"{}\"{}"}, from.id,
              shape.name, parts[2], offer(parts[2], shape.elements));
      return;
    }
  }
  source.kind = Source::Kind::Output;
}

void Resolver::resolve_robot_command(const ComponentModel& component, Source& source,
                                     const std::vector<std::string>& parts) {
  const CommandChannel& channel = *robot_.command(parts[0]);
  std::vector<std::string> names;
  for (const CommandElement& element : channel.elements) names.push_back(element.name);
  if (parts.size() == 2) source.element = element_index(names, parts[1]);
  if (parts.size() > 2 || (parts.size() == 2 && source.element < 0)) {
    problem(component, source.place, {"command \"{}\" has no \"{}\"{}", "el mando \"{}\" no tiene \"{}\"{}"}, parts[0],
            parts[1], offer(parts[1], names));
    return;
  }
  if (!source.previous) {
    problem(component, source.place,
            {"the command of this tick is not made yet; write \"{}@previous\"",
             "el mando de este ciclo aún no está hecho; escriba \"{}@previous\""},
            source.text);
    return;
  }
  source.kind = Source::Kind::RobotCommand;
  source.component = static_cast<int>(&channel - robot_.commands.data());
  source.size = source.element >= 0 ? 1 : static_cast<int>(names.size());
}

std::string Resolver::unit_of(const Source& source) const {
  switch (source.kind) {
    case Source::Kind::SensationAge:
      return "s";
    case Source::Kind::RobotCommand: {
      const auto& elements = robot_.commands[static_cast<std::size_t>(source.component)].elements;
      return elements[static_cast<std::size_t>(std::max(0, source.element))].unit;
    }
    case Source::Kind::Sensation:
      return model_.components[static_cast<std::size_t>(source.component)].outputs.front().unit;
    default:
      return model_.components[static_cast<std::size_t>(source.component)]
          .outputs[static_cast<std::size_t>(source.port)]
          .unit;
  }
}

void Resolver::check_shape(const ComponentModel& component, const PortDescriptor& port, const Source& source) {
  const std::vector<std::string> elements = element_names(port);
  const int wanted = port.width();
  if (wanted != 0 && source.size != wanted) {
    const std::string shape = elements.empty() ? "" : fmt::format(" {{{}}}", join(elements));
    problem(component, source.place,
            {"input \"{}\" takes {} value{}{}, \"{}\" has {}{}",
             "la entrada \"{}\" admite {} valor{}{}, \"{}\" tiene {}{}"},
            port.name, wanted, wanted == 1 ? Text{"", ""} : Text{"s", "es"}, shape, source.text, source.size,
            wanted == 1 ? offer("", hints_.parts_of(source)) : Sentence());
  }
  const std::string unit = unit_of(source);
  if (port.unit != "*" && unit != port.unit) {
    problem(component, source.place,
            {"input \"{}\" is in [{}], \"{}\" is in [{}]{}", "la entrada \"{}\" está en [{}], \"{}\" está en [{}]{}"},
            port.name, port.unit.empty() ? "1" : port.unit, source.text, unit.empty() ? "1" : unit,
            offer("", hints_.sources_for(port)));
  }
}

/// Sensing modules and goals run before acting modules: what they take from those can only be of the tick before.
void Resolver::check_order(const ComponentModel& component, const PortDescriptor& port, const Source& source) {
  if (source.previous || source.kind != Source::Kind::Output || port.role == PortRole::Appraisal) return;
  const auto from = model_.components[static_cast<std::size_t>(source.component)].component_class;
  const bool late =
      from == ComponentClass::Acting || from == ComponentClass::Coordinator || from == ComponentClass::Goal;
  const bool early =
      component.component_class == ComponentClass::Sensing || component.component_class == ComponentClass::Goal;
  if (late && early) {
    problem(component, source.place,
            {"\"{}\" is known only later in the tick; write \"{}@previous\"",
             "\"{}\" solo se conoce más tarde en el ciclo; escriba \"{}@previous\""},
            source.text, source.text);
  }
}

/// Inputs with one wire for each candidate have as many as there are candidates.
void Resolver::check_candidates(const ComponentModel& component) {
  std::size_t candidates = 0;
  for (const Wire& wire : component.wires) {
    if (component.ports()[static_cast<std::size_t>(wire.port)].role == PortRole::Candidate) {
      candidates += wire.sources.size();
    }
  }
  for (const Wire& wire : component.wires) {
    const PortDescriptor& port = component.ports()[static_cast<std::size_t>(wire.port)];
    if (!port.each_candidate || wire.sources.size() == candidates) continue;
    look_at(fmt::format("in.{}", port.name), "");
    problem(component, wire.place,
            {"input \"{}\" has {} wires, must have one for each of the {} candidates, in their order",
             "la entrada \"{}\" tiene {} cables, debe tener uno por cada uno de los {} candidatos, en su orden"},
            port.name, wire.sources.size(), candidates);
  }
}

}  // namespace

void resolve(ControllerModel& model, const Description& robot, Problems& problems) {
  Resolver(model, robot, problems).run();
}

}  // namespace ganglion
