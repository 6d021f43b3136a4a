#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <map>
#include <thread>

#include "ganglion/studio/api/api.h"
#include "ganglion/studio/live/hub.h"
#include "ganglion/studio/server/assets.h"
#include "ganglion/studio/server/guard.h"

namespace ganglion::studio {

namespace asio = boost::asio;
using tcp = asio::ip::tcp;

/// Connections that are open, and how to end them. There is always room for a new one: the oldest that has not shown
/// the key goes first, so that strangers cannot keep the user out.
class Connections {
 public:
  static constexpr std::size_t kMost = 256;
  static constexpr std::size_t kMostViewers = 64;

  std::uint64_t add(std::function<void()> drop);
  void remove(std::uint64_t id) { open_.erase(id); }
  void admit(std::uint64_t id);
  /// False where there are enough viewers.
  bool watch(std::uint64_t id);
  std::size_t size() const noexcept { return open_.size(); }

 private:
  struct Entry {
    std::function<void()> drop;
    bool admitted = false;
    bool watching = false;
  };
  void make_room();
  std::uint64_t next_ = 1;
  std::map<std::uint64_t, Entry> open_;  ///< By age.
};

/// Does something for one connection or for all. What memory, threads or descriptors are wanting for is left undone:
/// one answer is lost, not the server.
template <class Work>
void unless_denied(Work&& work) noexcept {
  try {
    work();
  } catch (...) {  // NOLINT(bugprone-empty-catch): there may be nothing left to say it with
  }
}

/// What all connections share. Everything but `api` belongs to the thread that runs `io`; `api` to the worker.
struct ServerCore {
  ServerCore(Assets page, std::string session) : assets(std::move(page)), hub(std::move(session)) {}

  GuardConfig guard;
  Assets assets;
  Hub hub;
  Connections connections;
  std::unique_ptr<Api> api;
  asio::io_context io{1};  // what still waits in these two holds connections, which use all of the above
  asio::thread_pool worker{1};
};

/// Takes a connection over, and lives as long as it does.
void serve_connection(ServerCore& core, tcp::socket socket);

}  // namespace ganglion::studio
