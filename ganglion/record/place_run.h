#pragma once

#include <filesystem>

#include "ganglion/base/result.h"
#include "ganglion/record/run_file.h"

namespace ganglion {

/// Whether two files hold the same run: all that went in, all that came out, of a simulation that repeats itself to the
/// bit. Runs of robots at the other end of a link never are the same, nor is one without outcome.
bool same_run(const RunFile& one, const RunFile& other);

/// Gives a run file that is closed its name: the wanted one, or where something else has that, the next that is free,
/// "seed_0001-2.mcap", "seed_0001-3.mcap"... Nothing is written over, whoever names files there at the same time. Where
/// one of those names is the same run, that file stays, with the present time, and the new one is dropped. Gives where
/// the run lies now. Fails with Unwritable; the file then stays where it was.
Result<std::filesystem::path> place_run(const std::filesystem::path& recorded, const std::filesystem::path& wanted);

}  // namespace ganglion
