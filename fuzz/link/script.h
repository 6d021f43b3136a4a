#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/link/wire/framing.h"

namespace ganglion::fuzz {

/// In which form a target's frames come.
struct Dialect {
  link::Carrier carrier = link::Carrier::Stream;
  link::Encoding encoding = link::Encoding::Binary;  ///< What is framed anew; packets keep theirs.
};

/// What is said to one end of the link, piece by piece, each some time after the one before. As bytes: one for the
/// choices, then for each piece a byte of waiting, two of length (low byte first), and what is said.
struct Script {
  struct Piece {
    std::uint8_t wait = 0;  ///< In steps of 20 ms.
    std::string bytes;      ///< As on the wire; none: the connection breaks.
  };
  bool to_controller = false;
  bool free_running = false;
  bool deaf = false;  ///< Who speaks does not read what it is answered.
  std::vector<Piece> pieces;

  static Script parse(std::string_view input);
  std::string text() const;
};
inline constexpr double kWait_s = 0.02;

}  // namespace ganglion::fuzz
