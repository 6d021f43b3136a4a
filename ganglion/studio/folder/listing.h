#pragma once

#include <map>
#include <nlohmann/json.hpp>

#include "ganglion/record/catalogue.h"
#include "ganglion/studio/folder/folder.h"

namespace ganglion::studio {

using Json = nlohmann::ordered_json;

/// Of a recording that is shown, as it lies there and unpacked: what holds more is told to be too large.
inline constexpr std::size_t kMostRunBytes = std::size_t{512} << 20;

/// What a folder holds for the studio: controllers, experiments, worlds, robots, recorded runs. Remembers what it read
/// of files that have not changed since.
class Listing {
 public:
  explicit Listing(Folder folder) : folder_(std::move(folder)) {}

  /// docs/studio_api.md, /api/files.
  Json json();
  /// Of one run file; null where it is none.
  Json run(const std::filesystem::path& file);

 private:
  struct Known {
    std::filesystem::file_time_type changed;
    std::uintmax_t bytes = 0;
    std::string list;  ///< "controllers"...; "" = of no interest.
    Json entry;
    /// Files that an experiment was read with, and when they were written.
    std::vector<std::pair<std::filesystem::path, std::filesystem::file_time_type>> others;
    bool again = false;  ///< There were problems, of files that may not be there yet: it is read each time.
  };
  const Known& look(const std::filesystem::path& file);
  Json read(const std::filesystem::path& file, const std::string& name, Known& known) const;
  Json experiment_json(const std::filesystem::path& file, const std::string& text, Json entry, Known& known) const;

  Folder folder_;
  std::map<std::filesystem::path, Known> known_;
};

}  // namespace ganglion::studio
