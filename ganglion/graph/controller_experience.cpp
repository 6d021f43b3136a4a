// What a controller has learned, and how it is handed back.
#include <algorithm>
#include <unordered_map>

#include "ganglion/graph/controller.h"

namespace ganglion {

namespace {

/// Whether it was learned with the values that these components have now; where it was not written down it counts.
Result<void> check_rests_on(const ModuleExperience& learned, std::span<const RestsOn> present) {
  for (const RestsOn& now : present) {
    const auto then = std::find_if(learned.rests_on.begin(), learned.rests_on.end(),
                                   [&now](const RestsOn& one) { return one.parameter == now.parameter; });
    if (then == learned.rests_on.end() || then->value == now.value) continue;
    auto refused = fail(ErrorCode::BadParameter,
                        {"was learned with {0} = {1}, and {0} is {2} now; set it back, or drop what was learned by "
                         "\"ganglion experience forget\"",
                         "se aprendió con {0} = {1}, y ahora {0} es {2}; vuelva a ponerlo, u olvide lo aprendido con "
                         "\"ganglion experience forget\""},
                        now.parameter, then->value, now.value);
    refused.value().subject = {learned.component, now.parameter, now.value, {then->value}};
    return refused;
  }
  return {};
}

/// Whom it may have belonged to under another name: the first of its kind that nothing is remembered of.
Sentence heir_of(const ModuleExperience& orphan, const std::vector<ModuleExperience>& learned,
                 const std::vector<LearningComponent>& learners) {
  for (const LearningComponent& one : learners) {
    const auto remembered = [&one](const ModuleExperience& other) { return other.component == one.component; };
    if (one.kind != orphan.kind || std::any_of(learned.begin(), learned.end(), remembered)) continue;
    return say({"; \"ganglion experience rename\" can give it to \"{}\"",
                "; \"ganglion experience rename\" puede dársela a \"{}\""},
               one.component);
  }
  return {};
}

}  // namespace

std::vector<LearningComponent> Controller::learners() const {
  std::vector<LearningComponent> result;
  for (const layout::Part& one : parts_) {
    if (one.component == nullptr || one.component->experience_version() == 0) continue;
    result.push_back({one.id, one.kind, one.component.get(), one.encode, one.rests_on});
  }
  return result;
}

std::vector<ModuleExperience> Controller::experience() const {
  std::vector<ModuleExperience> result;
  for (const LearningComponent& one : learners()) {
    result.push_back({one.component, one.kind, one.learner->experience_version(),
                      stored_parts(*one.learner, one.encode), one.rests_on});
  }
  return result;
}

std::uint64_t Controller::concluded() const noexcept {
  std::uint64_t sum = 0;
  for (const layout::Part& one : parts_) {
    const auto* acting = one.as<layout::ActingRole>();
    if (acting != nullptr && acting->request != nullptr) sum += acting->request->concluded;
  }
  return sum;
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
                   {"experience of \"{}\" ({}) belongs to no component of this controller{}",
                    "la experiencia de \"{}\" ({}) no pertenece a ningún componente de este controlador{}"},
                   one.component, one.kind, heir_of(one, learned, this->learners()));
      continue;
    }
    layout::Part& taker = part(found->second);
    auto loaded = check_rests_on(one, taker.rests_on);
    if (loaded) loaded = taker.component->load(one.version, one.parts);
    if (loaded) continue;
    Error error = loaded.error();
    error.what = say({"{}: {}", "{}: {}"}, one.component, error.what);
    problems.add(std::move(error));
  }
  grow();
}

}  // namespace ganglion
