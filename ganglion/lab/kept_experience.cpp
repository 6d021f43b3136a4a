#include "ganglion/lab/kept_experience.h"

#include "ganglion/run/recording.h"

namespace ganglion::lab {
namespace {

/// Files of an older program do not say on what it rests: it counts as learned with what the controller has now.
void note_unknown_ground(const std::filesystem::path& file, const ModuleExperience& learned,
                         const ControllerModel& controller, std::vector<Sentence>& notes) {
  const int index = controller.find(learned.component);
  if (index < 0 || !learned.rests_on.empty()) return;
  const ComponentModel& component = controller.components[static_cast<std::size_t>(index)];
  if (component.descriptor == nullptr || component.descriptor->name != learned.kind) return;
  for (const std::string_view name : component.descriptor->rests_on) {
    notes.push_back(say({"{}: note: an older program wrote it; \"{}\" is taken as learned with {} = {}",
                         "{}: nota: lo escribió un programa más antiguo; se supone que \"{}\" se aprendió con {} = {}"},
                        file.string(), learned.component, name, component.parameters.text(name)));
  }
}

Result<KeptExperience> remembered(const ExperienceStore& store, const ControllerModel& controller) {
  const auto parts = store.load_all();
  if (!parts) return tl::unexpected<Error>(parts.error());
  const auto grounds = store.load_rests_on();
  if (!grounds) return tl::unexpected<Error>(grounds.error());
  KeptExperience known{from_parts(*parts), nullptr, {}};
  for (ModuleExperience& one : known.remembered) {
    if (const auto found = grounds->find(one.component); found != grounds->end()) one.rests_on = found->second;
    note_unknown_ground(store.file(), one, controller, known.notes);
  }
  return known;
}

}  // namespace

Result<KeptExperience> read_experience(const std::filesystem::path& file, const ControllerModel& controller) {
  if (file.empty() || !std::filesystem::exists(file)) return KeptExperience{};
  const auto store = ExperienceStore::open(file);
  if (!store) return tl::unexpected<Error>(store.error());
  return remembered(*store, controller);
}

Result<KeptExperience> keep_experience(const std::filesystem::path& file, const ControllerModel& controller,
                                       const std::string& run) {
  if (file.empty()) return KeptExperience{};
  auto store = ExperienceStore::open(file);
  if (!store) return tl::unexpected<Error>(store.error());
  if (auto leased = store->lease(run); !leased) return tl::unexpected<Error>(leased.error());
  auto known = remembered(*store, controller);
  if (known) known->keeper = std::make_unique<ExperienceWriter>(std::move(*store));
  return known;
}

}  // namespace ganglion::lab
