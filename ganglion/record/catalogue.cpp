#include "ganglion/record/catalogue.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <set>
#include <system_error>

#include "ganglion/base/text.h"
#include "ganglion/record/csv.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> kSteps = {
    "CREATE TABLE run(file TEXT PRIMARY KEY, name TEXT NOT NULL, seed INTEGER NOT NULL, episode INTEGER NOT NULL, "
    "controller_hash TEXT NOT NULL, finished INTEGER NOT NULL, digest TEXT NOT NULL, success INTEGER NOT NULL, "
    "reason TEXT NOT NULL, recorded_s INTEGER NOT NULL);"
    "CREATE TABLE measure(file TEXT NOT NULL, position INTEGER NOT NULL, name TEXT NOT NULL, value REAL, "
    "PRIMARY KEY (file, position));"
    "CREATE INDEX measure_by_name ON measure(name)",
    "ALTER TABLE run ADD COLUMN reason_es TEXT NOT NULL DEFAULT ''"};
constexpr DatabaseLayout kLayout{.what = {"a catalogue of runs", "un catálogo de ejecuciones"},
                                 .application_id = 0x47414e52,  // "GANR"
                                 .steps = kSteps,
                                 .survives_power_cut = false};

/// What one may sort by, and its column.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kOrders = {{{"recorded", "recorded_s"},
                                                                                   {"file", "file"},
                                                                                   {"name", "name"},
                                                                                   {"seed", "seed"},
                                                                                   {"episode", "episode"},
                                                                                   {"success", "success"},
                                                                                   {"digest", "digest"}}};

std::string_view order_column(std::string_view sort_by) noexcept {
  const auto found =
      std::find_if(kOrders.begin(), kOrders.end(), [&](const auto& order) { return order.first == sort_by; });
  return found != kOrders.end() ? found->second : std::string_view();
}

/// The column `success`: 1, 0, and -1 where nobody judged.
constexpr std::int64_t kNotJudged = -1;
std::int64_t number_of(Verdict verdict) noexcept {
  return verdict == Verdict::NotJudged ? kNotJudged : std::int64_t{verdict == Verdict::Succeeded};
}
Verdict verdict_of(std::int64_t success) noexcept {
  return success == kNotJudged ? Verdict::NotJudged : success != 0 ? Verdict::Succeeded : Verdict::Failed;
}

std::int64_t written_s(const fs::path& path) {
  std::error_code error;
  const auto time = fs::last_write_time(path, error);
  if (error) return 0;
  const auto system = std::chrono::file_clock::to_sys(time);
  return std::chrono::floor<std::chrono::seconds>(system).time_since_epoch().count();
}

/// Every .mcap file below the folder, by name; a link to a folder is not followed, so that none leads in a circle.
std::vector<fs::path> run_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (entry->path().extension() == ".mcap" && entry->is_regular_file(ignored)) files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// A catalogue that is damaged gets out of the way, unless it is write-protected; only the newest such is kept.
bool set_aside(const fs::path& file) {
  std::error_code error, ignored;
  constexpr auto kWritable = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if ((fs::status(file, error).permissions() & kWritable) == fs::perms::none || error) return false;
  fs::path damaged = file;
  fs::rename(file, damaged.replace_extension(".damaged.sqlite"), error);
  for (const char* more : {"-wal", "-shm"}) fs::remove(file.string() + more, ignored);  // of no use to a new one
  return !error;
}

std::string select_sql(const RunFilter& filter) {
  // Parameters 1-4 are the filters, 5 the measure to sort by, 6 the limit.
  const std::string_view column = order_column(filter.sort_by);
  const std::string key = column.empty()
                              ? "(SELECT value FROM measure WHERE measure.file = run.file AND measure.name = ?5)"
                              : std::string(column);
  return fmt::format(
      "SELECT file, name, seed, episode, controller_hash, finished, digest, success, reason, recorded_s, reason_es "
      "FROM run "
      "WHERE (?1 IS NULL OR name = ?1) AND (?2 IS NULL OR seed = ?2) AND (?3 IS NULL OR controller_hash = ?3) "
      "AND (?4 IS NULL OR success = ?4) ORDER BY {} {} NULLS LAST, file LIMIT ?6",
      key, filter.descending ? "DESC" : "ASC");
}

