#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/record/mcap/writer.h"

namespace ganglion {

/// What of a cut or damaged file was saved.
struct Recovery {
  std::uint64_t chunks = 0;  ///< Whole ones; the file written may have other ones.
  std::uint64_t messages = 0;
  double until_s = 0;             ///< Time of the latest message.
  bool finished = false;          ///< The outcome of the run is among what was saved.
  std::vector<Sentence> damages;  ///< What was passed over, in words; empty = the file was whole.
};

/// Name of the MCAP metadata record that a recovered file has more than the run had: what was saved, and what was
/// wrong.
inline constexpr std::string_view kRecoveredMetadata = "ganglion.recovered";

/// Writes a whole, indexed file with all that is whole in the run file `from`: every chunk, attachment and metadata
/// record whose bytes and checksum are there. Channels and schemas may get other numbers. `from` is only read.
///
/// Fails with what read_mcap() fails with; with Unsupported where not even the description of a run is left; with
/// BadParameter where both names mean one file; with Unwritable or TooLarge where `to` cannot be written, and then
/// leaves no `to`.
Result<Recovery> recover_run(const std::filesystem::path& from, const std::filesystem::path& to,
                             McapWriterOptions options = {});

/// The same for bytes in memory; `name` is the file's name in messages.
Result<Recovery> recover_run(std::string_view bytes, const std::string& name, const std::filesystem::path& to,
                             McapWriterOptions options = {});

}  // namespace ganglion
