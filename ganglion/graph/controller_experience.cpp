// What a controller has learned, and how it is handed back.
#include <unordered_map>

#include "ganglion/graph/controller.h"

namespace ganglion {

std::vector<ModuleExperience> Controller::experience() const {
  std::vector<ModuleExperience> result;
  for (int i = 0; i < components(); ++i) {
    const Component* one = component(i);
    if (one == nullptr || one->experience_version() == 0) continue;
    ModuleExperience learned{part(i).id, part(i).kind, one->experience_version(), {}};
    one->save(learned.parts);
    result.push_back(std::move(learned));
  }
  return result;
}

void Controller::load(const std::vector<ModuleExperience>& learned, Problems& problems) {
  std::unordered_map<std::string_view, int> learners;  // for look-ups only
  for (int i = 0; i < components(); ++i) {
    if (component(i) != nullptr) learners.emplace(id(i), i);
  }
  for (const ModuleExperience& one : learned) {
    const auto found = learners.find(one.component);
    if (found == learners.end() || part(found->second).kind != one.kind) {
      problems.add({}, ErrorCode::UnknownKey,
                   {"experience of \"{}\" ({}) belongs to no component of this controller",
                    "la experiencia de \"{}\" ({}) no pertenece a ningún componente de este controlador"},
                   one.component, one.kind);
      continue;
    }
    if (auto loaded = part(found->second).component->load(one.version, one.parts); !loaded) {
      problems.add({}, loaded.error().code, {"{}: {}", "{}: {}"}, one.component, loaded.error().what);
    }
  }
  grow();
}

}  // namespace ganglion
