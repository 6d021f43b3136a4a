#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ganglion/base/result.h"

namespace ganglion::link {

/// What carries the bytes.
enum class Carrier : std::uint8_t {
  Stream,   ///< TCP: JSON lines, or binary frames behind their length.
  Packets,  ///< A serial line that loses and damages bytes: packets with a checksum.
};

enum class Encoding : std::uint8_t { Binary, Json };

/// Largest frame [bytes].
inline constexpr std::size_t kMaxFrameBytes = std::size_t{1} << 20;

/// Cuts what arrives into frames. It never holds more than one frame of the largest size and the piece fed last.
class FrameReader {
 public:
  explicit FrameReader(Carrier carrier) : carrier_(carrier) {}
  /// Frames above this are refused, at most kMaxFrameBytes. A small limit for those who have not said who they are.
  void limit(std::size_t bytes) noexcept { limit_ = bytes; }
  void feed(std::string_view bytes);
  /// The next whole frame, in sight until the next call; none until more bytes have come. Fails with Syntax or TooLarge
  /// where a stream follows no rule of the link: nothing can be read from it any more. Packets that are damaged or too
  /// large are left out and counted.
  Result<std::optional<std::string_view>> next();
  /// How the stream is encoded; none before its first byte. Of packets: how the last one was.
  std::optional<Encoding> encoding() const noexcept { return encoding_; }
  /// How many were left out since the last call.
  std::uint32_t take_damaged() noexcept { return std::exchange(damaged_, 0); }
  /// The last one that was left out, as far as it can be printed, at most 60 characters: debug text of a board shows.
  const std::string& damaged_packet() const noexcept { return damaged_packet_; }

 private:
  Result<std::optional<std::string_view>> next_line();
  Result<std::optional<std::string_view>> next_binary();
  std::optional<std::string_view> next_packet();
  std::string_view rest() const noexcept { return std::string_view(buffer_).substr(begin_); }

  Carrier carrier_;
  std::size_t limit_ = kMaxFrameBytes;
  std::optional<Encoding> encoding_;
  std::string buffer_;
  std::size_t begin_ = 0;   // of what is not yet taken out
  std::size_t looked_ = 0;  // up to here there is no end of a line or packet
  bool skipping_ = false;   // a packet that is too large, up to its end
  std::uint32_t damaged_ = 0;
  std::string packet_, damaged_packet_;
};

/// Appends a frame's bytes with what separates it from the next one.
void append_frame(std::string_view payload, Carrier carrier, Encoding encoding, std::string& out);

}  // namespace ganglion::link
