#include "ganglion/studio/document/connect.h"

#include <algorithm>
#include <map>

#include "ganglion/base/text.h"
#include "ganglion/graph/order.h"

namespace ganglion::studio {
namespace {

/// What the checks say, in the order of its English.
using Complaints = std::multimap<std::string, Sentence>;

Complaints checked(ControllerModel model, const Description& robot) {
  Problems problems;
  resolve(model, robot, problems);
  order(model, problems);
  Complaints complaints;
  for (Error& error : problems.sorted()) complaints.emplace(error.what.en, std::move(error.what));
  return complaints;
}

/// What is said of the component itself does not begin with its id.
Sentence without_id(const Sentence& sentence, const std::string& id) {
  const std::string opening = id + ": ";
  const auto rest = [&](const std::string& text) {
    return text.starts_with(opening) ? text.substr(opening.size()) : text;
  };
  return {rest(sentence.en), rest(sentence.es)};
}

/// Of a drawing with thousands of components not every wire is tried one by one, which takes a look at all of them.
constexpr std::size_t kMostLooks = 30'000;
constexpr std::size_t kFewestTrials = 10;

/// Tries wires on a drawing: each on a copy of its model, held against the same checks as a file.
class Trial {
 public:
  explicit Trial(const Drawing& drawing)
      : drawing_(drawing),
        left_(std::max(kFewestTrials, kMostLooks / std::max<std::size_t>(1, drawing.unresolved.components.size()))) {
    if (drawing.robot) before_ = checked(drawing.unresolved, *drawing.robot);
  }

  Connection run(const std::string& from, int component, int port) {
    const ComponentModel& to = drawing_.unresolved.components[static_cast<std::size_t>(component)];
    const PortDescriptor& input = to.ports()[static_cast<std::size_t>(port)];
    Connection connection{to.id, std::string(input.name), from, {}};
    if (!drawing_.robot) {
      connection.reasons.push_back(
          say({"the robot this is drawn for is not known", "no se conoce el robot para el que está dibujado"}));
      return connection;
    }
    if (left_ == 0) {
      connection.reasons.push_back(
          say({"this drawing is too large to try every wire at once; ask for this one alone",
               "este dibujo es demasiado grande para probar todos los cables a la vez; pregunte solo por este"}));
      return connection;
    }
    --left_;
    ControllerModel model = drawing_.unresolved;
    if (!add(model.components[static_cast<std::size_t>(component)], input, port, from)) {
      connection.reasons.push_back(say({"\"{}\" is wired to it already", "\"{}\" ya está conectado a ella"}, from));
      return connection;
    }
    for (const auto& [english, what] : checked(std::move(model), *drawing_.robot)) {
      if (!before_.contains(english)) connection.reasons.push_back(without_id(what, to.id));
    }
    return connection;
  }

 private:
  static bool add(ComponentModel& to, const PortDescriptor& input, int port, const std::string& from) {
    const auto found = std::find_if(to.wires.begin(), to.wires.end(), [&](const Wire& w) { return w.port == port; });
    if (found == to.wires.end()) {
      to.wires.push_back({port, {Source{.text = from, .place = to.place}}, to.place});
      return true;
    }
    for (const Source& source : found->sources) {
      if (source.text == from) return false;
    }
    if (!input.many) found->sources.clear();
    found->sources.push_back(Source{.text = from, .place = to.place});
    return true;
  }