RunSummary run_in_row(const Statement& row) {
  RunSummary run;
  run.file = row.text(0);
  run.name = row.text(1);
  run.seed = std::bit_cast<std::uint64_t>(row.integer(2));
  run.episode = static_cast<std::uint32_t>(row.integer(3));
  run.controller_hash = row.text(4);
  run.finished = row.integer(5) != 0;
  run.digest = row.text(6);
  run.verdict = verdict_of(row.integer(7));
  run.reason = {row.text(8), row.text(10)};
  run.recorded_s = row.integer(9);
  return run;
}

}  // namespace

RunSummary summary_of(const RunFile& run, std::string file, std::int64_t recorded_s) {
  RunSummary summary;
  summary.file = std::move(file);
  summary.name = run.info.name;
  summary.seed = run.info.seed;
  summary.episode = run.info.episode;
  summary.controller_hash = run.info.controller_hash;
  summary.recorded_s = recorded_s;
  if (!run.outcome) return summary;
  summary.finished = true;
  summary.digest = run.outcome->digest;
  summary.verdict = run.outcome->verdict;
  summary.reason = run.outcome->reason;
  summary.measures = run.outcome->measures;
  return summary;
}

Result<RunCatalogue> RunCatalogue::open(const fs::path& folder) {
  const fs::path file = folder / "catalogue.sqlite";
  auto database = Database::open(file, kLayout);
  if (database) return RunCatalogue(folder, std::move(*database));
  if (database.error().code != ErrorCode::Corrupt || !set_aside(file)) return tl::unexpected(database.error());
  database = Database::open(file, kLayout);
  if (!database) return tl::unexpected(database.error());
  RunCatalogue anew(folder, std::move(*database));
  if (const auto rebuilt = anew.rebuild(); !rebuilt) return tl::unexpected(rebuilt.error());
  return anew;
}

Result<void> RunCatalogue::add(const RunSummary& run) {
  return database_.transaction([&] { return insert(run); });
}

