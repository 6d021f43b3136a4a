#include "ganglion/base/files.h"

#include "ganglion/base/file.h"
#include "ganglion/base/hash.h"

namespace ganglion {
namespace fs = std::filesystem;

std::uint64_t OpenedFile::hash() const noexcept { return hash_name(*text); }

int FileReader::find(std::string_view role, std::string_view named, int by) const noexcept {
  for (std::size_t i = 0; i < opened_.size(); ++i) {
    const OpenedFile& file = opened_[i];
    if (file.by == by && file.named == named && file.role == role) return static_cast<int>(i);
  }
  return -1;
}

int FileReader::index_of(std::string_view place) const {
  for (std::size_t i = 0; i < opened_.size(); ++i) {
    if (!place.empty() && opened_[i].resolved == fs::path(place)) return static_cast<int>(i);
  }
  return -1;
}

fs::path FileReader::resolve(std::string_view, std::string_view named, int by) const {
  if (by < 0) return named;
  return at(by).resolved.parent_path() / named;  // an absolute name stays what it is
}

const std::string* FileReader::recorded_builtin(std::string_view, std::string_view) const { return nullptr; }

Result<int> FileReader::open(std::string_view role, std::string_view named, int by, std::size_t most_bytes) {
  if (const int known = find(role, named, by); known >= 0) return known;
  if (named.find('\0') != std::string_view::npos)  // the system would take the name to end there
    return fail(ErrorCode::NotFound, {"there is no such file", "no existe el archivo"});
  OpenedFile file{std::string(role), std::string(named), resolve(role, named, by), nullptr, by};
  if (const int same = index_of(file.resolved.string()); same >= 0) {
    file.text = at(same).text;
    if (file.text->size() > most_bytes) return too_large(file.resolved, file.text->size(), most_bytes);
  } else {
    auto text = read(file.resolved, most_bytes);
    if (!text) return tl::unexpected<Error>(text.error());
    file.text = std::make_shared<const std::string>(std::move(*text));
  }
  opened_.push_back(std::move(file));
  return static_cast<int>(opened_.size()) - 1;
}

int FileReader::hold(std::string_view role, const fs::path& place, std::string text) {
  opened_.push_back({std::string(role), place.string(), place, std::make_shared<const std::string>(std::move(text))});
  return static_cast<int>(opened_.size()) - 1;
}

int FileReader::builtin(std::string_view role, std::string_view named, std::string_view text, int by) {
  if (const int known = find(role, named, by); known >= 0) return known;
  const std::string* recorded = recorded_builtin(role, named);
  auto taken = std::make_shared<const std::string>(recorded != nullptr ? *recorded : std::string(text));
  opened_.push_back({std::string(role), std::string(named), {}, std::move(taken), by});
  return static_cast<int>(opened_.size()) - 1;
}

Result<std::string> DiskFiles::read(const fs::path& resolved, std::size_t most_bytes) {
  return read_file(resolved, most_bytes);
}

}  // namespace ganglion
