#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/record/mcap/compression.h"
#include "ganglion/record/mcap/format.h"
#include "ganglion/record/mcap/output_file.h"

namespace ganglion {

struct McapWriterOptions {
  std::string library = "ganglion";                ///< Who wrote the file, for the header.
  std::size_t chunk_bytes = std::size_t{1} << 20;  ///< A chunk closes once it holds this many, uncompressed,
  std::int64_t chunk_age_ns = 1'000'000'000;  ///< or once bytes not yet on their way to the disk are as old as this.
  int zstd_level = 1;
  bool durable = true;  ///< Waits for the disk (fdatasync): aside while writing, at the end in close().
  mcap::Placing placing = mcap::Placing::Replace;            ///< What becomes of the file in close().
  std::size_t max_file_bytes = mcap::kMaxMcapFileBytes;      ///< What McapReader still takes. Over it the file is full:
  std::size_t max_unpacked_bytes = mcap::kMaxUnpackedBytes;  ///< messages are dropped and status() says from when on.
  std::function<std::int64_t()> now_ns;                      ///< Ages are taken from this; empty = the steady clock.
};

/// Writes an MCAP file: zstd chunks, message indices, summary, all CRCs. Source: https://mcap.dev/spec.
///
/// Schemas and channels go straight into the data section, messages into chunks. A chunk is handed to the operating
/// system when it closes, so that a crash of the program or a power cut loses at most about a second; what is left can
/// be read with Recover::Yes. Failures of the disk are kept and given by status() and close(); writing goes on without
/// effect. Memory: two buffers of about a chunk and the index of one chunk, reused. Not for use by several threads at
/// once.
class McapWriter {
 public:
  /// Fails with Unwritable when the file cannot be made.
  static Result<McapWriter> create(const std::filesystem::path& path, McapWriterOptions options = {});
  McapWriter(McapWriter&&) noexcept = default;
  McapWriter& operator=(McapWriter&&) = delete;
  /// Closes, if close() was not called.
  ~McapWriter();

  /// Numbers count from 1; at most 65535 of each.
  std::uint16_t add_schema(std::string_view name, std::string_view encoding, std::string_view data);
  /// `schema` = 0 for none.
  std::uint16_t add_channel(std::string_view topic, std::uint16_t schema, std::string_view message_encoding,
                            const mcap::Fields& metadata = {});
  /// Takes no memory once its buffers have grown. Data over kMaxMessageBytes is dropped, which status() tells.
  void write(std::uint16_t channel, std::uint64_t log_time_ns, std::uint64_t publish_time_ns, std::uint32_t sequence,
             std::string_view data);
  void attach(std::string_view name, std::string_view media_type, std::string_view bytes,
              std::uint64_t log_time_ns = 0);
  void metadata(std::string_view name, const mcap::Fields& fields);
  /// Closes the chunk now and starts it on its way to the disk. Worth calling when a run pauses: ages are only looked
  /// at when a message is written.
  void flush_chunk();
  /// Writes the summary and closes. Fails with the first failure of the file's whole life. Later calls do nothing.
  Result<void> close();
  /// The first failure so far.
  Result<void> status() const;
  /// Where it is written.
  std::filesystem::path path() const { return file_.path(); }
  /// Bytes handed to the operating system so far.
  std::uint64_t bytes_written() const noexcept { return file_.position(); }

 private:
  struct IndexEntry {
    std::uint64_t log_time_ns;
    std::uint64_t offset;
  };
  struct ChannelState {
    std::vector<IndexEntry> index;  ///< Of the open chunk.
    std::uint64_t messages = 0;
  };
  struct Span {
    std::uint64_t first_ns = 0;
    std::uint64_t last_ns = 0;
    std::uint64_t messages = 0;
    void add(std::uint64_t time_ns) noexcept;
  };

  McapWriter(mcap::OutputFile file, McapWriterOptions options);
  void put(std::string_view records);
  /// False when the message must be dropped; the first reason is kept.
  bool accepts(std::uint64_t log_time_ns, std::size_t bytes);
  void close_chunk();
  void write_chunk_record();
  void write_message_indices();
  void write_summary();
  void write_group(std::string& offsets, mcap::Opcode opcode, std::string_view records);
  std::string statistics() const;

  mcap::OutputFile file_;
  McapWriterOptions options_;
  mcap::Compressor compressor_;
  std::vector<ChannelState> channels_;  ///< By channel number - 1.
  std::string chunk_;                   ///< Records of the open chunk.
  std::string packed_;
  std::string scratch_;
  Span chunk_span_;
  Span file_span_;
  std::optional<std::int64_t> oldest_unsynced_ns_;
  std::uint32_t schema_count_ = 0, attachment_count_ = 0, metadata_count_ = 0, chunk_count_ = 0;
  std::string schemas_, channel_records_, chunk_indices_, attachment_indices_, metadata_indices_;  ///< For the summary.
  std::uint64_t unpacked_bytes_ = 0;  ///< Of all closed chunks.
  Sentence refusal_;                  ///< Why the first message was dropped.
  bool closed_ = false;
};

}  // namespace ganglion
