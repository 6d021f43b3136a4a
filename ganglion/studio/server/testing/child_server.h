#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "ganglion/studio/server/server.h"
#include "ganglion/studio/server/testing/client.h"

namespace ganglion::studio {

/// A server in a process of its own, that can be killed at any moment. To be made before the test starts threads.
class ChildServer {
 public:
  explicit ChildServer(const std::filesystem::path& folder) {
    int pipe[2] = {-1, -1};
    if (::pipe(pipe) != 0) return;
    process_ = ::fork();
    if (process_ == 0) serve(folder, pipe[1]);
    char room[200] = {};
    if (::read(pipe[0], room, sizeof room - 1) > 64) {
      const std::string line(room);
      client_ = {static_cast<std::uint16_t>(std::stoi(line)), line.substr(line.find(' ') + 1, 64), {}};
    }
    ::close(pipe[0]);
    ::close(pipe[1]);
  }
  ~ChildServer() { kill(); }
  ChildServer(const ChildServer&) = delete;
  ChildServer& operator=(const ChildServer&) = delete;
  const Client& client() const noexcept { return client_; }

  /// SIGKILL, and waits for its end.
  void kill() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = -1;
  }

 private:
  [[noreturn]] static void serve(const std::filesystem::path& folder, int told) {
    const auto server = Server::start({.folder = folder});
    const std::string where = std::to_string((*server)->port()) + " " + (*server)->token() + "\n";
    if (::write(told, where.data(), where.size()) < 0) ::_exit(1);
    for (;;) ::pause();
  }
  pid_t process_ = -1;
  Client client_;
};

}  // namespace ganglion::studio
