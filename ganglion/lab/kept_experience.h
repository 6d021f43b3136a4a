#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/experience/writer.h"
#include "ganglion/graph/controller.h"

namespace ganglion::lab {

/// What a file remembers, and who adds to it.
struct KeptExperience {
  std::vector<ModuleExperience> remembered;
  std::unique_ptr<ExperienceWriter> keeper;  ///< Null where nothing is added.
  std::vector<Sentence> notes;               ///< What is not known of it, and is taken for granted.
};

/// What a file remembers; nothing where there is none, or it is named "". Fails as ExperienceStore does.
Result<KeptExperience> read_experience(const std::filesystem::path& file, const ControllerModel& controller);
/// The same of a file that a run of that name adds to from now on, and no other.
Result<KeptExperience> keep_experience(const std::filesystem::path& file, const ControllerModel& controller,
                                       const std::string& run);

}  // namespace ganglion::lab
