#pragma once

#include <string>
#include <vector>

#include "ganglion/lab/fault_matrix.h"

namespace ganglion {

/// `run --json`: one object with `runs` and `summary` (docs/manual/run.md). Numbers that are none are null.
std::string results_json(const std::vector<lab::Outcome>& outcomes);

/// One row a run and a summary, for people.
std::string results_table(const std::vector<lab::Outcome>& outcomes, Language language);

/// `run --faults --json`: one object, `faults` with a row each: name, count, succeeded, share_of_healthy, quartiles.
std::string faults_json(const std::vector<lab::FaultRow>& rows);

/// The same for people.
std::string faults_table(const std::vector<lab::FaultRow>& rows, Language language);

}  // namespace ganglion
