#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ganglion/base/result.h"
#include "ganglion/link/wire/framing.h"

namespace ganglion::link {

/// A way to a robot: bytes there and back, and the clock that goes with it. Errors mean that the connection is gone.
class Line {
 public:
  virtual ~Line() = default;
  virtual Carrier carrier() const noexcept = 0;
  /// As a person wrote it: "tcp://127.0.0.1:7007".
  virtual const std::string& address() const noexcept = 0;
  virtual double now_s() noexcept = 0;
  /// Connects, or connects anew, until until_s at the latest.
  virtual Result<void> connect(double until_s) = 0;
  virtual void close() noexcept = 0;
  /// Sends all of it. Fails as well where the other side does not take it until until_s.
  virtual Result<void> send(std::string_view bytes, double until_s) = 0;
  /// What has come, at most as much as there is room for; waits for it until until_s. 0: nothing came.
  virtual Result<std::size_t> receive(std::span<char> room, double until_s) = 0;
  virtual void wait_until(double until_s) = 0;
};

/// The pause between two tries to connect.
inline constexpr double kRetry_s = 0.1;
/// Room for what a robot sends at once.
inline constexpr std::size_t kRoomBytes = std::size_t{64} << 10;

}  // namespace ganglion::link
