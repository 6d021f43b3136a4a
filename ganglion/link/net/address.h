#pragma once

#include <cstdint>
#include <string>

#include "ganglion/base/result.h"

namespace ganglion::link {

/// Where a robot is: "tcp://HOST:PORT" ("HOST:PORT" will do), or "serial:///dev/ttyUSB0?baud=115200".
struct Address {
  enum class Kind : std::uint8_t { Tcp, Serial };
  Kind kind = Kind::Tcp;
  std::string text;  ///< In full, for people.
  std::string host;
  std::uint16_t port = 0;
  std::string device;
  unsigned baud = 115'200;
};

/// Fails with BadParameter. Port 0 is for listening: any free one.
Result<Address> parse_address(const std::string& text);

}  // namespace ganglion::link