  const Drawing& drawing_;
  std::size_t left_;
  Complaints before_;
};

std::string source_id(const std::string& from) { return from.substr(0, from.find_first_of(".@")); }

/// The components that `from` needs in its tick: a wire to one of them would close a circle.
std::vector<bool> upstream_of(const ControllerModel& model, int from) {
  std::vector<bool> seen(model.components.size(), false);
  std::vector<int> open;
  if (from >= 0) open.push_back(from);
  while (!open.empty()) {
    const auto at = static_cast<std::size_t>(open.back());
    open.pop_back();
    if (seen[at]) continue;
    seen[at] = true;
    for (const Wire& wire : model.components[at].wires) {
      for (const Source& source : wire.sources) {
        const bool within = source.kind == Source::Kind::Output || source.kind == Source::Kind::ModuleCommand;
        if (within) open.push_back(source.component);
      }
    }
  }
  return seen;
}

/// The components that need `to` in their tick.
std::vector<bool> downstream_of(const ControllerModel& model, int to) {
  std::vector<std::vector<int>> takers(model.components.size());
  for (std::size_t i = 0; i < takers.size(); ++i) {
    for (const Wire& wire : model.components[i].wires) {
      for (const Source& source : wire.sources) {
        const bool within = source.kind == Source::Kind::Output || source.kind == Source::Kind::ModuleCommand;
        if (within) takers[static_cast<std::size_t>(source.component)].push_back(static_cast<int>(i));
      }
    }
  }
  std::vector<bool> seen(takers.size(), false);
  std::vector<int> open = {to};
  while (!open.empty()) {
    const auto at = static_cast<std::size_t>(open.back());
    open.pop_back();
    if (seen[at]) continue;
    seen[at] = true;
    open.insert(open.end(), takers[at].begin(), takers[at].end());
  }
  return seen;
}

/// All of a giver that a port looks at.
std::string shape_of(const ComponentModel& giver, const OutputShape* output) {
  std::string shape = fmt::format("{}", static_cast<int>(giver.component_class));
  if (output == nullptr) return shape;
  shape += fmt::format("|{}|{}|{}", output->unit, static_cast<int>(output->type), output->declared);
  for (const std::string& element : output->elements) shape += "|" + element;
  return shape;
}

bool is_input_of(const ComponentModel& component, std::size_t port) {
  return is_input(component.component_class, component.ports()[port].role);
}

/// Whether all components of a kind take or refuse a source at this port for the same reasons: the checks then look at
/// the port, not at who has it.
bool same_for_its_kind(const PortDescriptor& port, const ComponentModel* from, const std::string& text) {
  if (port.role == PortRole::Request || port.role == PortRole::Candidate) {
    const bool can_ask = from != nullptr && from->id == text && from->component_class != ComponentClass::Sensation &&
                         from->component_class != ComponentClass::Sensing;
    return !can_ask;
  }
  return port.unit != "*" && port.size != 0;
}

bool wired_to(const ComponentModel& component, int port, const std::string& text) {
  const Wire* wire = component.wire(port);
  return wire != nullptr && std::any_of(wire->sources.begin(), wire->sources.end(),
                                        [&](const Source& source) { return source.text == text; });
}

}  // namespace

Connection may_connect(const Drawing& drawing, const std::string& from, const std::string& component,
                       const std::string& port) {
  const int index = drawing.unresolved.find(component);
  const ComponentModel* to = index >= 0 ? &drawing.unresolved.components[static_cast<std::size_t>(index)] : nullptr;
  const PortDescriptor* input = to != nullptr && to->descriptor != nullptr ? to->descriptor->port(port) : nullptr;
  if (input == nullptr || !is_input(to->component_class, input->role)) {
    const Sentence reason =
        say({"there is no input \"{}\" of a component \"{}\"", "no existe la entrada \"{}\" de un componente \"{}\""},
            port, component);
    return {component, port, from, {reason}};
  }
  return Trial(drawing).run(from, index, static_cast<int>(input - to->ports().data()));
}

std::vector<Connection> targets_of(const Drawing& drawing, const std::string& from) {
  Trial trial(drawing);
  const int giver = drawing.model.find(source_id(from));
  const ComponentModel* source = giver >= 0 ? &drawing.model.components[static_cast<std::size_t>(giver)] : nullptr;
  const std::vector<bool> upstream = upstream_of(drawing.model, giver);
  std::map<const PortDescriptor*, std::vector<Sentence>> known;
  std::vector<Connection> result;
  for (std::size_t i = 0; i < drawing.unresolved.components.size(); ++i) {
    const ComponentModel& component = drawing.unresolved.components[i];
    if (component.descriptor == nullptr) continue;
    for (std::size_t p = 0; p < component.ports().size(); ++p) {
      const PortDescriptor& port = component.ports()[p];
      if (!is_input_of(component, p)) continue;
      const bool shared =
          same_for_its_kind(port, source, from) && !upstream[i] && !wired_to(component, static_cast<int>(p), from);
      const auto found = shared ? known.find(&port) : known.end();
      if (found != known.end()) {
        result.push_back({component.id, std::string(port.name), from, found->second});
        continue;
      }
      result.push_back(trial.run(from, static_cast<int>(i), static_cast<int>(p)));
      if (shared) known[&port] = result.back().reasons;
    }
  }
  return result;
}

std::vector<Connection> sources_for(const Drawing& drawing, const std::string& component, const std::string& port) {
  std::vector<Connection> result;
  const int index = drawing.unresolved.find(component);
  const ComponentModel* to = index >= 0 ? &drawing.unresolved.components[static_cast<std::size_t>(index)] : nullptr;
  const PortDescriptor* input = to != nullptr && to->descriptor != nullptr ? to->descriptor->port(port) : nullptr;
  if (input == nullptr || !is_input(to->component_class, input->role)) return result;
  Trial trial(drawing);
  const auto position = static_cast<int>(input - to->ports().data());
  const std::vector<bool> downstream = downstream_of(drawing.model, index);
  std::map<std::string, std::vector<Sentence>> known;  // reasons by what of a giver they depend on
  const auto offer = [&](std::size_t giver, const OutputShape* output, const std::string& text) {
    const ComponentModel& from = drawing.model.components[giver];
    const bool shared = same_for_its_kind(*input, &from, text) && !downstream[giver] && !wired_to(*to, position, text);
    const std::string key = shared ? shape_of(from, output) : "";
    const auto found = shared ? known.find(key) : known.end();
    if (found != known.end()) {
      result.push_back({component, port, text, found->second});
      return;
    }
    result.push_back(trial.run(text, index, position));
    if (shared && result.back().reasons.empty()) known[key] = {};  // reasons name the giver
  };
  const bool hands_on = input->role == PortRole::Candidate || input->role == PortRole::Request;
  for (std::size_t i = 0; i < drawing.model.components.size(); ++i) {
    const ComponentModel& giver = drawing.model.components[i];
    if (hands_on || giver.component_class == ComponentClass::Sensation) {
      const OutputShape* output = giver.outputs.empty() ? nullptr : &giver.outputs.front();
      if (giver.component_class != ComponentClass::Sensation || !hands_on) offer(i, output, giver.id);
      continue;
    }
    for (const OutputShape& output : giver.outputs) offer(i, &output, fmt::format("{}.{}", giver.id, output.name));
  }
  return result;
}

}  // namespace ganglion::studio
