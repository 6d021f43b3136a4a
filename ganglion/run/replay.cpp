#include "ganglion/run/replay.h"

#include <unistd.h>

#include <algorithm>
#include <limits>

#include "ganglion/base/hash.h"
#include "ganglion/record/run_file.h"
#include "ganglion/run/prepared.h"
#include "ganglion/run/recording.h"
#include "ganglion/run/run.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

/// A folder of its own that goes away with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "ganglion-replay-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  const fs::path& path() const noexcept { return path_; }

 private:
  fs::path path_;
};

/// Interrupted, cut, or its link was lost: it did not come to an end of its own.
bool ended_early(const RunFile& run) {
  if (!run.outcome) return true;
  const std::string& reason = run.outcome->reason.en;
  return reason.starts_with(kInterrupted.in(Language::English)) || reason.starts_with(kLinkLost.in(Language::English));
}

/// Notes the first row and column in which two recordings of one robot differ.
void compare(const SignalTable& recorded, const SignalTable& repeated, ReplayResult& result) {
  const std::size_t rows = std::min(recorded.rows(), repeated.rows());
  for (std::size_t row = 0; row < rows; ++row) {
    if (result.first_tick && recorded.ticks[row] >= *result.first_tick) return;
    for (std::size_t column = 0; column < recorded.columns.size(); ++column) {
      const auto other = repeated.column(recorded.columns[column].name);
      if (other && canonical_bits(recorded.at(row, column)) == canonical_bits(repeated.at(row, *other))) continue;
      result.first_tick = recorded.ticks[row];
      result.signal = recorded.columns[column].name;
      result.recorded_value = recorded.at(row, column);
      result.value = other ? repeated.at(row, *other) : std::numeric_limits<double>::quiet_NaN();
      return;
    }
  }
  if (recorded.rows() > rows && !result.first_tick) result.first_tick = recorded.ticks[rows];
}

Result<void> compare_files(const RunFile& recorded, const fs::path& repeated_file, ReplayResult& result) {
  const auto repeated = RunFile::read(repeated_file);
  if (!repeated) return tl::unexpected<Error>(repeated.error());
  for (const SignalTable& table : recorded.tables) {
    if (const SignalTable* other = repeated->table(table.topic)) compare(table, *other, result);
  }
  return {};
}

}  // namespace

Result<ReplayResult> replay_run(const fs::path& run_file) {
  const auto recorded = RunFile::read(run_file);
  if (!recorded) return tl::unexpected<Error>(recorded.error());
  const TemporaryFolder folder;
  auto inputs = unpack_inputs(*recorded, folder.path());
  if (!inputs) return tl::unexpected<Error>(inputs.error());
  Problems problems;
  const auto prepared = prepare(inputs->files.experiment, inputs->overrides, problems, inputs->files);
  if (!prepared) return tl::unexpected<Error>(problems.sorted().front());
  RunOptions options;
  options.in_process = true;
  options.seed = recorded->info.seed;
  options.episode = recorded->info.episode;
  options.experience = std::move(inputs->experience);
  auto interventions = interventions_of(*recorded);
  if (!interventions) return tl::unexpected<Error>(interventions.error());
  options.interventions = std::move(*interventions);
  options.run_file = folder.path() / "repeated.mcap";
  if (ended_early(*recorded) && !recorded->tables.empty()) {  // only as far as it goes
    const std::size_t rows = recorded->tables.front().rows();
    options.progress = [rows, done = std::size_t{0}](double) mutable { return ++done < rows; };
  }
  const auto repeated = run(*prepared, options);
  if (!repeated) return tl::unexpected<Error>(repeated.error());
  ReplayResult result;
  result.digest = repeated->digest;
  if (auto compared = compare_files(*recorded, options.run_file, result); !compared) {
    return tl::unexpected<Error>(compared.error());
  }
  result.recorded_digest = recorded->outcome ? recorded->outcome->digest : "";
  const bool digests_equal = !recorded->outcome || result.recorded_digest == result.digest;
  result.same = digests_equal && !result.first_tick;
  return result;
}

}  // namespace ganglion
