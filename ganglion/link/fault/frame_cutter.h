#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ganglion/link/wire/framing.h"

namespace ganglion::link {

/// Cuts what passes into whole frames with everything that frames them, without looking into them; bytes that follow
/// no rule of the link pass in the pieces they came in. So faults strike the same frames however a system cuts bytes.
class FrameCutter {
 public:
  explicit FrameCutter(Carrier carrier) : carrier_(carrier) {}
  void feed(std::string_view bytes) { buffer_ += bytes; }
  /// The next whole frame; none until more bytes have come.
  std::optional<std::string> next();
  /// What is left of a frame that never became whole.
  std::string take_rest() noexcept;

 private:
  std::size_t frame_bytes();

  Carrier carrier_;
  std::string buffer_;
  std::size_t looked_ = 0;  // up to here there is no end of a line or packet
  char first_ = 0;          // of a stream: says how it is framed
  bool begun_ = false;
  bool unknown_ = false;  // follows no rule
};

}  // namespace ganglion::link
