#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "ganglion/record/mcap/format.h"

namespace ganglion::mcap {

/// A chunk as it lies in the file.
struct ChunkView {
  std::uint64_t unpacked_bytes = 0;
  std::uint32_t crc = 0;  ///< Of the unpacked records; 0 = not given.
  std::string_view compression;
  std::string_view packed;
};

struct CheckedAttachment {
  Attachment attachment;
  bool crc_matches = true;
};

/// The fields of a record's content; none where the content is too short for what its lengths say.
std::optional<std::pair<std::uint16_t, Schema>> decode_schema(std::string_view content);
std::optional<Channel> decode_channel(std::string_view content);
std::optional<Message> decode_message(std::string_view content) noexcept;
std::optional<ChunkView> decode_chunk(std::string_view content) noexcept;
std::optional<CheckedAttachment> decode_attachment(std::string_view content);
std::optional<Metadata> decode_metadata(std::string_view content);

}  // namespace ganglion::mcap
