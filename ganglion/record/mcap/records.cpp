#include "ganglion/record/mcap/records.h"

#include "ganglion/record/mcap/fields.h"

namespace ganglion::mcap {

std::optional<std::pair<std::uint16_t, Schema>> decode_schema(std::string_view content) {
  FieldReader fields(content);
  std::pair<std::uint16_t, Schema> schema;
  schema.first = fields.u16();
  schema.second.name = fields.string();
  schema.second.encoding = fields.string();
  schema.second.data = fields.string();
  return fields.ok() ? std::optional(std::move(schema)) : std::nullopt;
}

std::optional<Channel> decode_channel(std::string_view content) {
  FieldReader fields(content);
  Channel channel;
  channel.id = fields.u16();
  channel.schema = fields.u16();
  channel.topic = fields.string();
  channel.message_encoding = fields.string();
  channel.metadata = fields.map();
  return fields.ok() ? std::optional(std::move(channel)) : std::nullopt;
}

std::optional<Message> decode_message(std::string_view content) noexcept {
  FieldReader fields(content);
  Message message;
  message.channel = fields.u16();
  message.sequence = fields.u32();
  message.log_time_ns = fields.u64();
  message.publish_time_ns = fields.u64();
  message.data = fields.rest();
  return fields.ok() ? std::optional(message) : std::nullopt;
}

std::optional<ChunkView> decode_chunk(std::string_view content) noexcept {
  FieldReader fields(content);
  fields.u64();  // first and last time, which the messages tell as well
  fields.u64();
  ChunkView chunk;
  chunk.unpacked_bytes = fields.u64();
  chunk.crc = fields.u32();
  chunk.compression = fields.string();
  chunk.packed = fields.bytes(fields.u64());
  return fields.ok() ? std::optional(chunk) : std::nullopt;
}

std::optional<CheckedAttachment> decode_attachment(std::string_view content) {
  FieldReader fields(content);
  CheckedAttachment checked;
  checked.attachment.log_time_ns = fields.u64();
  fields.u64();  // time of creation
  checked.attachment.name = fields.string();
  checked.attachment.media_type = fields.string();
  checked.attachment.bytes = fields.bytes(fields.u64());
  const std::size_t covered = content.size() - fields.rest().size();
  const std::uint32_t crc = fields.u32();
  if (!fields.ok()) return std::nullopt;
  checked.crc_matches = crc == 0 || crc32(content.substr(0, covered)) == crc;
  return checked;
}

std::optional<Metadata> decode_metadata(std::string_view content) {
  FieldReader fields(content);
  Metadata metadata;
  metadata.name = fields.string();
  metadata.fields = fields.map();
  return fields.ok() ? std::optional(std::move(metadata)) : std::nullopt;
}

}  // namespace ganglion::mcap
