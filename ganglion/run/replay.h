#pragma once

#include <filesystem>
#include <optional>

#include "ganglion/config/value.h"
#include "ganglion/record/csv.h"
#include "ganglion/run/prepared.h"

namespace ganglion {

/// What repeating a recorded run gave.
struct ReplayResult {
  std::string recorded_digest;
  std::string digest;
  bool same = false;
  std::optional<std::uint32_t> first_tick;  ///< The first that differs, if any does.
  std::string signal;                       ///< The first signal that differs in it.
  double recorded_value = 0;
  double value = 0;
};

/// Runs a recorded run again from its own input files, and compares bit for bit. Fails where the file cannot be read or
/// its inputs are not accepted by this program any more.
Result<ReplayResult> replay_run(const std::filesystem::path& run_file);

/// Feeds recorded sensations to a controller, open loop: columns `time_s`, optional `cost`, and the ids of sensations
/// ("position.x" where there are several values; absent = NaN). Gives `time_s`, every command as "command.channel", and
/// for each coordinator "id.active", the winner's id or "". Fails with located problems.
Result<std::string> replay_open_loop(const std::filesystem::path& controller, const std::filesystem::path& inputs,
                                     Problems& problems);

}  // namespace ganglion
