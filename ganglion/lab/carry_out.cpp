#include "ganglion/lab/carry_out.h"

#include <ctime>

#include "ganglion/lab/kept_experience.h"
#include "ganglion/plot/from_run_file.h"
#include "ganglion/record/catalogue.h"
#include "ganglion/record/run_file.h"
#include "ganglion/report/report.h"

namespace ganglion::lab {
namespace {

namespace fs = std::filesystem;

/// The page beside the run file.
Result<fs::path> write_page(const fs::path& run_file, Language language) {
  const auto file = RunFile::read(run_file);
  if (!file) {
    return fail_at(file.error().place, ErrorCode::Unwritable,  // it was written a moment ago
                   {"cannot be read again: {}", "no se puede volver a leer: {}"}, file.error().what);
  }
  fs::path page = run_file;
  page.replace_extension(".html");
  if (auto written = report::write_report(plot::from_run_file(*file), page, {language}); !written)
    return tl::unexpected<Error>(written.error());
  return page;
}

void make_of_file(const Prepared& prepared, const Keep& keep, Outcome& outcome) {
  if (keep.run_file.empty() || outcome.trouble(Trouble::Of::Files) != nullptr) return;
  if (keep.report) {
    if (const auto page = write_page(outcome.files.front(), keep.language)) {
      outcome.files.push_back(page->string());
    } else {
      outcome.troubles.push_back({Trouble::Of::Files, page.error()});
    }
  }
  if (!keep.catalogue) return;
  if (const auto listed = catalogue(keep.run_file.parent_path(), {outcome}, prepared); !listed)
    outcome.troubles.push_back({Trouble::Of::Catalogue, listed.error()});
}

Error kept_beside(const fs::path& file, const std::string& beside) {
  return {ErrorCode::Unwritable,
          say({"is not as this run found it; what was learned is kept in {}",
               "no está como lo encontró esta ejecución; lo aprendido se guarda en {}"},
              beside),
          {file.string()}};
}

Prepared with_faults(Prepared prepared, const std::vector<Fault>& faults) {
  auto& all = prepared.experiment.faults;
  all.insert(all.end(), faults.begin(), faults.end());
  return prepared;
}

}  // namespace

Result<void> catalogue(const fs::path& folder, const std::vector<Outcome>& outcomes, const Prepared& prepared) {
  auto runs = RunCatalogue::open(folder);
  if (!runs) return tl::unexpected<Error>(runs.error());
  Result<void> all;
  for (const Outcome& outcome : outcomes) {
    if (outcome.files.empty()) continue;
    RunSummary summary;
    summary.file = fs::path(outcome.files.front()).lexically_relative(folder).generic_string();
    summary.name = prepared.experiment.name;
    summary.seed = outcome.job.seed;
    summary.episode = outcome.job.episode;
    summary.controller_hash = prepared.controller_hash;
    summary.finished = true;
    summary.digest = outcome.digest;
    summary.verdict = outcome.verdict;
    summary.reason = outcome.reason;
    summary.measures = outcome.figures;
    summary.recorded_s = std::time(nullptr);
    if (auto added = runs->add(summary); !added && all) all = tl::unexpected<Error>(added.error());
  }
  return all;
}

Result<Outcome> carry_out(const Prepared& prepared, const Job& job, const Keep& keep, const Hooks& hooks) {
  RunOptions options = hooks.run;
  options.seed = job.seed;
  options.episode = job.episode;
  options.run_file = keep.run_file;
  KeptExperience experience;
  if (!keep.experience.empty()) {
    auto kept = keep_experience(keep.experience, prepared.controller, prepared.experiment.name);
    if (!kept) return tl::unexpected<Error>(kept.error());
    experience = std::move(*kept);
    options.experience = experience.remembered;
    options.keeper = experience.keeper.get();
    for (const Sentence& note : experience.notes) {
      if (hooks.note) hooks.note(note);
    }
  }
  const auto result = job.faults.empty() ? run(prepared, options) : run(with_faults(prepared, job.faults), options);
  if (hooks.ended) hooks.ended(result);
  if (!result) return tl::unexpected<Error>(result.error());
  Outcome outcome = outcome_of(job, *result);
  if (result->experience_error) outcome.troubles.push_back({Trouble::Of::Files, *result->experience_error});
  if (const auto beside = experience.keeper != nullptr ? experience.keeper->beside() : std::nullopt) {
    outcome.troubles.push_back({Trouble::Of::Files, kept_beside(keep.experience, *beside)});
  }
  make_of_file(prepared, keep, outcome);
  return outcome;
}

}  // namespace ganglion::lab
