#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/plot/view/language.h"

namespace ganglion::report {

/// How one run of a batch ended.
struct BatchRun {
  bool success = false;
  std::vector<std::pair<std::string, double>> measures;  ///< NaN = without value.
};

/// Runs that differ in their seed only.
struct NamedBatch {
  std::string name;
  std::vector<BatchRun> runs;
};

/// 95 % interval of a share after Wilson (1927); [0, 1] for no runs.
struct Interval {
  double lower = 0;
  double upper = 1;
};
Interval wilson(std::size_t successes, std::size_t runs) noexcept;

/// A page with the success shares and the quartiles of every measure of several batches side by side. It opens offline.
std::string comparison_page(std::span<const NamedBatch> batches, plot::Language language = plot::Language::English);

/// The same into a file. Fails with Unwritable.
Result<void> write_comparison(std::span<const NamedBatch> batches, const std::filesystem::path& path,
                              plot::Language language = plot::Language::English);

}  // namespace ganglion::report
