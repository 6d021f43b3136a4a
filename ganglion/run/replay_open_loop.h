#pragma once

#include <filesystem>
#include <string>

#include "ganglion/base/result.h"

namespace ganglion {

/// Feeds recorded sensations to a controller, open loop: columns `time_s`, optional `cost`, and the ids of sensations
/// ("position.x" where there are several values; absent = NaN). Gives `time_s`, every command as "command.channel", and
/// for each coordinator "id.active", the winner's id or "". Fails with located problems.
Result<std::string> replay_open_loop(const std::filesystem::path& controller, const std::filesystem::path& inputs,
                                     Problems& problems);

}  // namespace ganglion
