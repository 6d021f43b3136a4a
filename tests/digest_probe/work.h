#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace ganglion::probe {

/// One line of output: what was done, and a fingerprint of all that came of it.
void tell(std::string_view what, std::uint64_t fingerprint);

/// Every function of ganglion/math over a table of arguments, awkward ones included.
void probe_math();

/// Random draws of several streams and ticks.
void probe_draws();

/// Drives every controller of every experiment below the folder, alone and among others; a line for each component.
/// False where an experiment cannot be read or there is none.
bool probe_experiments(const std::filesystem::path& folder);

}  // namespace ganglion::probe
