// Who asks whom: goals and commands that become requests, and who hears what becomes of them.
#include "ganglion/graph/compiler.h"

namespace ganglion {

void Compiler::connect_request(std::size_t index, std::size_t port_index) {
  const ComponentModel& model = model_.components[index];
  const PortDescriptor& port = model.descriptor->ports[port_index];
  Part& part = controller_.parts_[index];
  if (!part.request) part.request = std::make_unique<RequestSlot>();
  part.request->width = port.elements.empty() ? port.size : static_cast<int>(port.elements.size());
  const Wire* wire = model.wire(static_cast<int>(port_index));
  if (wire == nullptr) return;
  std::vector<GlobalGoal*> goals;
  for (const Source& source : wire->sources) {
    Part& from = this->part(source.component);
    if (source.kind == Source::Kind::Goal) goals.push_back(from.goal.get());
    if (source.kind != Source::Kind::ModuleCommand) continue;
    from.below = part.request.get();
    asked_[static_cast<std::size_t>(source.component)] = static_cast<int>(index);
  }
  if (!goals.empty()) part.arbiter.emplace(std::move(goals), model.preemption);
}

/// A module whose command a coordinator makes a request of another module hears what becomes of it, and pays what that
/// module pays.
void Compiler::connect_answers() {
  for (std::size_t i = 0; i < controller_.parts_.size(); ++i) {
    Part& part = controller_.parts_[i];
    if (!part.acting) continue;
    if (part.below != nullptr) part.acting->set_below(part.below);
    if (taker_[i] < 0) continue;
    auto last = static_cast<std::size_t>(taker_[i]);
    while (taker_[last] >= 0) last = static_cast<std::size_t>(taker_[last]);  // no circle: the order was found
    if (asked_[last] < 0) continue;
    part.charged_by = asked_[last];
    part.acting->set_answer(this->part(part.charged_by).request.get());
  }
}

}  // namespace ganglion
