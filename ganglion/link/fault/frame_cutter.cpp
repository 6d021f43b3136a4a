#include "ganglion/link/fault/frame_cutter.h"

#include <utility>

namespace ganglion::link {
namespace {

constexpr std::size_t kLengthBytes = 4;
constexpr std::size_t kMostBytes = kMaxFrameBytes + (kMaxFrameBytes >> 6);  // a packet's stuffing included

}  // namespace

/// How many bytes the first frame of the buffer has; 0 where that cannot be said yet.
std::size_t FrameCutter::frame_bytes() {
  if (carrier_ == Carrier::Packets || first_ == '{') {
    const std::size_t end = buffer_.find(carrier_ == Carrier::Packets ? '\0' : '\n', looked_);
    if (end != std::string::npos) return end + 1;
    looked_ = buffer_.size();
    unknown_ = buffer_.size() > kMostBytes;
    return 0;
  }
  if (buffer_.size() < kLengthBytes) return 0;
  std::size_t length = 0;
  for (std::size_t n = 0; n < kLengthBytes; ++n) length = length << 8 | static_cast<unsigned char>(buffer_[n]);
  unknown_ = length > kMaxFrameBytes;
  return unknown_ || buffer_.size() < kLengthBytes + length ? 0 : kLengthBytes + length;
}

std::optional<std::string> FrameCutter::next() {
  if (buffer_.empty()) return std::nullopt;
  if (!begun_) {
    begun_ = true;
    first_ = buffer_.front();
    unknown_ = carrier_ == Carrier::Stream && first_ != '{' && first_ != 0;
  }
  const std::size_t bytes = unknown_ ? 0 : frame_bytes();
  if (unknown_) return take_rest();
  if (bytes == 0) return std::nullopt;
  std::string frame = buffer_.substr(0, bytes);
  buffer_.erase(0, bytes);
  looked_ = 0;
  return frame;
}

std::string FrameCutter::take_rest() noexcept {
  looked_ = 0;
  return std::exchange(buffer_, {});
}

}  // namespace ganglion::link
