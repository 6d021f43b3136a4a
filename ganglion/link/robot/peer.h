#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ganglion/link/robot/truth_teller.h"
#include "ganglion/link/wire/codec.h"

namespace ganglion::link {

/// Largest frame of those who do not command [bytes].
inline constexpr std::size_t kMaxSmallFrameBytes = 4096;

/// One connection as the robot keeps it.
struct Peer {
  enum class State : std::uint8_t {
    New,         ///< Has not said Hello.
    Commanding,  ///< Of the one session there is.
    Watching,
    Closing,  ///< Everything was said; once `out` is sent the connection goes.
    Gone,     ///< Not worth a last word.
  };
  Peer(std::uint32_t number, Carrier with, std::string peer_name, double now_s)
      : id(number), carrier(with), reader(with), name(std::move(peer_name)), opened_s(now_s), unread_s(now_s) {
    reader.limit(kMaxSmallFrameBytes);
  }
  bool accepted() const noexcept { return state == State::Commanding || state == State::Watching; }
  std::size_t pending() const noexcept { return out.size() - sent; }
  void forget_sent() {
    if (sent < out.size()) return;
    out.clear();
    sent = 0;
  }

  std::uint32_t id;
  Carrier carrier;
  FrameReader reader;
  std::optional<FrameWriter> writer;
  std::string name;  ///< Address, for the log.
  State state = State::New;
  bool floats = false;
  bool stirred = false;  ///< Is in the list of those to look at.
  bool truth = false;
  double opened_s;
  double unread_s;  ///< When its side last took bytes, or had none to take.
  std::string out;  ///< Bytes for it, of which `sent` are gone.
  std::size_t sent = 0;
  RowsTold told;
  std::uint32_t skipped = 0;  ///< Sense frames it was too slow for.
};

}  // namespace ganglion::link
