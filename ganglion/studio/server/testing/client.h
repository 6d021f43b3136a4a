#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ganglion::studio {

/// What a server answered. Header names in lower case.
struct Answer {
  unsigned status = 0;  ///< 0 = the connection ended without an answer.
  std::multimap<std::string, std::string> headers;
  std::string body;
  std::string header(const std::string& name) const;
  nlohmann::ordered_json json() const { return nlohmann::ordered_json::parse(body, nullptr, false); }
};

/// Sends exactly these bytes to a port of this machine and reads until the other side closes or the answer is whole.
Answer talk(std::uint16_t port, const std::string& bytes);

/// A client that a server lets in; each header can be left out or changed.
struct Client {
  std::uint16_t port = 0;
  std::string token;
  std::map<std::string, std::string> headers;  ///< Further ones; "" takes one of ours out.

  Answer get(const std::string& target) const { return send("GET", target, ""); }
  Answer post(const std::string& target, const nlohmann::ordered_json& body) const {
    return send("POST", target, body.is_null() ? "{}" : body.dump());
  }
  Answer send(const std::string& method, const std::string& target, const std::string& body) const;
};

/// An open connection of raw bytes.
class RawConnection {
 public:
  explicit RawConnection(std::uint16_t port, const char* address = "127.0.0.1");
  ~RawConnection();
  RawConnection(RawConnection&&) noexcept;
  bool is_open() const noexcept { return socket_ >= 0; }
  void write(const std::string& bytes);
  /// Whether the other side has closed, waiting for it at most so long.
  bool closed_within(double seconds);

 private:
  int socket_;
};

/// A WebSocket to the server; plain blocking reads with a time limit.
class Watcher {
 public:
  /// The handshake's status; 101 = open.
  Watcher(const Client& client, const std::string& target = "/ws");
  ~Watcher();
  unsigned status() const noexcept;
  struct Message {
    bool binary = false;
    std::string bytes;
    nlohmann::ordered_json json() const { return nlohmann::ordered_json::parse(bytes, nullptr, false); }
  };
  /// None when nothing came within the time, or the connection has ended.
  std::optional<Message> next(double seconds = 10);
  /// The next text message that is an event of that name.
  std::optional<nlohmann::ordered_json> event(const std::string& name, double seconds = 20);
  /// Whether the connection ends, waiting for it at most so long; messages are passed over.
  bool ended_within(double seconds);
  /// False when the server has closed.
  bool send(const std::string& text);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ganglion::studio
