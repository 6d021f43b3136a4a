#include "ganglion/record/mcap/writer.h"

#include <algorithm>
#include <chrono>

#include "ganglion/base/expects.h"
#include "ganglion/record/mcap/fields.h"

namespace ganglion {

using mcap::FieldWriter;
using mcap::Opcode;

namespace {

std::int64_t steady_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

void McapWriter::Span::add(std::uint64_t time_ns) noexcept {
  first_ns = messages == 0 ? time_ns : std::min(first_ns, time_ns);
  last_ns = std::max(last_ns, time_ns);
  ++messages;
}

Result<McapWriter> McapWriter::create(const std::filesystem::path& path, McapWriterOptions options) {
  auto file = mcap::OutputFile::create(path, options.placing);
  if (!file) return tl::unexpected(file.error());
  return McapWriter(std::move(*file), std::move(options));
}

McapWriter::McapWriter(mcap::OutputFile file, McapWriterOptions options)
    : file_(std::move(file)), options_(std::move(options)), compressor_(options_.zstd_level) {
  if (!options_.now_ns) options_.now_ns = steady_ns;
  scratch_ = mcap::kMagic;
  FieldWriter out(scratch_);
  const std::size_t record = out.begin_record(Opcode::Header);
  out.string("");  // no profile
  out.string(options_.library);
  out.end_record(record);
  put(scratch_);
}

McapWriter::~McapWriter() {
  if (file_.is_open()) static_cast<void>(close());
}

void McapWriter::put(std::string_view records) {
  if (!oldest_unsynced_ns_) oldest_unsynced_ns_ = options_.now_ns();
  file_.write(records);
}

std::uint16_t McapWriter::add_schema(std::string_view name, std::string_view encoding, std::string_view data) {
  expects(!closed_ && schema_count_ < 65535);
  const auto id = static_cast<std::uint16_t>(++schema_count_);
  scratch_.clear();
  FieldWriter out(scratch_);
  const std::size_t record = out.begin_record(Opcode::Schema);
  out.u16(id);
  out.string(name);
  out.string(encoding);
  out.string(data);
  out.end_record(record);
  put(scratch_);
  schemas_ += scratch_;
  return id;
}

std::uint16_t McapWriter::add_channel(std::string_view topic, std::uint16_t schema, std::string_view message_encoding,
                                      const mcap::Fields& metadata) {
  expects(!closed_ && channels_.size() < 65535 && schema <= schema_count_);
  channels_.emplace_back();
  const auto id = static_cast<std::uint16_t>(channels_.size());
  scratch_.clear();
  FieldWriter out(scratch_);
  const std::size_t record = out.begin_record(Opcode::Channel);
  out.u16(id);
  out.u16(schema);
  out.string(topic);
  out.string(message_encoding);
  out.map(metadata);
  out.end_record(record);
  put(scratch_);
  channel_records_ += scratch_;
  return id;
}

void McapWriter::write(std::uint16_t channel, std::uint64_t log_time_ns, std::uint64_t publish_time_ns,
                       std::uint32_t sequence, std::string_view data) {
  expects(!closed_ && channel >= 1 && channel <= channels_.size());
  if (!accepts(log_time_ns, data.size())) return;
  const std::int64_t now_ns = options_.now_ns();
  if (!oldest_unsynced_ns_) oldest_unsynced_ns_ = now_ns;
  ChannelState& state = channels_[channel - 1u];
  state.index.push_back({log_time_ns, chunk_.size()});
  ++state.messages;
  chunk_span_.add(log_time_ns);
  file_span_.add(log_time_ns);
  FieldWriter out(chunk_);
  out.u8(static_cast<std::uint8_t>(Opcode::Message));
  out.u64(mcap::kMessageHeadBytes + data.size());
  out.u16(channel);
  out.u32(sequence);
  out.u64(log_time_ns);
  out.u64(publish_time_ns);
  out.bytes(data);
  const bool old = now_ns - *oldest_unsynced_ns_ >= options_.chunk_age_ns;
  if (old)
    flush_chunk();
  else if (chunk_.size() >= options_.chunk_bytes)
    close_chunk();
}

bool McapWriter::accepts(std::uint64_t log_time_ns, std::size_t bytes) {
  const std::size_t pending = chunk_.size() + mcap::kRecordHeadBytes + mcap::kMessageHeadBytes + bytes;
  Sentence reason;
  if (bytes > mcap::kMaxMessageBytes) {
    reason = say({"a message of {} bytes at {} ns was left out; the limit is {}",
                  "se omitió un mensaje de {} bytes en {} ns; el límite es {}"},
                 bytes, log_time_ns, mcap::kMaxMessageBytes);
  } else if (file_.position() + pending > options_.max_file_bytes ||
             unpacked_bytes_ + pending > options_.max_unpacked_bytes) {
    reason =
        say({"the file is full: nothing from {} ns on is in it", "el archivo está lleno: no contiene nada desde {} ns"},
            log_time_ns);
  } else {
    return true;
  }
  if (refusal_.empty()) refusal_ = std::move(reason);
  return false;
}

void McapWriter::flush_chunk() {
  close_chunk();
  if (!oldest_unsynced_ns_) return;
  oldest_unsynced_ns_.reset();
  if (options_.durable) file_.start_sync();
}

void McapWriter::close_chunk() {
  if (chunk_span_.messages == 0) return;
  write_chunk_record();
  write_message_indices();
  unpacked_bytes_ += chunk_.size();
  chunk_.clear();
  chunk_span_ = {};
}

void McapWriter::write_chunk_record() {
  expects(compressor_.compress(chunk_, packed_));
  const std::uint64_t offset = file_.position();
  scratch_.clear();
  FieldWriter out(scratch_);
  const std::size_t record = out.begin_record(Opcode::Chunk);
  out.u64(chunk_span_.first_ns);
  out.u64(chunk_span_.last_ns);
  out.u64(chunk_.size());
  out.u32(mcap::crc32(chunk_));
  out.string("zstd");
  out.u64(packed_.size());
  out.bytes(packed_);
  out.end_record(record);
  ++chunk_count_;
  FieldWriter index(chunk_indices_);
  // Left open: write_message_indices() adds where they are, and what follows them.
  index.begin_record(Opcode::ChunkIndex);
  index.u64(chunk_span_.first_ns);
  index.u64(chunk_span_.last_ns);
  index.u64(offset);
  index.u64(scratch_.size());
}

void McapWriter::write_message_indices() {
  const std::size_t chunk_length = scratch_.size();
  const std::size_t open_record = chunk_indices_.size() - mcap::kRecordHeadBytes - 4 * sizeof(std::uint64_t);
  const std::uint64_t offset = file_.position();
  FieldWriter out(scratch_);
  FieldWriter index(chunk_indices_);
  const auto used =
      std::count_if(channels_.begin(), channels_.end(), [](const ChannelState& c) { return !c.index.empty(); });
  index.u32(static_cast<std::uint32_t>(used) *
            static_cast<std::uint32_t>(sizeof(std::uint16_t) + sizeof(std::uint64_t)));
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    auto& entries = channels_[i].index;
    if (entries.empty()) continue;
    const auto channel = static_cast<std::uint16_t>(i + 1);
    index.u16(channel);
    index.u64(offset + scratch_.size());
    const std::size_t record = out.begin_record(Opcode::MessageIndex);
    out.u16(channel);
    out.u32(static_cast<std::uint32_t>(entries.size() * sizeof(IndexEntry)));
    for (const IndexEntry& entry : entries) {
      out.u64(entry.log_time_ns);
      out.u64(entry.offset);
    }
    out.end_record(record);
    entries.clear();
  }
  put(scratch_);
  index.u64(scratch_.size() - chunk_length);
  index.string("zstd");
  index.u64(packed_.size());
  index.u64(chunk_.size());
  index.end_record(open_record);
}

void McapWriter::attach(std::string_view name, std::string_view media_type, std::string_view bytes,
                        std::uint64_t log_time_ns) {
  expects(!closed_);
  const std::uint64_t offset = file_.position();
  scratch_.clear();
  FieldWriter out(scratch_);
  const std::size_t record = out.begin_record(Opcode::Attachment);
  out.u64(log_time_ns);
  out.u64(0);  // time of creation: not told, since it would differ between runs that are equal
  out.string(name);
  out.string(media_type);
  out.u64(bytes.size());
  out.bytes(bytes);
  out.u32(mcap::crc32(std::string_view(scratch_).substr(mcap::kRecordHeadBytes)));
  out.end_record(record);
  put(scratch_);
  ++attachment_count_;
  FieldWriter index(attachment_indices_);
  const std::size_t index_record = index.begin_record(Opcode::AttachmentIndex);
  index.u64(offset);
  index.u64(scratch_.size());
  index.u64(log_time_ns);
  index.u64(0);
  index.u64(bytes.size());
  index.string(name);
  index.string(media_type);
  index.end_record(index_record);
}

void McapWriter::metadata(std::string_view name, const mcap::Fields& fields) {
  expects(!closed_);
  const std::uint64_t offset = file_.position();
  scratch_.clear();
  FieldWriter out(scratch_);
  const std::size_t record = out.begin_record(Opcode::Metadata);
  out.string(name);
  out.map(fields);
  out.end_record(record);
  put(scratch_);
  ++metadata_count_;
  FieldWriter index(metadata_indices_);
  const std::size_t index_record = index.begin_record(Opcode::MetadataIndex);
  index.u64(offset);
  index.u64(scratch_.size());
  index.string(name);
  index.end_record(index_record);
}

Result<void> McapWriter::close() {
  if (!closed_) {
    close_chunk();
    write_summary();
    closed_ = true;
    static_cast<void>(file_.close(options_.durable));
  }
  return status();
}

Result<void> McapWriter::status() const {
  if (auto written = file_.status(); !written) return written;
  if (!refusal_.empty()) return tl::unexpected<Error>(Error{ErrorCode::TooLarge, refusal_});
  return {};
}

}  // namespace ganglion
