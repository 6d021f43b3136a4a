#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/run/run.h"

namespace ganglion::lab {

/// One run that is asked for. With the files it names and what was learned before it decides all that comes of it.
struct Job {
  std::string experiment;                   ///< Folder or experiment.toml, as it was named.
  std::vector<config::Override> overrides;  ///< What --set changes.
  std::uint64_t seed = 1;
  std::uint32_t episode = 0;
  std::vector<Fault> faults;  ///< On top of the experiment's own.
};

/// What went wrong beside a run that was carried out.
struct Trouble {
  enum class Of {
    Link,       ///< The robot was lost: the run ended early.
    Files,      ///< Something that was to be kept is not.
    Catalogue,  ///< No loss: the catalogue is built anew from the run files.
  };
  Of of = Of::Files;
  Error error;
};

/// What came of it.
struct Outcome {
  Job job;
  Verdict verdict = Verdict::NotJudged;
  Sentence reason;
  std::string digest;
  Contacts contacts;
  Measures figures;
  std::size_t interventions = 0;
  std::vector<std::string> files;  ///< The run file, then what was made of it.
  std::vector<Trouble> troubles;
  /// The first of that sort, or null.
  const Error* trouble(Trouble::Of of) const noexcept;
};

/// What a run tells of itself, before anything is made of its file.
Outcome outcome_of(Job job, const RunResult& result);

/// All of it: seed, success (null: not judged), reason, reason_es, digest, contacts, measures (null: no number), files,
/// interventions, experiment, set, episode, faults, troubles. `run --json` writes some of these.
nlohmann::ordered_json outcome_json(const Outcome& outcome);
/// The other way, also of files that an older program wrote: only success and measures must be there. `where` opens
/// messages: "runs[3]". Fails with BadType.
Result<Outcome> read_outcome(const nlohmann::ordered_json& json, std::string_view where);

}  // namespace ganglion::lab
