#include "ganglion/experience/store.h"

#include <sys/stat.h>

#include <array>
#include <chrono>
#include <ctime>

#include "ganglion/base/text.h"
#include "ganglion/experience/stored_hash.h"

namespace ganglion {
namespace {

constexpr std::array<std::string_view, 2> kSteps = {
    "CREATE TABLE part(component TEXT NOT NULL, name TEXT NOT NULL, kind TEXT NOT NULL, version INTEGER NOT NULL, "
    "hash INTEGER NOT NULL, bytes BLOB NOT NULL, saved_s INTEGER NOT NULL, PRIMARY KEY (component, name))",
    "CREATE TABLE rests_on(component TEXT NOT NULL, parameter TEXT NOT NULL, value TEXT NOT NULL, "
    "PRIMARY KEY (component, parameter));"
    "CREATE TABLE state(generation INTEGER NOT NULL, owner TEXT NOT NULL, process INTEGER NOT NULL, "
    "started TEXT NOT NULL, since_s INTEGER NOT NULL);"
    "INSERT INTO state VALUES (0, '', 0, '', 0)"};
constexpr DatabaseLayout kLayout{.what = {"the experience of a controller", "la experiencia de un controlador"},
                                 .application_id = 0x47414e45,
                                 .steps = kSteps};  // "GANE"
constexpr std::int64_t kMostCommits = std::int64_t{1} << 60;
constexpr std::int64_t kMostGround = 1 << 20;  // what components rest on, all of it [bytes]

std::int64_t system_s() {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string clock_of(std::int64_t since_s) {
  const std::time_t time = since_s;
  std::tm parts{};
  char text[32] = "?";
  if (::gmtime_r(&time, &parts) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &parts);
  return text;
}

}  // namespace

Result<ExperienceStore> ExperienceStore::open(const std::filesystem::path& path, std::uint64_t max_bytes) {
  auto database = Database::open(path, kLayout);
  if (!database) return tl::unexpected(database.error());
  ExperienceStore store(std::move(*database), max_bytes);
  const auto state = store.state();
  if (!state) return tl::unexpected(state.error());
  store.generation_ = state->generation;
  return store;
}

ExperienceStore::ExperienceStore(Database database, std::uint64_t max_bytes)
    : database_(std::move(database)), max_bytes_(max_bytes), now_s_(system_s), mark_(mark_of(database_.file())) {}

ExperienceStore& ExperienceStore::operator=(ExperienceStore&& other) noexcept {
  std::swap(database_, other.database_);
  std::swap(max_bytes_, other.max_bytes_);
  std::swap(now_s_, other.now_s_);
  std::swap(mark_, other.mark_);
  std::swap(generation_, other.generation_);
  std::swap(lease_, other.lease_);  // given back with the other
  return *this;
}

ExperienceStore::~ExperienceStore() {
  if (lease_ == nullptr) return;
  // Where this fails the lease lapses with the process.
  static_cast<void>(database_.transaction([&]() -> Result<void> {
    const auto now = state();
    if (!now || now->lease != *lease_) return {};
    return set_state({now->generation, {}});
  }));
}

ExperienceStore::FileMark ExperienceStore::mark_of(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return {};
  return {static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino)};
}

Result<ExperienceStore::State> ExperienceStore::state() const {
  auto select = database_.prepare("SELECT generation, owner, process, started, since_s FROM state LIMIT 2");
  if (!select) return tl::unexpected(select.error());
  auto row = select->step();
  if (!row) return tl::unexpected(row.error());
  State state;
  if (*row) {
    state = {select->integer(0), {select->text(1), {select->integer(2), select->text(3)}, select->integer(4)}};
    const auto second = select->step();
    if (!second) return tl::unexpected(second.error());
    if (!*second && state.generation >= 0 && state.generation < kMostCommits) return state;
  }
  return fail_at({database_.file()}, ErrorCode::Corrupt,
                 {"does not say how often it was written to", "no dice cuántas veces se escribió"});
}

Result<void> ExperienceStore::set_state(const State& state) const {
  auto update = database_.prepare("UPDATE state SET generation = ?, owner = ?, process = ?, started = ?, since_s = ?");
  if (!update) return tl::unexpected(update.error());
  update->bind(1, state.generation);
  update->bind(2, std::string_view(state.lease.owner));
  update->bind(3, state.lease.process.number);
  update->bind(4, std::string_view(state.lease.process.started));
  update->bind(5, state.lease.since_s);
  return update->run();
}

Result<void> ExperienceStore::refuse_leased(const State& state) const {
  const bool mine = lease_ != nullptr && state.lease == *lease_;
  if (mine || !is_alive(state.lease.process)) return {};
  return fail_at(
      {database_.file()}, ErrorCode::Unwritable,
      {"is being written to by a run of \"{}\", process {}, since {}; wait for its end, or take another file",
       "lo está escribiendo una ejecución de \"{}\", proceso {}, desde {}; espere a que termine, o use otro "
       "archivo"},
      state.lease.owner, state.lease.process.number, clock_of(state.lease.since_s));
}

Result<void> ExperienceStore::lease(std::string owner) {
  const Lease wanted{std::move(owner), this_process(), now_s_()};
  std::int64_t generation = 0;
  auto taken = database_.transaction([&]() -> Result<void> {
    auto now = state();
    if (!now) return tl::unexpected(now.error());
    if (auto free = refuse_leased(*now); !free) return free;
    generation = now->generation;
    return set_state({now->generation, wanted});
  });
  if (!taken) return taken;
  generation_ = generation;
  lease_ = std::make_unique<const Lease>(wanted);
  return {};
}

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

Result<std::map<std::string, std::vector<RestsOn>>> ExperienceStore::load_rests_on() const {
  auto sum =
      database_.prepare("SELECT coalesce(sum(length(component) + length(parameter) + length(value)), 0) FROM rests_on");
  if (!sum) return tl::unexpected(sum.error());
  if (const auto row = sum->step(); !row) return tl::unexpected(row.error());
  if (sum->integer(0) > kMostGround) {
    return fail_at(
        {database_.file()}, ErrorCode::TooLarge,
        {"says in {} bytes on what it rests; the limit is {}", "dice en {} bytes en qué se apoya; el límite es {}"},
        sum->integer(0), kMostGround);
  }
  auto select = database_.prepare("SELECT component, parameter, value FROM rests_on ORDER BY component, parameter");
  if (!select) return tl::unexpected(select.error());
  std::map<std::string, std::vector<RestsOn>> found;
  while (true) {
    const auto row = select->step();
    if (!row) return tl::unexpected(row.error());
    if (!*row) return found;
    found[select->text(0)].push_back({select->text(1), select->text(2)});
  }
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

Result<ExperienceStore> ExperienceStore::open_beside() const {
  const std::filesystem::path mine = database_.file();
  std::filesystem::path other;
  std::error_code ignored;
  for (int i = 1; i == 1 || std::filesystem::exists(other, ignored); ++i) {
    const std::string ending = i == 1 ? std::string(".beside") : fmt::format(".beside-{}", i);
    other = mine.parent_path() / (mine.stem().string() + ending + mine.extension().string());
  }
  auto opened = open(other, max_bytes_);
  if (!opened) return opened;
  opened->now_s_ = now_s_;
  if (lease_ == nullptr) return opened;
  if (auto leased = opened->lease(lease_->owner); !leased) return tl::unexpected(leased.error());
  return opened;
}

}  // namespace ganglion
