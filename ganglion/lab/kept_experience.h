#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/experience/writer.h"
#include "ganglion/graph/controller.h"

namespace ganglion::lab {

/// What a file remembers, and who adds to it.
struct KeptExperience {
  std::vector<ModuleExperience> remembered;
  std::unique_ptr<ExperienceWriter> keeper;  ///< Null: nobody adds.

  void learn(const std::vector<ModuleExperience>& learned);
  /// Waits until all is written. Fails with the reason where it could not be.
  Result<void> conclude();
};

/// What a file remembers; nothing where there is none, or it is named "". Fails as ExperienceStore does.
Result<std::vector<ModuleExperience>> read_experience(const std::filesystem::path& file);
/// The same of a file that a run adds to from now on.
Result<KeptExperience> keep_experience(const std::filesystem::path& file);

}  // namespace ganglion::lab
