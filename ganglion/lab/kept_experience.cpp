#include "ganglion/lab/kept_experience.h"

#include "ganglion/run/recording.h"

namespace ganglion::lab {
namespace {

Result<std::vector<ModuleExperience>> remembered(const ExperienceStore& store) {
  const auto parts = store.load_all();
  if (!parts) return tl::unexpected<Error>(parts.error());
  return from_parts(*parts);
}

}  // namespace

void KeptExperience::learn(const std::vector<ModuleExperience>& learned) {
  if (keeper != nullptr) keeper->submit(to_parts(learned));
}

Result<void> KeptExperience::conclude() { return keeper != nullptr ? keeper->flush() : Result<void>(); }

Result<std::vector<ModuleExperience>> read_experience(const std::filesystem::path& file) {
  if (file.empty() || !std::filesystem::exists(file)) return std::vector<ModuleExperience>{};
  const auto store = ExperienceStore::open(file);
  if (!store) return tl::unexpected<Error>(store.error());
  return remembered(*store);
}

Result<KeptExperience> keep_experience(const std::filesystem::path& file) {
  auto store = ExperienceStore::open(file);
  if (!store) return tl::unexpected<Error>(store.error());
  auto known = remembered(*store);
  if (!known) return tl::unexpected<Error>(known.error());
  return KeptExperience{std::move(*known), std::make_unique<ExperienceWriter>(std::move(*store))};
}

}  // namespace ganglion::lab
