#pragma once

#include <string>
#include <vector>

#include "ganglion/record/run_info.h"

namespace ganglion {

/// Names of components, "robot0/escape", sorted.
struct DigestComparison {
  std::vector<std::string> same, different, only_first, only_second;
};

/// Holds the digests of two runs' components against each other: a component that is unrelated to whatever the two runs
/// differ in has the same in both.
DigestComparison compare_components(const RunOutcome& first, const RunOutcome& second);

}  // namespace ganglion
