#pragma once

#include <list>
#include <string>

#include "ganglion/config/outline.h"

namespace ganglion {

/// What the reader of experiment.toml asks.
std::list<config::Outline> experiment_outlines();

/// JSON Schema (2020-12) of experiment.toml, for editors that complete and check while one types. It knows keys, types
/// and ranges; whether files are there and criteria make sense is for read_experiment().
std::string experiment_schema();

}  // namespace ganglion
