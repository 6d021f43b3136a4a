#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The MCAP container, https://mcap.dev/spec. Bytes are held in std::string and std::string_view.
namespace ganglion::mcap {

inline constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};

/// First byte of a record. A record is opcode, u64 length of the content, content.
enum class Opcode : std::uint8_t {
  Header = 0x01,
  Footer = 0x02,
  Schema = 0x03,
  Channel = 0x04,
  Message = 0x05,
  Chunk = 0x06,
  MessageIndex = 0x07,
  ChunkIndex = 0x08,
  Attachment = 0x09,
  AttachmentIndex = 0x0a,
  Statistics = 0x0b,
  Metadata = 0x0c,
  MetadataIndex = 0x0d,
  SummaryOffset = 0x0e,
  DataEnd = 0x0f,
};

/// Opcode and length in front of every record's content [bytes].
inline constexpr std::size_t kRecordHeadBytes = 9;
/// Channel, sequence and two times in front of every message's data [bytes].
inline constexpr std::size_t kMessageHeadBytes = 22;
/// Content of the footer record [bytes]; the format promises that it never grows.
inline constexpr std::size_t kFooterBytes = 20;

/// Limits of ours, kept by writer and reader alike, so that a damaged length cannot take the machine's memory.
inline constexpr std::size_t kMaxMcapFileBytes = std::size_t{2} << 30;
inline constexpr std::size_t kMaxMessageBytes = std::size_t{64} << 20;
inline constexpr std::size_t kMaxChunkBytes = std::size_t{256} << 20;   ///< Uncompressed.
inline constexpr std::size_t kMaxUnpackedBytes = std::size_t{4} << 30;  ///< All chunks of a file together.

inline constexpr std::size_t kMaxDefinitionBytes = std::size_t{64} << 20;  ///< Schemas, channels and metadata together.
inline constexpr std::size_t kMaxAttachments = 65536;

/// A map<string, string> in the order of the file.
using Fields = std::vector<std::pair<std::string, std::string>>;

struct Schema {
  std::string name;
  std::string encoding;  ///< "protobuf", "jsonschema"...; "" = no schema.
  std::string data;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema = 0;  ///< 0 = none.
  std::string topic;
  std::string message_encoding;  ///< "protobuf", "json"...
  Fields metadata;
};

struct Message {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time_ns = 0;
  std::uint64_t publish_time_ns = 0;
  std::string_view data;
};

struct Attachment {
  std::string name;
  std::string media_type;
  std::string bytes;
  std::uint64_t log_time_ns = 0;
};

struct Metadata {
  std::string name;
  Fields fields;
};

}  // namespace ganglion::mcap
