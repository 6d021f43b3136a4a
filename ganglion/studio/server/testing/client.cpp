#include "ganglion/studio/server/testing/client.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <utility>

#include "ganglion/base/text.h"

namespace ganglion::studio {
namespace {

namespace beast = boost::beast;
namespace websocket = beast::websocket;

int connected(std::uint16_t port, const char* to = "127.0.0.1") {
  const int fd = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = ::inet_addr(to);
  if (fd >= 0 && ::connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
    ::close(fd);
    return -1;
  }
  return fd;
}

bool readable(int fd, double seconds) {
  pollfd one{fd, POLLIN, 0};
  return ::poll(&one, 1, static_cast<int>(seconds * 1000)) > 0;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return text;
}

Answer parse(const std::string& bytes) {
  Answer answer;
  const std::size_t end = bytes.find("\r\n\r\n");
  if (!bytes.starts_with("HTTP/1.1 ") || end == std::string::npos) return answer;
  answer.status = static_cast<unsigned>(std::stoi(bytes.substr(9, 3)));
  for (std::string line : split(std::string_view(bytes).substr(0, end), '\n')) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    answer.headers.emplace(lower(line.substr(0, colon)),
                           std::string(trimmed(std::string_view(line).substr(colon + 1))));
  }
  answer.body = bytes.substr(end + 4);
  return answer;
}

bool whole(const std::string& bytes, bool head) {
  const Answer answer = parse(bytes);
  if (answer.status == 0 || answer.status == 100) return false;
  const std::string length = answer.header("content-length");
  return head || (!length.empty() && answer.body.size() >= std::stoull(length));
}

}  // namespace

std::string Answer::header(const std::string& name) const {
  const auto found = headers.find(name);
  return found != headers.end() ? found->second : std::string();
}

Answer talk(std::uint16_t port, const std::string& bytes) {
  const int fd = connected(port);
  if (fd < 0) return {};
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t put = ::send(fd, bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
    if (put <= 0) break;  // it may have answered already
    at += static_cast<std::size_t>(put);
  }
  std::string received;
  char room[65536];
  while (!whole(received, bytes.starts_with("HEAD")) && readable(fd, 20)) {
    const ssize_t got = ::recv(fd, room, sizeof room, 0);
    if (got <= 0) break;
    received.append(room, static_cast<std::size_t>(got));
  }
  ::close(fd);
  return parse(received);
}

Answer Client::send(const std::string& method, const std::string& target, const std::string& body) const {
  const std::string host = "127.0.0.1:" + std::to_string(port);
  std::map<std::string, std::string> all = {
      {"Host", host}, {"Authorization", "Bearer " + token}, {"Content-Length", std::to_string(body.size())}};
  if (method != "GET" && method != "HEAD") all["Origin"] = "http://" + host;
  for (const auto& [name, value] : headers) all[name] = value;
  std::string bytes = method + " " + target + " HTTP/1.1\r\n";
  for (const auto& [name, value] : all) {
    if (!value.empty()) bytes += name + ": " + value + "\r\n";
  }
  return talk(port, bytes + "\r\n" + body);
}

RawConnection::RawConnection(std::uint16_t port, const char* address) : socket_(connected(port, address)) {}
RawConnection::RawConnection(RawConnection&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}
RawConnection::~RawConnection() {
  if (socket_ >= 0) ::close(socket_);
}
void RawConnection::write(const std::string& bytes) {
  if (::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) return;
}
bool RawConnection::closed_within(double seconds) {
  char room[4096];
  while (readable(socket_, seconds)) {
    if (::recv(socket_, room, sizeof room, 0) <= 0) return true;
  }
  return false;
}

struct Watcher::Impl {
  boost::asio::io_context io;
  websocket::stream<beast::tcp_stream> socket{io};
  beast::flat_buffer buffer;
  unsigned status = 0;
  bool ended = false;
};

Watcher::Watcher(const Client& client, const std::string& target) : impl_(std::make_unique<Impl>()) {
  using boost::asio::ip::tcp;
  const std::string host = "127.0.0.1:" + std::to_string(client.port);
  beast::error_code error;
  auto& lowest = beast::get_lowest_layer(impl_->socket);
  lowest.socket().connect(tcp::endpoint(boost::asio::ip::address_v4::loopback(), client.port), error);
  impl_->socket.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
    std::map<std::string, std::string> all = {{"Authorization", "Bearer " + client.token},
                                              {"Origin", "http://" + host}};
    for (const auto& [name, value] : client.headers) all[name] = value;
    for (const auto& [name, value] : all) {
      if (!value.empty()) request.set(name, value);
    }
  }));
  websocket::response_type response;
  const auto named = client.headers.find("Host");
  impl_->socket.handshake(response, named != client.headers.end() ? named->second : host, target, error);
  impl_->status = response.result_int();
}

Watcher::~Watcher() = default;
unsigned Watcher::status() const noexcept { return impl_->status; }

std::optional<Watcher::Message> Watcher::next(double seconds) {
  std::optional<Message> message;
  bool done = false;
  impl_->buffer.clear();
  impl_->socket.async_read(impl_->buffer, [&](beast::error_code error, std::size_t) {
    done = true;
    impl_->ended = error && error != boost::asio::error::operation_aborted;
    if (!error) message = Message{impl_->socket.got_binary(), beast::buffers_to_string(impl_->buffer.data())};
  });
  impl_->io.restart();
  impl_->io.run_for(std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::duration<double>(seconds)));
  if (!done) {
    beast::get_lowest_layer(impl_->socket).cancel();
    impl_->io.restart();
    impl_->io.run();
  }
  return message;
}

std::optional<nlohmann::ordered_json> Watcher::event(const std::string& name, double seconds) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < until) {
    const auto message = next(seconds);
    if (!message) return std::nullopt;
    if (message->binary) continue;
    auto json = message->json();
    if (json.value("event", "") == name) return json;
  }
  return std::nullopt;
}

bool Watcher::ended_within(double seconds) {
  while (next(seconds)) {
  }
  return impl_->ended;
}

bool Watcher::send(const std::string& text) {
  beast::error_code error;
  impl_->socket.text(true);
  impl_->socket.write(boost::asio::buffer(text), error);
  return !error;
}

}  // namespace ganglion::studio
