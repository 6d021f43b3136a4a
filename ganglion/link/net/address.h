#pragma once

#include <cstdint>
#include <string>

#include "ganglion/base/result.h"

namespace ganglion::link {

/// Where a robot is: "tcp://HOST:PORT" ("HOST:PORT" will do), "serial:///dev/ttyUSB0?baud=115200", or
/// "serial+tcp://HOST:PORT", a serial line that a terminal server or an emulator carries on over TCP.
struct Address {
  enum class Kind : std::uint8_t { Tcp, Serial, SerialOverTcp };
  Kind kind = Kind::Tcp;
  std::string text;  ///< In full, for people.
  std::string host;
  std::uint16_t port = 0;
  std::string device;
  unsigned baud = 115'200;
  bool open = false;  ///< Listened at: from other machines as well.
};

/// "tcp://HOST:PORT", as parse_address() reads it: addresses with colons in brackets.
std::string tcp_text(const std::string& host, std::uint16_t port);

/// Fails with BadParameter. Port 0 is for listening: any free one.
Result<Address> parse_address(const std::string& text);

}  // namespace ganglion::link
