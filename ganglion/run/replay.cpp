#include "ganglion/run/replay.h"

#include <algorithm>
#include <limits>

#include "ganglion/base/hash.h"
#include "ganglion/base/text.h"
#include "ganglion/record/run_file.h"
#include "ganglion/run/inputs.h"
#include "ganglion/run/prepared.h"
#include "ganglion/run/recording.h"
#include "ganglion/run/run.h"

namespace ganglion {
namespace {

namespace fs = std::filesystem;

/// Interrupted, cut, or its link was lost: it did not come to an end of its own.
bool ended_early(const RunFile& run) {
  if (!run.outcome) return true;
  const std::string& reason = run.outcome->reason.en;
  return reason.starts_with(kInterrupted.in(Language::English)) || reason.starts_with(kLinkLost.in(Language::English));
}

/// Holds what a run tells against what was recorded, row by row, and notes the first tick that differs.
class RepeatedRows final : public RunSink {
 public:
  RepeatedRows(const RunFile& recorded, ReplayResult& result) : recorded_(recorded), result_(result) {}

  int add_table(std::string_view topic, std::span<const SignalColumn> columns) override {
    Table table{recorded_.table(topic), {}, 0};
    const auto count = table.recorded != nullptr ? table.recorded->columns.size() : 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto same = std::find_if(columns.begin(), columns.end(), [&](const SignalColumn& column) {
        return column.name == table.recorded->columns[i].name;
      });
      table.now.push_back(static_cast<std::size_t>(same - columns.begin()));
    }
    tables_.push_back(std::move(table));
    return static_cast<int>(tables_.size()) - 1;
  }

  void write_row(int index, std::uint32_t, double, std::span<const double> values) override {
    Table& table = tables_[static_cast<std::size_t>(index)];
    const std::size_t row = table.rows++;
    if (table.recorded == nullptr || row >= table.recorded->rows() || result_.first_tick) return;
    for (std::size_t column = 0; column < table.now.size(); ++column) {
      const double recorded = table.recorded->at(row, column);
      const bool there = table.now[column] < values.size();
      const double now = there ? values[table.now[column]] : std::numeric_limits<double>::quiet_NaN();
      if (there && canonical_bits(recorded) == canonical_bits(now)) continue;
      note(*table.recorded, row);
      result_.signal = table.recorded->columns[column].name;
      result_.recorded_value = recorded;
      result_.value = now;
      return;
    }
  }

  void write_json(std::string_view, std::string_view, double, std::string_view) override {}
  void write_exhibit(std::string_view, double, std::string_view) override {}

  /// Rows that were recorded and did not come again differ too.
  void finish() {
    for (const Table& table : tables_) {
      if (table.recorded != nullptr && table.recorded->rows() > table.rows) note(*table.recorded, table.rows);
    }
  }

 private:
  struct Table {
    const SignalTable* recorded = nullptr;
    std::vector<std::size_t> now;  ///< Where each recorded column stands in a row; past its end = nowhere.
    std::size_t rows = 0;
  };
  void note(const SignalTable& recorded, std::size_t row) {
    if (!result_.first_tick) result_.first_tick = recorded.ticks[row];
  }

  const RunFile& recorded_;
  ReplayResult& result_;
  std::vector<Table> tables_;
};

/// All that was recorded, or the beginning of a file that was cut; the summary behind it may be damaged.
Result<RunFile> recorded_run(const fs::path& run_file) {
  auto whole = RunFile::read(run_file);
  if (whole || whole.error().code != ErrorCode::Corrupt) return whole;
  auto saved = RunFile::read(run_file, Recover::Yes);
  return saved && saved->without_gaps ? std::move(saved) : std::move(whole);
}

/// Of a file that was cut while these were written.
Result<void> check_complete(const RunFile& run, const AttachedFiles& files, const fs::path& run_file) {
  auto lost = files.missing();
  if (run.attachment(kExperienceAttachment) == nullptr) lost.emplace_back(kExperienceAttachment);
  if (lost.empty()) return {};
  return fail_at({run_file.string()}, ErrorCode::Corrupt,
                 {"has lost what went into the run ({}): it cannot be repeated",
                  "perdió lo que entró en la ejecución ({}): no se puede repetir"},
                 join(lost, ", "));
}

}  // namespace

Result<ReplayResult> replay_run(const fs::path& run_file) {
  const auto recorded = recorded_run(run_file);
  if (!recorded) return tl::unexpected<Error>(recorded.error());
  auto files = AttachedFiles::of(*recorded);
  if (!files) return tl::unexpected<Error>(files.error());
  if (auto complete = check_complete(*recorded, **files, run_file); !complete)
    return tl::unexpected<Error>(complete.error());
  auto experience = recorded_experience(*recorded);
  if (!experience) return tl::unexpected<Error>(experience.error());
  Problems problems;
  const auto prepared = prepare(**files, (*files)->experiment(), (*files)->overrides(), problems);
  if (!prepared) return tl::unexpected<Error>(problems.sorted().front());
  RunOptions options;
  options.in_process = true;
  options.seed = recorded->info.seed;
  options.episode = recorded->info.episode;
  options.experience = std::move(*experience);
  auto interventions = interventions_of(*recorded);
  if (!interventions) return tl::unexpected<Error>(interventions.error());
  options.interventions = std::move(*interventions);
  ReplayResult result;
  result.damages = recorded->damages;
  RepeatedRows rows_again(*recorded, result);
  options.watcher = &rows_again;
  if (ended_early(*recorded) && !recorded->tables.empty()) {  // only as far as it goes
    const std::size_t rows = recorded->tables.front().rows();
    options.progress = [rows, done = std::size_t{0}](double) mutable { return ++done < rows; };
  }
  const auto repeated = run(*prepared, options);
  if (!repeated) return tl::unexpected<Error>(repeated.error());
  rows_again.finish();
  result.digest = repeated->digest;
  result.recorded_digest = recorded->outcome ? recorded->outcome->digest : "";
  const bool digests_equal = !recorded->outcome || result.recorded_digest == result.digest;
  result.same = digests_equal && !result.first_tick;
  return result;
}

}  // namespace ganglion
