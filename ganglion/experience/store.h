#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/experience/lease.h"
#include "ganglion/experience/stored_part.h"
#include "ganglion/module/experience.h"
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

/// What one component has learned since it was last committed, all of one moment.
struct ComponentUpdate {
  std::string component;
  std::string kind;
  std::uint32_t version = 0;
  std::vector<RestsOn> rests_on;
  std::vector<std::string> present;  ///< Names of all its parts: what is stored under others is gone.
  std::vector<ExperiencePart> changed;
};

struct CommitOutcome {
  bool stale = false;       ///< The store is not as it was found: nothing was written.
  std::size_t changes = 0;  ///< Parts written or dropped, components whose ground was written down.
};

/// What a controller has learned, in one SQLite file in WAL mode. A commit is whole or not at all: kill -9 and power
/// cuts lose nothing committed. Several processes may read; one at a time holds the lease to write.
class ExperienceStore {
 public:
  /// Fails as Database::open() does: clear words for a newer program's file, a damaged one, one of something else.
  /// Of a store that holds more than max_bytes nothing is loaded. An older program's is brought up to date.
  static Result<ExperienceStore> open(const std::filesystem::path& path, std::uint64_t max_bytes = kMaxExperienceBytes);
  ExperienceStore(ExperienceStore&&) noexcept = default;
  ExperienceStore& operator=(ExperienceStore&& other) noexcept;
  /// Gives the lease back.
  ~ExperienceStore();

  /// Takes the right to write, of a process that died as well. Fails with Unwritable, naming who has it and since when.
  Result<void> lease(std::string owner);

  /// Every part, in the order of component and name. Fails with Corrupt where a part does not match its checksum,
  /// TooLarge.
  Result<std::vector<StoredPart>> load_all() const;
  /// By component; none of what an older program stored.
  Result<std::map<std::string, std::vector<RestsOn>>> load_rests_on() const;
  /// All updates in one transaction: parts whose bytes, kind or version differ are written, those that are gone are
  /// dropped, and all that another kind had learned under a component's name. Stale where anybody has committed since
  /// the store was opened or leased, holds the lease instead, or the file is another one by now.
  Result<CommitOutcome> commit(std::span<const ComponentUpdate> updates);
  /// Drops a component, or gives it another name; gives the number of its parts. Fails with NotFound, naming the nearest
  /// that is stored; with BadParameter where `to` is stored already; as lease() does where a run is under way.
  Result<std::size_t> forget(std::string_view component);
  Result<std::size_t> rename(std::string_view from, std::string_view to);
  Result<std::vector<StoredComponent>> list() const;
  /// snapshot_hash() of all that is stored.
  Result<std::uint64_t> snapshot_hash() const;

  /// A new store beside this one, leased like it: "map.beside.sqlite", "map.beside-2.sqlite"...
  Result<ExperienceStore> open_beside() const;
  const std::string& file() const noexcept { return database_.file(); }

  /// Where the time of saving comes from [s since 1970]; the system's clock unless set.
  void set_clock(std::function<std::int64_t()> now_s) { now_s_ = std::move(now_s); }

 private:
  /// What the file says of itself.
  struct State {
    std::int64_t generation = 0;  ///< Counts commits.
    Lease lease;
  };
  /// Which file it is, whatever its name.
  struct FileMark {
    std::uint64_t device = 0, number = 0;
    friend bool operator==(const FileMark&, const FileMark&) = default;
  };

  ExperienceStore(Database database, std::uint64_t max_bytes);
  static FileMark mark_of(const std::string& file);
  Result<State> state() const;
  Result<void> set_state(const State& state) const;
  Result<void> refuse_leased(const State& state) const;
  Result<void> check_size() const;
  Result<bool> is_stale() const;
  Result<bool> is_stored(Statement& find, const ComponentUpdate& owner, const ExperiencePart& part) const;
  Result<std::size_t> apply(const ComponentUpdate& update) const;
  Result<std::size_t> write_changed(const ComponentUpdate& update) const;
  Result<std::size_t> drop_gone(const ComponentUpdate& update) const;
  Result<std::size_t> write_rests_on(const ComponentUpdate& update) const;
  Result<std::size_t> change_component(std::string_view component, const std::function<Result<std::size_t>()>& change);

  Database database_;
  std::uint64_t max_bytes_;
  std::function<std::int64_t()> now_s_;
  FileMark mark_;
  std::int64_t generation_ = 0;         ///< Upon which this one commits.
  std::unique_ptr<const Lease> lease_;  ///< Null: none was taken.
};

}  // namespace ganglion
