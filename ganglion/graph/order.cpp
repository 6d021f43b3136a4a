#include "ganglion/graph/order.h"

#include <algorithm>
#include <functional>
#include <queue>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

using Edges = std::vector<std::vector<int>>;

/// For each component those that must run before it.
Edges predecessors_of(const ControllerModel& model) {
  Edges before(model.components.size());
  for (std::size_t i = 0; i < model.components.size(); ++i) {
    const ComponentModel& component = model.components[i];
    for (const Wire& wire : component.wires) {
      const PortRole role = component.ports()[static_cast<std::size_t>(wire.port)].role;
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
  std::vector<bool> seen(before.size(), false);
  std::vector<int> path;
  int at = start;
  while (!seen[static_cast<std::size_t>(at)]) {
    seen[static_cast<std::size_t>(at)] = true;
    path.push_back(at);
    const auto& previous = before[static_cast<std::size_t>(at)];
    at = *std::find_if(previous.begin(), previous.end(),
                       [&](int index) { return !done[static_cast<std::size_t>(index)]; });
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
  const Sentence remedy =
      source != nullptr
          ? say({"write \"{}@previous\" to break it", "escriba \"{}@previous\" para romperlo"}, source->text)
          : say({"commands cannot; take one of these wires out", "los mandos no pueden; quite uno de estos cables"});
  problems.add(source != nullptr ? source->place : model.components[static_cast<std::size_t>(path.back())].place,
               ErrorCode::BadWire,
               {"{}: these wires run in a circle within one tick: {}; {}",
                "{}: estos cables forman un círculo dentro de un ciclo: {}; {}"},
               names.back(), join(names, " -> "), remedy);
}

/// Kahn's algorithm, the earliest in the file first among those that may run; linear in wires but for a logarithm.
class Sorter {
 public:
  Sorter(const ControllerModel& model, Problems& problems)
      : model_(model),
        problems_(problems),
        before_(predecessors_of(model)),
        after_(before_.size()),
        done_(before_.size()) {
    for (std::size_t i = 0; i < before_.size(); ++i) {
      waits_for_.push_back(before_[i].size());
      for (const int previous : before_[i]) after_[static_cast<std::size_t>(previous)].push_back(static_cast<int>(i));
      if (before_[i].empty()) ready_.push(static_cast<int>(i));
    }
  }

  std::vector<int> run() {
    for (std::size_t first = 0; result_.size() < done_.size() && !problems_.full();) {
      if (!ready_.empty()) {
        const int next = ready_.top();
        ready_.pop();
        if (!done_[static_cast<std::size_t>(next)]) finish(next);
        continue;
      }
      while (done_[first]) ++first;
      const std::vector<int> circle = cycle_from(before_, done_, static_cast<int>(first));
      report_cycle(model_, circle, problems_);
      for (std::size_t i = 1; i < circle.size(); ++i) finish(circle[i]);  // as if it were cut, to find the next
    }
    return std::move(result_);
  }

 private:
  void finish(int index) {
    done_[static_cast<std::size_t>(index)] = true;
    result_.push_back(index);
    for (const int next : after_[static_cast<std::size_t>(index)]) {
      if (--waits_for_[static_cast<std::size_t>(next)] == 0) ready_.push(next);
    }
  }

  const ControllerModel& model_;
  Problems& problems_;
  Edges before_, after_;
  std::vector<bool> done_;
  std::vector<std::size_t> waits_for_;
  std::priority_queue<int, std::vector<int>, std::greater<>> ready_;
  std::vector<int> result_;
};

}  // namespace

Schedule order(const ControllerModel& model, Problems& problems) {
  Schedule schedule;
  for (const int index : Sorter(model, problems).run()) {
    switch (model.components[static_cast<std::size_t>(index)].component_class) {
      case ComponentClass::Sensing:
        schedule.sensing.push_back(index);
        break;
      case ComponentClass::Goal:
        schedule.goals.push_back(index);
        break;
      case ComponentClass::Acting:
        schedule.acting.push_back(index);
        break;
      case ComponentClass::Coordinator:
        schedule.acting.push_back(index);
        break;
      default:
        break;
    }
  }
  for (auto index = schedule.acting.rbegin(); index != schedule.acting.rend(); ++index) {
    const bool acts = model.components[static_cast<std::size_t>(*index)].component_class == ComponentClass::Acting;
    if (acts) schedule.upward.push_back(*index);
  }
  return schedule;
}

}  // namespace ganglion
