#include "ganglion/experience/handover.h"

#include <algorithm>

namespace ganglion {

bool anything_new(std::span<const LearningComponent> learners, const HandedParts& handed) {
  if (handed.size() != learners.size()) return !learners.empty();
  for (std::size_t i = 0; i < learners.size(); ++i) {
    const auto parts = learners[i].learner->parts();
    if (parts.size() != handed[i].size()) return true;
    for (const PartState& part : parts) {
      const auto found = handed[i].find(part.name);
      if (found == handed[i].end() || found->second != part.generation) return true;
    }
  }
  return false;
}

void Handover::take(std::span<const LearningComponent> learners, HandedParts& handed) {
  handed.resize(learners.size());
  components_.clear();
  for (std::size_t i = 0; i < learners.size(); ++i) {
    const Learner& learner = *learners[i].learner;
    Component& component = components_.add();
    component.component = learners[i].component;
    component.kind = learners[i].kind;
    component.version = learner.experience_version();
    component.encode = learners[i].encode;
    component.rests_on = learners[i].rests_on;
    component.present.clear();
    component.changed.clear();
    const auto parts = learner.parts();
    for (std::size_t n = 0; n < parts.size(); ++n) {
      component.present.add() = parts[n].name;
      const auto found = handed[i].find(parts[n].name);
      if (found != handed[i].end() && found->second == parts[n].generation) continue;
      Part& copy = component.changed.add();
      copy.name = parts[n].name;
      learner.copy(n, copy.raw);
      handed[i].insert_or_assign(copy.name, parts[n].generation);
    }
    if (handed[i].size() == parts.size()) continue;
    std::erase_if(handed[i], [parts](const auto& one) {
      return std::find_if(parts.begin(), parts.end(), [&](const PartState& part) { return part.name == one.first; }) ==
             parts.end();
    });
  }
}

std::vector<ComponentUpdate> Handover::encoded() const {
  std::vector<ComponentUpdate> updates;
  for (const Component& component : components_.items()) {
    ComponentUpdate& update = updates.emplace_back(
        ComponentUpdate{component.component, component.kind, component.version, component.rests_on, {}, {}});
    update.present.assign(component.present.items().begin(), component.present.items().end());
    for (const Part& part : component.changed.items()) {
      ExperiencePart& stored = update.changed.emplace_back(ExperiencePart{part.name, {}});
      encode_part(component.encode, part.name, part.raw, stored.bytes);
    }
  }
  return updates;
}

}  // namespace ganglion
