#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/record/mcap/format.h"

namespace ganglion {

/// What is known of a run when it starts. Holds no wall time: equal runs have equal files.
struct RunInfo {
  std::string name;  ///< Of the experiment.
  std::uint64_t seed = 0;
  std::uint32_t episode = 0;
  double tick_s = 0;
  std::string controller_hash;  ///< Hex digits; "" where several or none.
  std::vector<std::string> robots;
  std::map<std::string, std::string> versions;  ///< Of the program and what it links: {"ganglion", "0.1.0"}...
};

/// Whether a run did what its experiment calls success.
enum class Verdict : std::uint8_t { NotJudged, Failed, Succeeded };

/// "true" or "false", as files and tables have it; "" where nobody judged.
constexpr std::string_view success_word(Verdict verdict) noexcept {
  return verdict == Verdict::NotJudged ? "" : verdict == Verdict::Succeeded ? "true" : "false";
}

/// How it ended.
struct RunOutcome {
  std::string digest;  ///< Of the deterministic signals, hex digits.
  Verdict verdict = Verdict::NotJudged;
  Sentence reason;        ///< Why it ended, in plain words; no Spanish in files that had English only.
  std::string criterion;  ///< What the experiment calls success: "progress_ratio >= 0.6; ..."; "" likewise.
  std::vector<std::pair<std::string, double>> measures;  ///< In the order of the experiment file.
  /// Of each component alone, "robot0/escape": what an unrelated component leaves as it was.
  std::vector<std::pair<std::string, std::string>> component_digests;
  std::size_t interventions = 0;  ///< How often somebody reached into the run's world: not the seed's own if any.
};

/// Names of the MCAP metadata records that hold the two.
inline constexpr std::string_view kRunMetadata = "ganglion.run";
inline constexpr std::string_view kOutcomeMetadata = "ganglion.outcome";

/// All as text: a name for each field, "version.<name>", "measure.<name>", "digest.<component>"; the verdict is
/// "success", left out where nobody judged. Numbers in the shortest form that reads back.
mcap::Fields to_fields(const RunInfo& info);
mcap::Fields to_fields(const RunOutcome& outcome);

/// Fails with Corrupt on a number that is none or a field that is missing; unknown fields are passed over, so that
/// files of a newer program can be read.
Result<RunInfo> run_info_from(const mcap::Fields& fields);
Result<RunOutcome> run_outcome_from(const mcap::Fields& fields);

/// Lines "a\nb"; a line break inside a word becomes a space.
std::string to_lines(const std::vector<std::string>& words);
/// The words again; none for "".
std::vector<std::string> from_lines(std::string_view lines);

}  // namespace ganglion
