#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/record/mcap/format.h"

namespace ganglion {

/// Whether a damaged or cut file is refused, or read as far as it goes.
enum class Recover { No, Yes };

/// All of an MCAP file but its messages, which went to the sink.
struct McapContent {
  std::string library;
  std::map<std::uint16_t, mcap::Schema> schemas;
  std::map<std::uint16_t, mcap::Channel> channels;
  std::vector<mcap::Attachment> attachments;
  std::vector<mcap::Metadata> metadata;
  std::uint64_t chunks = 0;    ///< Whole ones; without a sink they are not looked at, and 0.
  std::uint64_t messages = 0;  ///< Without a sink: as the summary states, 0 where there is none.
  /// What Recover::Yes passed over, in the order of the file; empty = the file is whole.
  std::vector<Sentence> damages;
  /// Nothing was left out of the data as far as it goes: the file was cut, or its summary is damaged, which only repeats
  /// what the data says, or it is whole.
  bool without_gaps = true;
};

/// Given every message in the order of the file; its data lives only as long as the call.
using MessageSink = std::function<void(const mcap::Channel&, const mcap::Message&)>;

/// Reads a file of ours or of another writer: chunks of zstd or none, with or without summary. Every length and every
/// CRC is checked. A chunk's messages reach the sink only if the whole chunk is good; with an empty sink chunks stay
/// packed (and channels that another writer defined inside chunks are known from the summary only).
///
/// Recover::No   fails with Corrupt at the first damage, by byte; the sink may have had messages before it.
/// Recover::Yes  leaves out damaged chunks and attachments, stops where the sequence of records breaks off, and fails
///               only if the file does not begin as MCAP, or all of it unpacks to more than the limit.
/// Fails also with NotFound, Unreadable, TooLarge (limits in format.h), Unsupported (lz4 chunks).
Result<McapContent> read_mcap(const std::filesystem::path& path, Recover recover, const MessageSink& sink);

/// The same for bytes in memory; `name` is the file's name in messages.
Result<McapContent> parse_mcap(std::string_view bytes, const std::string& name, Recover recover,
                               const MessageSink& sink, std::size_t max_unpacked_bytes = mcap::kMaxUnpackedBytes);

}  // namespace ganglion
