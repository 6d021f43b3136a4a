#pragma once

#include <string>
#include <vector>

#include "ganglion/run/run.h"

namespace ganglion {

/// `run --json`: one object with `runs` and `summary` (docs/manual/run.md). Numbers that are none are null.
std::string results_json(const std::vector<RunResult>& results);

/// One row a run and a summary, for people.
std::string results_table(const std::vector<RunResult>& results);

}  // namespace ganglion
