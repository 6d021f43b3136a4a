#pragma once

#include <functional>
#include <memory>

#include "ganglion/link/net/address.h"
#include "ganglion/link/robot/robot_end.h"

namespace ganglion::link {

/// Gives a robot's end sockets, or a serial line, and the time. One thread does it all.
class Server {
 public:
  /// Fails with LinkLost where the address cannot be listened at.
  static Result<std::unique_ptr<Server>> listen(RobotEnd& end, const Address& address);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Where it listens, the port it got included.
  const Address& address() const noexcept;
  /// Until stop() says so, which is asked every twentieth of a second; then everybody is told `reason` and closed.
  void serve(const std::function<bool()>& stop, const Sentence& reason);

 private:
  class Shell;
  explicit Server(std::unique_ptr<Shell> shell);
  std::unique_ptr<Shell> shell_;
};

/// A token nobody can guess, 16 hexadecimal digits.
std::string random_token();

}  // namespace ganglion::link
