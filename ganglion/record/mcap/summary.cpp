// The summary at the end of an MCAP file: copies and indices that let a reader jump.
#include "ganglion/record/mcap/fields.h"
#include "ganglion/record/mcap/writer.h"

namespace ganglion {

using mcap::FieldWriter;
using mcap::Opcode;

std::string McapWriter::statistics() const {
  std::string record_bytes;
  FieldWriter out(record_bytes);
  const std::size_t record = out.begin_record(Opcode::Statistics);
  out.u64(file_span_.messages);
  out.u16(static_cast<std::uint16_t>(schema_count_));
  out.u32(static_cast<std::uint32_t>(channels_.size()));
  out.u32(attachment_count_);
  out.u32(metadata_count_);
  out.u32(chunk_count_);
  out.u64(file_span_.first_ns);
  out.u64(file_span_.last_ns);
  out.u32(static_cast<std::uint32_t>(channels_.size() * (sizeof(std::uint16_t) + sizeof(std::uint64_t))));
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    out.u16(static_cast<std::uint16_t>(i + 1));
    out.u64(channels_[i].messages);
  }
  out.end_record(record);
  return record_bytes;
}

void McapWriter::write_group(std::string& offsets, Opcode opcode, std::string_view records) {
  if (records.empty()) return;
  FieldWriter out(offsets);
  const std::size_t record = out.begin_record(Opcode::SummaryOffset);
  out.u8(static_cast<std::uint8_t>(opcode));
  out.u64(file_.position() + scratch_.size());
  out.u64(records.size());
  out.end_record(record);
  scratch_ += records;
}

void McapWriter::write_summary() {
  scratch_.clear();
  FieldWriter out(scratch_);
  const std::size_t data_end = out.begin_record(Opcode::DataEnd);
  out.u32(file_.crc());
  out.end_record(data_end);
  put(scratch_);

  const std::uint64_t summary_start = file_.position();
  std::string offsets;
  scratch_.clear();
  write_group(offsets, Opcode::Schema, schemas_);
  write_group(offsets, Opcode::Channel, channel_records_);
  write_group(offsets, Opcode::ChunkIndex, chunk_indices_);
  write_group(offsets, Opcode::AttachmentIndex, attachment_indices_);
  write_group(offsets, Opcode::MetadataIndex, metadata_indices_);
  write_group(offsets, Opcode::Statistics, statistics());
  const std::uint64_t offsets_start = summary_start + scratch_.size();
  scratch_ += offsets;

  const std::size_t footer = out.begin_record(Opcode::Footer);
  out.u64(summary_start);
  out.u64(offsets_start);
  // The summary's CRC covers all of the footer before itself, its length included.
  const std::uint64_t length = mcap::kFooterBytes;
  __builtin_memcpy(scratch_.data() + footer + 1, &length, sizeof length);
  out.u32(mcap::crc32(scratch_));
  out.bytes(mcap::kMagic);
  put(scratch_);
}

}  // namespace ganglion
