#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/record/database/database.h"
#include "ganglion/record/run_file.h"

namespace ganglion {

/// A run's line in the catalogue.
struct RunSummary {
  std::string file;  ///< Relative to the catalogue's folder, with '/': the key.
  std::string name;
  std::uint64_t seed = 0;
  std::uint32_t episode = 0;
  std::string controller_hash;
  bool finished = false;  ///< False for a run that was cut; the next three are then empty.
  std::string digest;
  Verdict verdict = Verdict::NotJudged;
  Sentence reason;  ///< No Spanish where the file has English only.
  std::vector<std::pair<std::string, double>> measures;
  std::int64_t recorded_s = 0;  ///< When, seconds since 1970.
};

RunSummary summary_of(const RunFile& run, std::string file, std::int64_t recorded_s);

/// Which runs to list, and in what order. What is not set is not asked for.
struct RunFilter {
  std::optional<std::string> name;
  std::optional<std::uint64_t> seed;
  std::optional<std::string> controller_hash;
  std::optional<bool> success;  ///< Of those that were judged.
  /// recorded, file, name, seed, episode, success, digest, or the name of a measure.
  std::string sort_by = "recorded";
  bool descending = true;  ///< Runs without the measure come last either way.
  std::size_t limit = 1000;
};

/// What rebuild() found.
struct RebuildReport {
  std::size_t runs = 0;
  std::vector<Error> problems;  ///< Files left out, and why.
};

/// The runs of a folder in one SQLite file, for listing and comparing. Rebuildable: the MCAP files are the truth, this
/// is an index. Several processes may add at once.
class RunCatalogue {
 public:
  /// `folder`/catalogue.sqlite, made if missing. One that is damaged is set aside, "catalogue.damaged.sqlite", and built
  /// anew from the run files. Fails as Database::open() does otherwise.
  static Result<RunCatalogue> open(const std::filesystem::path& folder);

  /// Adds a run, or replaces the one of the same file.
  Result<void> add(const RunSummary& run);
  /// Fails with UnknownKey where `sort_by` is neither a column nor a measure of any run, naming the nearest.
  Result<std::vector<RunSummary>> list(const RunFilter& filter = {}) const;
  /// Forgets everything and reads every .mcap file of the folder and those below it. The time of a run is then its
  /// file's.
  Result<RebuildReport> rebuild();

 private:
  RunCatalogue(std::filesystem::path folder, Database database)
      : folder_(std::move(folder)), database_(std::move(database)) {}
  Result<void> insert(const RunSummary& run);
  Result<void> insert_measures(const RunSummary& run);
  Result<std::vector<std::pair<std::string, double>>> measures_of(const std::string& file) const;
  Result<std::vector<std::string>> measure_names() const;

  std::filesystem::path folder_;
  Database database_;
};

/// A line of names and one for each run, its reason in English; after the fixed columns every measure that any of them
/// has, in alphabetical order, empty where a run has it not.
std::string to_csv(std::span<const RunSummary> runs);

}  // namespace ganglion
