// Who asks whom: goals and commands that become requests, and who hears what becomes of them.
#include "ganglion/graph/compiler.h"

namespace ganglion {

void Compiler::connect_request(std::size_t index, std::size_t port_index) {
  const ComponentModel& model = model_.components[index];
  const PortDescriptor& port = model.ports()[port_index];
  auto& acting = *controller_.parts_[index].as<layout::ActingRole>();
  if (!acting.request) acting.request = std::make_unique<RequestSlot>();
  acting.request->width = port.width();
  acting.request->standing = port.standing;
  const Wire* wire = model.wire(static_cast<int>(port_index));
  if (wire == nullptr) return;
  std::vector<int> goals;
  for (const Source& source : wire->sources) {
    if (source.kind == Source::Kind::Goal) goals.push_back(source.component);
    if (source.kind != Source::Kind::ModuleCommand) continue;
    Part& from = part(source.component);
    if (auto* upper = from.as<layout::ActingRole>()) upper->below = acting.request.get();
    if (auto* upper = from.as<layout::CoordinatorRole>()) upper->below = acting.request.get();
    asked_[static_cast<std::size_t>(source.component)] = static_cast<int>(index);
  }
  if (!goals.empty()) connect_goals(index, goals);
}

void Compiler::connect_goals(std::size_t index, const std::vector<int>& goals) {
  std::vector<GlobalGoal*> members;
  for (const int goal : goals) {
    auto& role = *part(goal).as<layout::GoalRole>();
    role.goal->rank(model_.components[static_cast<std::size_t>(goal)].common.filled<GoalCommon>().priority_class);
    role.asks.emplace_back(static_cast<int>(index), members.size());
    members.push_back(role.goal);
  }
  auto& acting = *controller_.parts_[index].as<layout::ActingRole>();
  controller_.asked_by_goals_.push_back(static_cast<int>(index));
  acting.arbiter.emplace(std::move(members), model_.components[index].common.filled<ActingCommon>().preemption);
}

/// A module whose command a coordinator makes a request of another module hears what becomes of it, and pays what that
/// module pays.
void Compiler::connect_answers() {
  for (std::size_t i = 0; i < controller_.parts_.size(); ++i) {
    auto* acting = controller_.parts_[i].as<layout::ActingRole>();
    if (acting == nullptr) continue;
    if (acting->below != nullptr) acting->module->set_below(acting->below);
    if (taker_[i] < 0) continue;
    auto last = static_cast<std::size_t>(taker_[i]);
    while (taker_[last] >= 0) last = static_cast<std::size_t>(taker_[last]);  // no circle: the order was found
    if (asked_[last] < 0) continue;
    acting->charged_by = asked_[last];
    acting->module->set_answer(part(acting->charged_by).as<layout::ActingRole>()->request.get());
  }
}

}  // namespace ganglion
