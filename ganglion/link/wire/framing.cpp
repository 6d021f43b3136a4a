#include "ganglion/link/wire/framing.h"

#include <algorithm>

#include "ganglion/base/expects.h"
#include "ganglion/base/text.h"
#include "ganglion/link/wire/cobs.h"

namespace ganglion::link {
namespace {

constexpr std::size_t kLengthBytes = 4;
constexpr std::size_t kPacketOverhead = 2 + kMaxFrameBytes / 254 + 1;  // checksum and stuffing

}  // namespace

void FrameReader::feed(std::string_view bytes) {
  if (begin_ > 0) {
    buffer_.erase(0, begin_);
    looked_ -= std::min(looked_, begin_);
    begin_ = 0;
  }
  buffer_ += bytes;
}

Result<std::optional<std::string_view>> FrameReader::next() {
  if (carrier_ == Carrier::Packets) return next_packet();
  if (rest().empty()) return std::optional<std::string_view>{};
  if (!encoding_) {
    const char first = rest().front();
    if (first != '{' && first != 0) {
      return fail(
          ErrorCode::Syntax,
          {"this is a Ganglion robot link: begin with a JSON line ({{\"hello\": ...}}) or a binary frame behind "
           "its length in 4 bytes, not with byte 0x{:02x}",
           "esto es un enlace de robot de Ganglion: empiece con una línea JSON ({{\"hello\": ...}}) o una trama "
           "binaria tras su longitud en 4 bytes, no con el byte 0x{:02x}"},
          static_cast<unsigned char>(first));
    }
    encoding_ = first == '{' ? Encoding::Json : Encoding::Binary;
  }
  return *encoding_ == Encoding::Json ? next_line() : next_binary();
}

Result<std::optional<std::string_view>> FrameReader::next_line() {
  const std::size_t end = buffer_.find('\n', std::max(begin_, looked_));
  const std::size_t length = (end == std::string::npos ? buffer_.size() : end) - begin_;
  if (length > limit_) {
    return fail(ErrorCode::TooLarge, {"a line is longer than {} bytes", "una línea tiene más de {} bytes"}, limit_);
  }
  if (end == std::string::npos) {
    looked_ = buffer_.size();
    return std::optional<std::string_view>{};
  }
  const std::string_view line = rest().substr(0, length);
  begin_ = looked_ = end + 1;
  return std::optional(line);
}

Result<std::optional<std::string_view>> FrameReader::next_binary() {
  const std::string_view all = rest();
  if (all.size() < kLengthBytes) return std::optional<std::string_view>{};
  std::size_t length = 0;
  for (std::size_t n = 0; n < kLengthBytes; ++n) length = length << 8 | static_cast<unsigned char>(all[n]);
  if (length > limit_) {
    return fail(ErrorCode::TooLarge,
                {"a frame announces {} bytes; the limit is {}", "una trama anuncia {} bytes; el límite es {}"}, length,
                limit_);
  }
  if (all.size() < kLengthBytes + length) return std::optional<std::string_view>{};
  begin_ += kLengthBytes + length;
  return std::optional(all.substr(kLengthBytes, length));
}

std::optional<std::string_view> FrameReader::next_packet() {
  for (;;) {
    const std::size_t end = buffer_.find('\0', std::max(begin_, looked_));
    const std::size_t length = (end == std::string::npos ? buffer_.size() : end) - begin_;
    if (length > limit_ + kPacketOverhead) skipping_ = true;
    if (end == std::string::npos) {
      if (skipping_) begin_ = buffer_.size();
      looked_ = buffer_.size();
      return std::nullopt;
    }
    packet_.assign(buffer_, begin_, length);
    begin_ = looked_ = end + 1;
    std::string_view payload;
    const bool whole = !skipping_ && open_packet(packet_, payload) && !payload.empty() && payload.size() <= limit_;
    if (!whole && (skipping_ || length > 0)) {
      ++damaged_;
      damaged_packet_ = printable(std::string_view(buffer_).substr(begin_ - length - 1, length), 60);
    }
    skipping_ = false;
    if (!whole) continue;
    encoding_ = payload.front() == '{' ? Encoding::Json : Encoding::Binary;
    return payload;
  }
}

void append_frame(std::string_view payload, Carrier carrier, Encoding encoding, std::string& out) {
  expects(payload.size() <= kMaxFrameBytes);
  if (carrier == Carrier::Packets) {
    out += '\0';  // ends whatever else was printed on the line
    append_packet(payload, out);
  } else if (encoding == Encoding::Json) {
    out += payload;
    out += '\n';
  } else {
    const auto size = static_cast<std::uint32_t>(payload.size());
    for (const int shift : {24, 16, 8, 0}) out += static_cast<char>(size >> shift);
    out += payload;
  }
}

}  // namespace ganglion::link
