#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

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
};

/// Runs a recorded run again from its own input files, and compares bit for bit. Fails where the file cannot be read or
/// its inputs are not accepted by this program any more.
Result<ReplayResult> replay_run(const std::filesystem::path& run_file);

}  // namespace ganglion