Result<void> RunCatalogue::insert(const RunSummary& run) {
  auto insert = database_.prepare("INSERT OR REPLACE INTO run VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  if (!insert) return tl::unexpected(insert.error());
  insert->bind(1, std::string_view(run.file));
  insert->bind(2, std::string_view(run.name));
  insert->bind(3, std::bit_cast<std::int64_t>(run.seed));
  insert->bind(4, std::int64_t{run.episode});
  insert->bind(5, std::string_view(run.controller_hash));
  insert->bind(6, std::int64_t{run.finished});
  insert->bind(7, std::string_view(run.digest));
  insert->bind(8, number_of(run.verdict));
  insert->bind(9, std::string_view(run.reason.en));
  insert->bind(10, run.recorded_s);
  insert->bind(11, std::string_view(run.reason.es));
  if (auto done = insert->run(); !done) return done;
  return insert_measures(run);
}

Result<void> RunCatalogue::insert_measures(const RunSummary& run) {
  auto drop = database_.prepare("DELETE FROM measure WHERE file = ?");
  auto insert = database_.prepare("INSERT INTO measure VALUES (?, ?, ?, ?)");
  if (!drop) return tl::unexpected(drop.error());
  if (!insert) return tl::unexpected(insert.error());
  drop->bind(1, std::string_view(run.file));
  if (auto done = drop->run(); !done) return done;
  for (std::size_t i = 0; i < run.measures.size(); ++i) {
    insert->bind(1, std::string_view(run.file));
    insert->bind(2, static_cast<std::int64_t>(i));
    insert->bind(3, std::string_view(run.measures[i].first));
    insert->bind(4, run.measures[i].second);
    if (auto done = insert->run(); !done) return done;
  }
  return {};
}

Result<std::vector<std::pair<std::string, double>>> RunCatalogue::measures_of(const std::string& file) const {
  auto select = database_.prepare("SELECT name, value FROM measure WHERE file = ? ORDER BY position");
  if (!select) return tl::unexpected(select.error());
  select->bind(1, std::string_view(file));
  std::vector<std::pair<std::string, double>> measures;
  while (true) {
    const auto row = select->step();
    if (!row) return tl::unexpected(row.error());
    if (!*row) return measures;
    measures.emplace_back(select->text(0), select->number(1));
  }
}

Result<std::vector<std::string>> RunCatalogue::measure_names() const {
  auto select = database_.prepare("SELECT DISTINCT name FROM measure ORDER BY name");
  if (!select) return tl::unexpected(select.error());
  std::vector<std::string> names;
  while (true) {
    const auto row = select->step();
    if (!row) return tl::unexpected(row.error());
    if (!*row) return names;
    names.push_back(select->text(0));
  }
}

Result<std::vector<RunSummary>> RunCatalogue::list(const RunFilter& filter) const {
  if (order_column(filter.sort_by).empty()) {
    auto names = measure_names();
    if (!names) return tl::unexpected(names.error());
    if (std::find(names->begin(), names->end(), filter.sort_by) == names->end()) {
      for (const auto& [name, column] : kOrders) names->emplace_back(name);
      return tl::unexpected<Error>(
          Error{ErrorCode::UnknownKey,
                say({"runs cannot be sorted by \"{}\"{}", "las ejecuciones no se pueden ordenar por \"{}\"{}"},
                    filter.sort_by, suggestion(filter.sort_by, *names)),
                {database_.file()},
                {.found = filter.sort_by, .choices = *names}});
    }
  }
  auto select = database_.prepare(select_sql(filter));
  if (!select) return tl::unexpected(select.error());
  if (filter.name) select->bind(1, std::string_view(*filter.name));
  if (filter.seed) select->bind(2, std::bit_cast<std::int64_t>(*filter.seed));
  if (filter.controller_hash) select->bind(3, std::string_view(*filter.controller_hash));
  if (filter.success) select->bind(4, std::int64_t{*filter.success});
  select->bind(5, std::string_view(filter.sort_by));
  select->bind(6, static_cast<std::int64_t>(filter.limit));
  std::vector<RunSummary> runs;
  while (true) {
    const auto row = select->step();
    if (!row) return tl::unexpected(row.error());
    if (!*row) return runs;
    RunSummary& run = runs.emplace_back(run_in_row(*select));
    auto measures = measures_of(run.file);
    if (!measures) return tl::unexpected(measures.error());
    run.measures = std::move(*measures);
  }
}

Result<RebuildReport> RunCatalogue::rebuild() {
  RebuildReport report;
  const auto outcome = database_.transaction([&]() -> Result<void> {
    if (auto done = database_.execute("DELETE FROM run; DELETE FROM measure"); !done) return done;
    for (const fs::path& path : run_files(folder_)) {
      const auto run = RunFile::read_summary(path, Recover::Yes);
      if (!run) {
        report.problems.push_back(run.error());
        continue;
      }
      const std::string file = path.lexically_relative(folder_).generic_string();
      if (auto done = insert(summary_of(*run, file, written_s(path))); !done) return done;
      ++report.runs;
    }
    return {};
  });
  if (!outcome) return tl::unexpected(outcome.error());
  return report;
}

std::string to_csv(std::span<const RunSummary> runs) {
  std::set<std::string> measures;
  for (const RunSummary& run : runs) {
    for (const auto& [name, value] : run.measures) measures.insert(name);
  }
  std::string text = "file,name,seed,episode,controller_hash,finished,digest,success,reason,recorded_s";
  for (const std::string& name : measures) text += "," + csv_cell(name);
  text += '\n';
  for (const RunSummary& run : runs) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}", csv_cell(run.file), csv_cell(run.name), run.seed, run.episode,
                        csv_cell(run.controller_hash), run.finished, csv_cell(run.digest), success_word(run.verdict),
                        csv_cell(run.reason.en), run.recorded_s);
    for (const std::string& name : measures) {
      const auto found =
          std::find_if(run.measures.begin(), run.measures.end(), [&](const auto& m) { return m.first == name; });
      text += found != run.measures.end() ? "," + shortest(found->second) : std::string(",");
    }
    text += '\n';
  }
  return text;
}

}  // namespace ganglion
