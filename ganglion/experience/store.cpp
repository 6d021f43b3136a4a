#include "ganglion/experience/store.h"

#include <array>
#include <bit>
#include <chrono>

#include "ganglion/base/hash.h"

namespace ganglion {
namespace {

constexpr std::array<std::string_view, 1> kSteps = {
    "CREATE TABLE part(component TEXT NOT NULL, name TEXT NOT NULL, kind TEXT NOT NULL, version INTEGER NOT NULL, "
    "hash INTEGER NOT NULL, bytes BLOB NOT NULL, saved_s INTEGER NOT NULL, PRIMARY KEY (component, name))"};
constexpr DatabaseLayout kLayout{.what = {"the experience of a controller", "la experiencia de un controlador"},
                                 .application_id = 0x47414e45,
                                 .steps = kSteps};  // "GANE"

std::int64_t system_s() {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::int64_t stored_hash(std::span<const std::byte> bytes) noexcept {
  return std::bit_cast<std::int64_t>(hash_bytes(bytes));
}

}  // namespace

Result<ExperienceStore> ExperienceStore::open(const std::filesystem::path& path, std::uint64_t max_bytes) {
  auto database = Database::open(path, kLayout);
  if (!database) return tl::unexpected(database.error());
  return ExperienceStore(std::move(*database), max_bytes);
}

ExperienceStore::ExperienceStore(Database database, std::uint64_t max_bytes)
    : database_(std::move(database)), max_bytes_(max_bytes), now_s_(system_s) {}

Result<void> ExperienceStore::check_size() const {
  auto sum = database_.prepare("SELECT coalesce(sum(length(bytes)), 0) FROM part");
  if (!sum) return tl::unexpected(sum.error());
  if (const auto row = sum->step(); !row) return tl::unexpected(row.error());
  const auto total = static_cast<std::uint64_t>(sum->integer(0));
  if (total <= max_bytes_) return {};
  return fail_at({database_.file()}, ErrorCode::TooLarge,
                 {"holds {} bytes; the limit is {}", "contiene {} bytes; el límite es {}"}, total, max_bytes_);
}

Result<std::vector<StoredPart>> ExperienceStore::load_all() const {
  if (auto fits = check_size(); !fits) return tl::unexpected(fits.error());
  auto select =
      database_.prepare("SELECT component, kind, version, name, bytes, hash FROM part ORDER BY component, name");
  if (!select) return tl::unexpected(select.error());
  std::vector<StoredPart> parts;
  while (true) {
    const auto row = select->step();
    if (!row) return tl::unexpected(row.error());
    if (!*row) return parts;
    StoredPart& part = parts.emplace_back();
    part.component = select->text(0);
    part.kind = select->text(1);
    part.version = static_cast<std::uint32_t>(select->integer(2));
    part.name = select->text(3);
    part.bytes = select->bytes(4);
    if (stored_hash(part.bytes) != select->integer(5)) {
      return fail_at(
          {database_.file()}, ErrorCode::Corrupt,
          {"part \"{}\" of \"{}\" does not match its checksum; forgetting \"{}\" lets the rest be used",
           "la parte \"{}\" de \"{}\" no coincide con su suma de control; si se olvida \"{}\", lo demás se puede usar"},
          part.name, part.component, part.component);
    }
  }
}

Result<bool> ExperienceStore::is_stored(Statement& find, const StoredPart& part) const {
  find.bind(1, std::string_view(part.component));
  find.bind(2, std::string_view(part.name));
  const auto row = find.step();
  if (!row) return tl::unexpected(row.error());
  const bool same = *row && find.text(0) == part.kind && find.integer(1) == part.version &&
                    find.integer(2) == stored_hash(part.bytes) &&
                    find.integer(3) == static_cast<std::int64_t>(part.bytes.size());
  find.reset();
  return same;
}

Result<std::size_t> ExperienceStore::commit(std::span<const StoredPart> parts) {
  auto find = database_.prepare("SELECT kind, version, hash, length(bytes) FROM part WHERE component = ? AND name = ?");
  if (!find) return tl::unexpected(find.error());
  std::vector<const StoredPart*> changed;
  for (const StoredPart& part : parts) {
    const auto same = is_stored(*find, part);
    if (!same) return tl::unexpected(same.error());
    if (!*same) changed.push_back(&part);
  }
  if (changed.empty()) return std::size_t{0};
  if (auto written = database_.transaction([&] { return write(changed); }); !written) {
    return tl::unexpected(written.error());
  }
  return changed.size();
}

Result<void> ExperienceStore::write(std::span<const StoredPart* const> parts) {
  auto drop = database_.prepare("DELETE FROM part WHERE component = ? AND kind <> ?");
  auto insert = database_.prepare("INSERT OR REPLACE INTO part VALUES (?, ?, ?, ?, ?, ?, ?)");
  if (!drop) return tl::unexpected(drop.error());
  if (!insert) return tl::unexpected(insert.error());
  const std::int64_t now_s = now_s_();
  for (const StoredPart* part : parts) {
    drop->bind(1, std::string_view(part->component));
    drop->bind(2, std::string_view(part->kind));
    if (auto done = drop->run(); !done) return done;
    insert->bind(1, std::string_view(part->component));
    insert->bind(2, std::string_view(part->name));
    insert->bind(3, std::string_view(part->kind));
    insert->bind(4, std::int64_t{part->version});
    insert->bind(5, stored_hash(part->bytes));
    insert->bind(6, std::span<const std::byte>(part->bytes));
    insert->bind(7, now_s);
    if (auto done = insert->run(); !done) return done;
  }
  return {};
}

Result<std::size_t> ExperienceStore::forget(std::string_view component) {
  auto drop = database_.prepare("DELETE FROM part WHERE component = ?");
  if (!drop) return tl::unexpected(drop.error());
  drop->bind(1, component);
  if (auto done = drop->run(); !done) return tl::unexpected(done.error());
  return static_cast<std::size_t>(database_.changes());
}

Result<std::vector<StoredComponent>> ExperienceStore::list() const {
  auto select = database_.prepare(
      "SELECT component, kind, count(*), sum(length(bytes)), max(saved_s) FROM part GROUP BY component, kind "
      "ORDER BY component, kind");
  if (!select) return tl::unexpected(select.error());
  std::vector<StoredComponent> components;
  while (true) {
    const auto row = select->step();
    if (!row) return tl::unexpected(row.error());
    if (!*row) return components;
    components.push_back({select->text(0), select->text(1), static_cast<std::uint64_t>(select->integer(2)),
                          static_cast<std::uint64_t>(select->integer(3)), select->integer(4)});
  }
}

Result<std::uint64_t> ExperienceStore::snapshot_hash() const {
  const auto parts = load_all();
  if (!parts) return tl::unexpected(parts.error());
  return ganglion::snapshot_hash(*parts);
}

}  // namespace ganglion
