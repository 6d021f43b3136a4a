#include "ganglion/record/place_run.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <optional>

#include "ganglion/base/new_file.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr int kMostNames = 10'000;
constexpr std::string_view kLinkTable = "/link/signals";

bool same_attachment(const mcap::Attachment& one, const mcap::Attachment& other) {
  return one.name == other.name && one.bytes == other.bytes;
}

/// "seed_0001.mcap", "seed_0001-2.mcap"...
fs::path numbered(const fs::path& wanted, int number) {
  if (number == 1) return wanted;
  fs::path name = wanted;
  return name.replace_filename(fmt::format("{}-{}{}", wanted.stem().string(), number, wanted.extension().string()));
}

/// Whole, and no link to one that lies elsewhere.
std::optional<RunFile> whole_run(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(file, error))) return std::nullopt;
  auto run = RunFile::read_summary(file);
  return run ? std::optional(std::move(*run)) : std::nullopt;
}

}  // namespace

bool same_run(const RunFile& one, const RunFile& other) {
  if (!one.outcome || !other.outcome || one.table(kLinkTable) != nullptr) return false;
  return to_fields(one.info) == to_fields(other.info) && to_fields(*one.outcome) == to_fields(*other.outcome) &&
         std::ranges::equal(one.attachments, other.attachments, same_attachment);
}

Result<fs::path> place_run(const fs::path& recorded, const fs::path& wanted) {
  std::optional<RunFile> mine;
  for (int number = 1; number <= kMostNames; ++number) {
    const fs::path name = numbered(wanted, number);
    const auto named = rename_to_free(recorded, name);
    if (!named) return tl::unexpected<Error>(named.error());
    if (*named) return name;
    if (!mine) mine = whole_run(recorded);
    const auto there = mine ? whole_run(name) : std::nullopt;
    if (!there || !same_run(*mine, *there)) continue;
    ::utimensat(AT_FDCWD, name.c_str(), nullptr, AT_SYMLINK_NOFOLLOW);
    std::error_code ignored;
    fs::remove(recorded, ignored);
    return name;
  }
  return fail_at({wanted.string()}, ErrorCode::Unwritable,
                 {"cannot be written: there are {} runs of that name; move them away, or choose another folder",
                  "no se puede escribir: hay {} ejecuciones con ese nombre; muévalas, o elija otra carpeta"},
                 kMostNames);
}

}  // namespace ganglion
