#pragma once

#include <string>

#include "ganglion/report/comparison.h"

namespace ganglion {

/// The runs that `NAME=PATH` or just `PATH` names: a file as `run --json` prints it, or a folder of run files.
/// Without a name the path's last part is taken. Runs that were cut count as failed.
/// Fails with NotFound, Unreadable, Syntax, BadType or MissingKey, each with its place.
Result<report::NamedBatch> read_batch(const std::string& argument);

}  // namespace ganglion
