#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/experience/stored_part.h"
#include "ganglion/record/database/database.h"

namespace ganglion {

/// One component's line in the list of what is stored.
struct StoredComponent {
  std::string component;
  std::string kind;
  std::uint64_t parts = 0;
  std::uint64_t bytes = 0;
  std::int64_t saved_s = 0;  ///< Of the newest part, seconds since 1970.
};

/// What a controller has learned, in one SQLite file in WAL mode. A commit is whole or not at all: kill -9 and power
/// cuts lose nothing committed. Several processes may have the file open; the last to commit a part wins.
class ExperienceStore {
 public:
  /// Fails as Database::open() does: clear words for a newer program's file, a damaged one, one of something else.
  /// Of a store that holds more than max_bytes nothing is loaded.
  static Result<ExperienceStore> open(const std::filesystem::path& path, std::uint64_t max_bytes = kMaxExperienceBytes);

  /// Every part, in the order of component and name. Fails with Corrupt where a part does not match its checksum,
  /// TooLarge.
  Result<std::vector<StoredPart>> load_all() const;
  /// Writes the parts whose bytes, kind or version differ from the stored ones, in one transaction, and gives their
  /// number. Where a component changed its kind, what the former kind had learned is dropped.
  Result<std::size_t> commit(std::span<const StoredPart> parts);
  /// Drops a component; gives the number of parts it had.
  Result<std::size_t> forget(std::string_view component);
  Result<std::vector<StoredComponent>> list() const;
  /// snapshot_hash() of all that is stored.
  Result<std::uint64_t> snapshot_hash() const;

  /// Where the time of saving comes from [s since 1970]; the system's clock unless set.
  void set_clock(std::function<std::int64_t()> now_s) { now_s_ = std::move(now_s); }

 private:
  ExperienceStore(Database database, std::uint64_t max_bytes);
  Result<void> check_size() const;
  Result<bool> is_stored(Statement& find, const StoredPart& part) const;
  Result<void> write(std::span<const StoredPart* const> parts);

  Database database_;
  std::uint64_t max_bytes_;
  std::function<std::int64_t()> now_s_;
};

}  // namespace ganglion
