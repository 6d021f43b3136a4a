#pragma once

#include <string>
#include <vector>

#include "ganglion/run/fault_matrix.h"

namespace ganglion {

/// `run --json`: one object with `runs` and `summary` (docs/manual/run.md). Numbers that are none are null.
std::string results_json(const std::vector<RunResult>& results);

/// One row a run and a summary, for people.
std::string results_table(const std::vector<RunResult>& results, Language language);

/// `run --faults --json`: one object, `faults` with a row each: name, count, succeeded, share_of_healthy, quartiles.
std::string faults_json(const std::vector<FaultRow>& rows);

/// The same for people.
std::string faults_table(const std::vector<FaultRow>& rows, Language language);

}  // namespace ganglion
