#include "ganglion/run/near_file.h"

#include <array>
#include <map>
#include <string>
#include <vector>

#include "ganglion/base/text.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNames = 1000;
constexpr std::array<std::string_view, 3> kFolders = {"", "experiments", "examples"};  // "": beside it

/// Paths as a person would write them, by the name of the last part.
std::map<std::string, std::string> names_in(const fs::path& folder) {
  std::map<std::string, std::string> names;
  for (const std::string_view inner : kFolders) {
    std::error_code error;
    fs::directory_iterator walk(folder.empty() ? fs::path(".") / inner : folder / inner, error);
    for (; !error && walk != fs::directory_iterator() && names.size() < kMostNames; walk.increment(error)) {
      const fs::path name = walk->path().filename();
      names.emplace(name.string(), (inner.empty() ? folder / name : folder / inner / name).string());
    }
  }
  return names;
}

}  // namespace

Error with_nearest(Error error, const fs::path& wanted) {
  if (error.code != ErrorCode::NotFound) return error;
  std::error_code ignored;
  fs::path missing = wanted;  // the first part that is not there
  while (missing.has_parent_path() && missing.parent_path() != missing && !fs::exists(missing.parent_path(), ignored)) {
    missing = missing.parent_path();
  }
  if (!missing.has_filename()) return error;
  const std::map<std::string, std::string> names = names_in(missing.parent_path());
  std::vector<std::string> candidates;
  for (const auto& [name, path] : names) candidates.push_back(name);
  const auto found = nearest(missing.filename().string(), candidates);
  if (!found) return error;
  const fs::path there = names.at(*found);
  const fs::path meant = missing == wanted ? there : there / wanted.lexically_relative(missing);
  error.what =
      say({"{}; did you mean \"{}\"?", "{}; ¿quiso decir \"{}\"?"}, error.what, meant.lexically_normal().string());
  return error;
}

}  // namespace ganglion
