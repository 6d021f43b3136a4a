#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/studio/live/feed.h"

namespace ganglion::studio {

using Json = nlohmann::ordered_json;

struct ServerOptions {
  std::filesystem::path folder;          ///< All that is read and written lies below it.
  std::string address = "127.0.0.1";     ///< To listen on.
  std::uint16_t port = 0;                ///< 0 = any that is free.
  std::vector<std::string> allow_hosts;  ///< Further names by which it may be asked, "robot.local" or "robot.local:80".
  std::filesystem::path web_root;        ///< The page's files, while one develops them; empty: those built in.
  std::filesystem::path programs;        ///< The user's own list of programs; empty: none.
};

/// The studio's server: serves from its start to its end, on threads of its own.
class Server {
 public:
  /// Fails with NotFound (no such folder), BadParameter (an address that is none, or one that others can reach without
  /// allow_hosts), Unwritable (the port is taken).
  static Result<std::unique_ptr<Server>> start(const ServerOptions& options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::uint16_t port() const noexcept;
  const std::string& token() const noexcept;
  /// What to open in a browser, key included.
  std::string url() const;

  /// Shows a run that is not this server's own; commands are refused from then on.
  void attach(std::shared_ptr<LiveFeed> feed, Json state);
  void tell_attached(Json state);

 private:
  struct Core;
  explicit Server(std::unique_ptr<Core> core);
  std::unique_ptr<Core> core_;
};

}  // namespace ganglion::studio
