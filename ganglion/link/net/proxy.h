#pragma once

#include <functional>
#include <memory>

#include "ganglion/link/fault/line_fault.h"
#include "ganglion/link/net/address.h"

namespace ganglion::link {

struct ProxyConfig {
  Address listen;
  Address to;  ///< The robot.
  LineFaults faults;
  std::uint64_t seed = 0;
  std::function<void(const Sentence&)> log;  ///< What happens, one line each.
};

/// Stands between controllers and a robot, and does to every connection what its faults say (FaultyConnection). Time
/// counts from the first connection. One thread does it all; a side that does not read is not read for either.
class Proxy {
 public:
  /// Fails with LinkLost where the address cannot be listened at, BadParameter where one of the two is a serial line.
  static Result<std::unique_ptr<Proxy>> listen(ProxyConfig config);
  ~Proxy();
  Proxy(const Proxy&) = delete;
  Proxy& operator=(const Proxy&) = delete;

  /// Where it listens, the port it got included.
  const Address& address() const noexcept;
  /// Until stop() says so, which is asked every twentieth of a second.
  void serve(const std::function<bool()>& stop);

 private:
  class Shell;
  explicit Proxy(std::unique_ptr<Shell> shell);
  std::unique_ptr<Shell> shell_;
};

}  // namespace ganglion::link
