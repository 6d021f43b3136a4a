#pragma once

#include <filesystem>
#include <functional>

#include "ganglion/lab/outcome.h"

namespace ganglion::lab {

/// What is kept of a run.
struct Keep {
  std::filesystem::path run_file;         ///< Empty: nothing is recorded, and nothing made of it.
  bool report = true;                     ///< A page beside the run file.
  bool catalogue = true;                  ///< A line in the catalogue of the run file's folder.
  std::filesystem::path experience;       ///< Starts with what this file remembers and adds to it; empty: neither.
  Language language = Language::English;  ///< Of the page, as it opens.
};

/// Who follows a run. Of `run` seed, episode, run file, experience and who learns are the job's.
struct Hooks {
  RunOptions run;
  /// Called once when the run is over, before anything is made of its file.
  std::function<void(const Result<RunResult>&)> ended;
  /// Called with what is taken for granted of what was learned before.
  std::function<void(const Sentence&)> note;
};

/// Carries out a run, and all that follows from it: run file, report, catalogue, what was learned. `prepared` is what
/// the job names. Fails as run() does, or where what was learned before cannot be read; what can merely not be kept is
/// told in the outcome.
Result<Outcome> carry_out(const Prepared& prepared, const Job& job, const Keep& keep, const Hooks& hooks = {});

/// Lists the runs of a folder that have a file. Fails as RunCatalogue does.
Result<void> catalogue(const std::filesystem::path& folder, const std::vector<Outcome>& outcomes,
                       const Prepared& prepared);

}  // namespace ganglion::lab
