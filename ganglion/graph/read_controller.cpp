#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "ganglion/base/text.h"
#include "ganglion/config/table.h"
#include "ganglion/graph/model.h"

namespace ganglion {
namespace {

using config::Table;

constexpr double kShortestTick_s = 1e-6;

constexpr std::array kClasses = {ComponentClass::Sensation, ComponentClass::Sensing, ComponentClass::Goal,
                                 ComponentClass::Acting, ComponentClass::Coordinator};

bool good_id(std::string_view id) noexcept {
  auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !id.empty() && id.size() <= 64 && letter(id.front()) &&
         std::all_of(id.begin(), id.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

void read_id(Table& table, ComponentModel& component) {
  component.id = table.text("id", "");
  component.place = table.place("id");
  if (!table.has("id")) {
    table.problem("id", ErrorCode::MissingKey,
                  {"id is missing; write id = \"a_name\"", "falta id; escriba id = \"un_nombre\""});
  } else if (!good_id(component.id)) {
    table.problem("id", ErrorCode::BadParameter,
                  {"\"{}\" is no id: write a letter, then letters, digits or _, at most 64 in all",
                   "\"{}\" no es un id: escriba una letra y después letras, cifras o _, 64 como máximo en total"},
                  component.id);
  }
  table.set_context(component.id);
}

/// "acting module", as in "no kind of acting module": of the classes in kClasses.
Text noun_of(ComponentClass component_class) {
  constexpr std::array<Text, 5> kNouns = {{{"sensation", "sensación"},
                                           {"sensing module", "módulo de detección"},
                                           {"goal", "objetivo global"},
                                           {"acting module", "módulo de actuación"},
                                           {"coordinator", "coordinador"}}};
  return kNouns[static_cast<std::size_t>(component_class)];
}

const Descriptor* read_kind(Table& table, ComponentClass component_class, const KindList& kinds) {
  const std::string name = table.text("kind", "");
  const Descriptor* descriptor = find_descriptor(kinds, component_class, name);
  if (descriptor != nullptr) {
    table.is_of(*descriptor);
    return descriptor;
  }
  for (const ComponentClass other : kClasses) {
    if (find_descriptor(kinds, other, name) == nullptr) continue;
    table.problem("kind", ErrorCode::UnknownKey,
                  {"\"{}\" is a kind of {}; write it under [[{}]], not [[{}]]",
                   "\"{}\" es un tipo de {}; escríbalo en [[{}]], no en [[{}]]"},
                  name, noun_of(other), name_of(other), name_of(component_class));
    return nullptr;
  }
  std::vector<std::string> names;
  for (const Descriptor* known : descriptors_of(kinds, component_class)) names.emplace_back(known->name);
  if (!table.has("kind")) {
    table.problem("kind", Error{ErrorCode::MissingKey,
                                say({"kind is missing{}", "falta kind{}"}, suggestion("", names)),
                                {},
                                {.choices = names}});
  } else if (table.value("kind")->string() != nullptr) {
    table.problem("kind", Error{ErrorCode::UnknownKey,
                                say({"\"{}\" is no kind of {}{}", "\"{}\" no es un tipo de {}{}"}, name,
                                    noun_of(component_class), suggestion(name, names)),
                                {},
                                {.found = name, .choices = names}});
  }
  return nullptr;
}

std::vector<std::string> input_names(const ComponentModel& component) {
  std::vector<std::string> names;
  for (const PortDescriptor& port : component.ports()) {
    if (is_input(component.component_class, port.role)) names.emplace_back(port.name);
  }
  return names;
}

std::vector<Source> read_sources(Table& in, const std::string& port) {
  std::vector<Source> sources;
  const config::Value* value = in.value(port);
  const config::Array* list = value->array();
  const std::vector<std::string> texts = in.texts(port);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    Source source;
    source.text = texts[i];
    source.place = list != nullptr && i < list->size() ? (*list)[i].place() : value->place();
    sources.push_back(std::move(source));
  }
  return sources;
}

/// Reads the `in` table of one component.
class WireReader {
 public:
  WireReader(Table& table, ComponentModel& component)
      : table_(table), component_(component), descriptor_(*component.descriptor), names_(input_names(component)) {}

  void run() {
    misplaced();
    Table in = table_.table("in");
    if (table_.has("in") && table_.value("in")->table() == nullptr) return;
    in.set_context(component_.id);
    for (const std::string& name : in.keys()) {
      in.known(name);
      if (!in.problems().full()) read(in, name);
    }
    for (const PortDescriptor& port : component_.ports()) {
      if (!port.required || !is_input(descriptor_.component_class, port.role) || given(port.name)) continue;
      table_.problem("id", Error{ErrorCode::BadWire,
                                 say({"input \"{}\" is not wired; write in.{} = \"...\"",
                                      "la entrada \"{}\" no está conectada; escriba in.{} = \"...\""},
                                     port.name, port.name),
                                 {},
                                 {.part = fmt::format("in.{}", port.name)}});
    }
  }

 private:
  /// Inputs written without `in.` are told apart from unknown keys.
  void misplaced() {
    for (const std::string& name : names_) {
      if (name == "in" || !table_.has(name) || descriptor_.parameter(name) != nullptr) continue;
      table_.known(name);
      table_.problem(name, ErrorCode::UnknownKey,
                     {"\"{}\" is an input; write in.{} = \"...\"", "\"{}\" es una entrada; escriba in.{} = \"...\""},
                     name, name);
      given_.push_back(name);
    }
  }

  void read(Table& in, const std::string& name) {
    const PortDescriptor* port = component_.port(name);
    if (port == nullptr || !is_input(descriptor_.component_class, port->role)) {
      const Sentence hint = names_.empty() ? say({"; it takes none", "; no tiene ninguna"}) : suggestion(name, names_);
      in.problem(name, Error{ErrorCode::UnknownKey,
                             say({"{} has no input \"{}\"{}", "{} no tiene la entrada \"{}\"{}"}, descriptor_.name,
                                 name, hint),
                             {},
                             {.part = "in." + name, .found = name, .choices = names_}});
      if (auto meant = nearest(name, names_)) given_.push_back(std::move(*meant));
      return;
    }
    if (const config::Array* many = in.value(name)->array(); many != nullptr && many->size() > kMaxWires) {
      in.problem(name, ErrorCode::TooLarge,
                 {"input \"{}\" has {} wires; the limit is {}", "la entrada \"{}\" tiene {} cables; el límite es {}"},
                 name, many->size(), kMaxWires);
      return;
    }
    Wire wire;
    wire.port = static_cast<int>(port - component_.ports().data());
    wire.place = in.place(name);
    wire.sources = read_sources(in, name);
    const config::Array* list = in.value(name)->array();
    if (list == nullptr || !list->empty()) given_.push_back(name);
    if (!port->many && !port->each_candidate && port->role != PortRole::Request && wire.sources.size() > 1) {
      in.problem(name, Error{ErrorCode::BadWire,
                             say({"input \"{}\" takes one wire, not {}", "la entrada \"{}\" admite un cable, no {}"},
                                 name, wire.sources.size()),
                             {},
                             {.part = "in." + name}});
    }
    component_.wires.push_back(std::move(wire));
  }

  bool given(std::string_view name) const { return std::find(given_.begin(), given_.end(), name) != given_.end(); }

  Table& table_;
  ComponentModel& component_;
  const Descriptor& descriptor_;
  std::vector<std::string> names_;
  std::vector<std::string> given_;  // wired, or meant to be by what was reported already
};

/// How near the reading of its first Feedback port must come to what is sought: one number for all its values, or a list
/// with one for each.
void read_tolerance(const Table& table, ComponentModel& component) {
  const std::vector<double> given = component.common.filled<ActingCommon>().tolerance;
  const PortDescriptor* port = component.port_of(PortRole::Feedback);
  if (port == nullptr) return;
  const auto width = static_cast<std::size_t>(port->width());
  if (given.size() > 1 && width != 0 && given.size() != width) {
    table.problem("tolerance", ErrorCode::BadParameter,
                  {"tolerance has {} numbers, but \"{}\" has {} values; write one number, or one for each",
                   "tolerance tiene {} números, pero \"{}\" tiene {} valores; escriba un número, o uno para cada uno"},
                  given.size(), port->name, width);
    return;
  }
  for (std::size_t i = 0; i < kMaxCommandValues; ++i) {
    double& tolerance = component.comparison.tolerance[i];
    component.comparison.circular[i] = port->type_of(i) == ValueType::Circular;
    tolerance = given.empty() ? default_tolerance(*port, i) : given[std::min(i, given.size() - 1)];
    if (tolerance == 0 || port->type_of(i) != ValueType::Discrete) continue;
    table.problem(
        "tolerance", ErrorCode::BadParameter,
        {"tolerance is {}, but \"{}\" is made of whole numbers, which are compared exactly; leave it out",
         "tolerance es {}, pero \"{}\" se compone de números enteros, que se comparan con exactitud; quítela"},
        shortest(tolerance), port->name);
    return;
  }
}

/// The parameter in whose file an error stands, or that it names itself; "id" where it is about all of them.
std::string part_of(const Error& error, const ComponentModel& component) {
  if (!error.subject.part.empty() || error.place.file.empty())
    return error.subject.part.empty() ? "id" : error.subject.part;
  for (const ParameterDescriptor& parameter : component.parameters.descriptors()) {
    if (parameter.type != ParameterType::File) continue;
    if (component.parameters.file(parameter.name).at(0).file == error.place.file) return std::string(parameter.name);
  }
  return "id";
}

/// What a kind says of its parameters taken together: its ports as they shape them, and one is made on trial, so that
/// nothing is refused later that could be refused here.
template <class Product>
void try_kind(std::span<const Kind<Product>* const> kinds, const Table& table, ComponentModel& component) {
  const Kind<Product>& kind = *find_kind(kinds, component.descriptor->name);
  const auto refuse = [&](const Error& error) { table.problem(part_of(error, component), error); };
  if (kind.shape != nullptr) {
    auto shaped = kind.shape(component.parameters);
    if (!shaped) return refuse(shaped.error());
    component.shaped = std::make_shared<const Ports>(std::move(*shaped));
  }
  if (const auto made = kind.make(component.parameters); !made) refuse(made.error());
}

void try_component(const KindList& kinds, const Table& table, ComponentModel& component) {
  if (component.component_class == ComponentClass::Sensing) try_kind(kinds.sensing, table, component);
  if (component.component_class == ComponentClass::Goal) try_kind(kinds.goal, table, component);
  if (component.component_class == ComponentClass::Acting) try_kind(kinds.acting, table, component);
  if (component.component_class == ComponentClass::Coordinator) try_kind(kinds.coordinator, table, component);
}

void read_component(Table& table, ComponentClass component_class, const KindList& kinds, ControllerModel& model) {
  ComponentModel component;
  component.component_class = component_class;
  read_id(table, component);
  if (component.id.empty()) model.misread.emplace_back();
  if (component_class == ComponentClass::Sensation) {
    component.channel = table.text("channel");
    component.channel_place = table.place("channel");
    const config::Value* channel = table.value("channel");
    if (channel != nullptr && channel->string() != nullptr && component.channel.empty()) {
      table.problem("channel", ErrorCode::BadParameter,
                    {"channel is empty; name a channel of the robot", "channel está vacío; nombre un canal del robot"});
    }
    model.components.push_back(std::move(component));
    return;
  }
  component.descriptor = read_kind(table, component_class, kinds);
  if (component.descriptor == nullptr) {  // its keys cannot be judged
    for (const std::string& key : table.keys()) table.known(key);
    model.misread.push_back(component.id);
    return;
  }
  if (component_class == ComponentClass::Acting || component_class == ComponentClass::Coordinator) {
    component.command = table.text("command", "");
    component.command_place = table.place("command");
  }
  const std::size_t before = table.problems().size();
  component.common = table.parameters(common_parameters(component_class));
  component.parameters = table.parameters(component.descriptor->parameters);
  if (table.problems().size() == before) try_component(kinds, table, component);
  if (component_class == ComponentClass::Acting) read_tolerance(table, component);
  WireReader(table, component).run();
  model.components.push_back(std::move(component));
}

/// Bytes of the files that its parameters name.
std::size_t file_bytes(const ComponentModel& component) {
  std::size_t bytes = 0;
  for (const ParameterDescriptor& parameter : component.parameters.descriptors()) {
    if (parameter.type == ParameterType::File) bytes += component.parameters.file(parameter.name).text.size();
  }
  return bytes;
}

/// Ids under headers that are no class of components, [[actin]], or not written as a list, [acting].
void gather_misread(Table& root, ControllerModel& model) {
  const auto is_class = [](std::string_view key) {
    return std::any_of(kClasses.begin(), kClasses.end(), [&](ComponentClass c) { return name_of(c) == key; });
  };
  const auto take = [&](const config::Value& table) {
    const config::Value* id = table.find("id");
    if (id != nullptr && id->string() != nullptr) model.misread.push_back(*id->string());
  };
  for (const auto& [key, value] : root.members()) {
    if (value.table() != nullptr) take(value);
    if (value.array() == nullptr || is_class(key)) continue;
    for (const config::Value& item : *value.array()) take(item);
  }
}

void check_ids(const ControllerModel& model, Problems& problems) {
  for (std::size_t i = 0; i < model.components.size(); ++i) {
    const ComponentModel& component = model.components[i];
    const int first = model.find(component.id);
    if (component.id.empty() || first == static_cast<int>(i)) continue;
    problems.add(component.place, ErrorCode::BadParameter,
                 {"{}: this id is already used at line {}", "{}: este id ya se usa en la línea {}"}, component.id,
                 model.components[static_cast<std::size_t>(first)].place.line);
  }
}

}  // namespace

double default_tolerance(const PortDescriptor& port, std::size_t element) noexcept {
  if (port.type_of(element) == ValueType::Discrete) return 0;
  if (port.unit_of(element) == "rad") return 5 * std::numbers::pi / 180;
  return port.unit_of(element) == "m" ? 0.05 : 0;
}

const PortDescriptor* ComponentModel::port(std::string_view name) const noexcept {
  for (const PortDescriptor& candidate : ports()) {
    if (candidate.name == name) return &candidate;
  }
  return nullptr;
}

const PortDescriptor* ComponentModel::port_of(PortRole role) const noexcept {
  for (const PortDescriptor& candidate : ports()) {
    if (candidate.role == role) return &candidate;
  }
  return nullptr;
}

const Wire* ComponentModel::wire(int port) const noexcept {
  for (const Wire& candidate : wires) {
    if (candidate.port == port) return &candidate;
  }
  return nullptr;
}

int ControllerModel::find(std::string_view id) const noexcept {
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (components[i].id == id) return static_cast<int>(i);
  }
  return -1;
}

ControllerModel read_controller(const config::Value& value, const KindList& kinds, Problems& problems,
                                FileReader* files, config::Outline* outline) {
  ControllerModel model;
  Table root(value, "", problems, outline);
  root.opens_by(files);
  config::check_format(root);
  model.name = root.text("name", "");
  model.robot = root.path("robot");
  model.tick_s = root.number("tick_s", 0, config::Range{0, 3600});
  if (model.tick_s > 0 && model.tick_s < kShortestTick_s) {
    root.problem("tick_s", ErrorCode::BadParameter,
                 {"tick_s is {}, must be >= {}, or 0 for that of the robot",
                  "tick_s es {}, debe ser >= {}, o 0 para el del robot"},
                 shortest(model.tick_s), shortest(kShortestTick_s));
  }
  root.known("layout");
  std::size_t bytes = 0;
  bool refused = false;  // the rest is not looked at, and not complained of
  for (const ComponentClass component_class : kClasses) {
    for (Table& table : root.tables(name_of(component_class))) {
      const bool too_many = model.components.size() >= kMaxComponents;
      if (too_many || bytes > kMaxFileTexts) {
        for (const std::string& key : table.keys()) table.known(key);
        if (std::exchange(refused, true)) continue;
        if (too_many) {
          root.problem("", ErrorCode::TooLarge, {"more than {} components", "más de {} componentes"}, kMaxComponents);
        } else {
          table.problem("", ErrorCode::TooLarge,
                        {"the files that parameters name have more than {} bytes together",
                         "los archivos que nombran los parámetros suman más de {} bytes"},
                        kMaxFileTexts);
        }
        continue;
      }
      const std::size_t before = model.components.size();
      read_component(table, component_class, kinds, model);
      if (model.components.size() > before) bytes += file_bytes(model.components.back());
    }
  }
  if (refused) return model;
  gather_misread(root, model);
  check_ids(model, problems);
  return model;
}

}  // namespace ganglion
