#include "ganglion/graph/order.h"

#include <algorithm>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

using Edges = std::vector<std::vector<int>>;  // for each component those that must run before it

Edges edges_of(const ControllerModel& model) {
  Edges before(model.components.size());
  for (std::size_t i = 0; i < model.components.size(); ++i) {
    const ComponentModel& component = model.components[i];
    for (const Wire& wire : component.wires) {
      const PortRole role = component.descriptor->ports[static_cast<std::size_t>(wire.port)].role;
      if (role == PortRole::Appraisal) continue;  // of the tick before by its nature
      for (const Source& source : wire.sources) {
        const bool within = source.kind == Source::Kind::Output || source.kind == Source::Kind::ModuleCommand;
        if (within && !source.previous) before[i].push_back(source.component);
      }
    }
  }
  return before;
}

/// Follows unfinished predecessors until one comes twice: a, b, a in the order they would run.
std::vector<int> cycle_from(const Edges& before, const std::vector<bool>& done, int start) {
  std::vector<int> path;
  int at = start;
  while (std::find(path.begin(), path.end(), at) == path.end()) {
    path.push_back(at);
    for (const int previous : before[static_cast<std::size_t>(at)]) {
      if (!done[static_cast<std::size_t>(previous)]) {
        at = previous;
        break;
      }
    }
  }
  path.erase(path.begin(), std::find(path.begin(), path.end(), at));
  path.push_back(at);
  std::reverse(path.begin(), path.end());
  return path;
}

/// The first wire of the circle that may carry the value of the tick before; commands may not. Null if there is none.
const Source* breakable(const ControllerModel& model, const std::vector<int>& path) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    for (const Wire& wire : model.components[static_cast<std::size_t>(path[i])].wires) {
      for (const Source& source : wire.sources) {
        if (source.kind == Source::Kind::Output && source.component == path[i - 1] && !source.previous) return &source;
      }
    }
  }
  return nullptr;
}

void report_cycle(const ControllerModel& model, const std::vector<int>& path, Problems& problems) {
  std::vector<std::string> names;
  for (const int index : path) names.push_back(model.components[static_cast<std::size_t>(index)].id);
  const Source* source = breakable(model, path);
  const std::string remedy = source != nullptr ? fmt::format("write \"{}@previous\" to break it", source->text)
                                               : std::string("commands cannot; take one of these wires out");
  problems.add(source != nullptr ? source->place : model.components[static_cast<std::size_t>(path.back())].place,
               ErrorCode::BadWire, "{}: these wires run in a circle within one tick: {}; {}", names.back(),
               join(names, " -> "), remedy);
}

std::vector<int> sorted(const ControllerModel& model, Problems& problems) {
  const Edges before = edges_of(model);
  std::vector<bool> done(model.components.size(), false);
  std::vector<int> result;
  while (result.size() < model.components.size()) {
    int next = -1;
    for (std::size_t i = 0; i < done.size() && next < 0; ++i) {
      const auto finished = [&](int index) { return done[static_cast<std::size_t>(index)]; };
      if (!done[i] && std::all_of(before[i].begin(), before[i].end(), finished)) next = static_cast<int>(i);
    }
    if (next < 0) {
      const auto stuck = std::find(done.begin(), done.end(), false) - done.begin();
      report_cycle(model, cycle_from(before, done, static_cast<int>(stuck)), problems);
      return result;
    }
    done[static_cast<std::size_t>(next)] = true;
    result.push_back(next);
  }
  return result;
}

}  // namespace

Schedule order(const ControllerModel& model, Problems& problems) {
  Schedule schedule;
  for (const int index : sorted(model, problems)) {
    switch (model.components[static_cast<std::size_t>(index)].component_class) {
      case ComponentClass::Sensing:
        schedule.sensing.push_back(index);
        break;
      case ComponentClass::Goal:
        schedule.goals.push_back(index);
        break;
      case ComponentClass::Acting:
        schedule.acting.push_back(index);
        schedule.upward.insert(schedule.upward.begin(), index);
        break;
      case ComponentClass::Coordinator:
        schedule.acting.push_back(index);
        break;
      default:
        break;
    }
  }
  return schedule;
}

}  // namespace ganglion
