#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/plot/view/language.h"
#include "ganglion/record/run_info.h"

namespace ganglion::report {

/// How one run of a batch ended.
struct BatchRun {
  Verdict verdict = Verdict::NotJudged;
  std::vector<std::pair<std::string, double>> measures;  ///< NaN = without value.
};

/// Runs that differ in their seed only.
struct NamedBatch {
  std::string name;
  std::vector<BatchRun> runs;
};

/// How many of a batch's runs were judged, and of these succeeded.
struct Successes {
  std::size_t judged = 0;
  std::size_t won = 0;
};
Successes successes_of(const NamedBatch& batch) noexcept;

/// 95 % interval of a share after Wilson (1927); [0, 1] for no runs.
struct Interval {
  double lower = 0;
  double upper = 1;
};
Interval wilson(std::size_t successes, std::size_t runs) noexcept;

/// A page with the share of successes among the runs that were judged ("-" where none was) and the quartiles of every
/// measure, several batches side by side. It opens offline.
std::string comparison_page(std::span<const NamedBatch> batches, plot::Language language = plot::Language::English);

/// The same into a file. Fails with Unwritable.
Result<void> write_comparison(std::span<const NamedBatch> batches, const std::filesystem::path& path,
                              plot::Language language = plot::Language::English);

}  // namespace ganglion::report
