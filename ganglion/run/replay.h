#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ganglion/base/result.h"

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
  std::vector<Sentence> damages;  ///< Of the file's end, or its summary, which a replay does not need.
};

/// Runs a recorded run again from its own input files, and compares bit for bit. Fails where the file cannot be read,
/// has lost any of its data or what went into the run, or its inputs are not accepted by this program any more.
Result<ReplayResult> replay_run(const std::filesystem::path& run_file);

}  // namespace ganglion
